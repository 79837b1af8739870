/*{
  "pass": "pbr",
  "summary": "Lights the surfaces of a G-buffer: by lamps, by the sky around them, and by what they emit.",
  "reads": ["camera", "lights"],
  "only_where": "depth",
  "inputs": {
    "albedo": "albedo",
    "material": "material",
    "normal": "normal",
    "position": "position",
    "emissive": { "signal": "radiance", "optional": true, "default": 0 },
    "sky": { "signal": "radiance", "over": "sphere", "levels": true, "optional": true, "default": 0 }
  },
  "outputs": { "radiance": "radiance" },
  "params": {
    "environment": { "type": "float", "default": 1, "range": [0, 8], "label": "Brightness of the sky's light" }
  },
  "source": "Walter et al. 2007 (GGX), Heitz 2014 (Smith), Schlick 1994 (Fresnel), Lazarov 2013 (environment)"
}*/
#include "brdf.glsl"
#include "environment.glsl"
#include "lamp.glsl"

vec3 lit_by_lamps(Surface surface, vec3 place, vec3 n, vec3 v)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count(); ++i) {
        Light lamp = light(i);
        vec3 way = way_to(lamp, place);
        float squared = dot(way, way);
        vec3 l = squared > 1e-12 ? way * inversesqrt(squared) : n; // a lamp in the surface shines straight onto it
        sum += reflected(surface, n, v, l) * irradiance(lamp, squared);
    }
    return sum;
}

vec3 lit_by_sky(Surface surface, vec3 base, vec3 matter, vec3 n, vec3 v)
{
    vec2 share = environment_reflectance(matter.y, surface.n_dot_v);
    vec3 mirrored = sky(world_from_view(reflect(-v, n)), environment_lod(surface.alpha_squared, sky_top_lod()));
    vec3 around = sky(world_from_view(n), sky_top_lod());
    float entering = (1.0 - matter.z) * (1.0 - (0.08 * matter.x * share.x + share.y));
    return mirrored * (surface.f0 * share.x + share.y) + around * base * entering;
}

vec3 pbr(vec2 uv)
{
    vec3 place = position(uv);
    vec3 n = normal(uv);
    vec3 base = albedo(uv);
    vec3 matter = material(uv); // specular, roughness, metallic
    float squared = dot(place, place);
    vec3 v = -place * inversesqrt(squared); // undefined where squared is 0, and not used there

    Surface surface = make_surface(base, matter, dot(n, v));
    vec3 lit = lit_by_lamps(surface, place, n, v) + environment * lit_by_sky(surface, base, matter, n, v);
    // Nothing can be seen at the viewer's own place: there a pixel without geometry keeps its position of 0.
    return emissive(uv) + (squared > 0.0 ? lit : vec3(0.0));
}
