/*{
  "pass": "pbr_surface",
  "summary": "Lights the surfaces of a G-buffer, with a split-sum table for the sky's reflection: the heart of pbr.",
  "only_where": "depth",
  "reads": ["camera", "lights", "materials"],
  "inputs": {
    "albedo": "albedo",
    "material": "material",
    "normal": "normal",
    "position": "position",
    "emissive": { "signal": "radiance", "optional": true, "default": 0 },
    "sky": { "signal": "radiance", "over": "sphere", "levels": true, "optional": true, "default": 0 },
    "share": { "signal": "reflectance", "filter": "linear" }
  },
  "outputs": { "radiance": { "signal": "radiance", "size": { "of": "position" } } },
  "params": {
    "environment": { "type": "float", "default": 1, "range": [0, 8], "label": "Brightness of the sky's light" }
  },
  "choices": {
    "distribution": ["ggx", "beckmann"],
    "fresnel": ["schlick", "exact"],
    "geometry": ["smith_correlated", "smith_separable", "cook_torrance", "neumann", "implicit"]
  },
  "ladders": {
    "ggx_form": { "items": ["textbook", "difference_of_squares", "lagrange"], "default": "lagrange" },
    "fresnel_power": { "items": ["pow", "multiplications"], "default": "multiplications" },
    "beckmann_masking": { "items": ["rational", "erf"], "default": "erf" }
  },
  // Without the sky's light the table of its reflection is not read either.
  "ignores": { "sky": "environment == 0", "share": "environment == 0 || sky == 0" },
  // Diffuse light is 1/pi of what arrives at most, a highlight what the scene's smoothest surface makes of it; the geometry
  // terms without a masking of their own grow without end at grazing angles. A sky's irradiance, of harmonics of degree 2,
  // overshoots by less than half: 1 for its reflection, 1.5 for its diffuse light.
  "bound": "emissive + environment * sky * 2.5 + (irradiance == 0 ? 0 : geometry == geometry_cook_torrance || geometry == geometry_neumann ? 65504 : irradiance * (0.3184 + highlight))",
  "contract": {
    "range": { "radiance": [0, "saturated"] },
    "non_finite": { "contained": 0, "anywhere": ["share"] },
    // not "mirror": `share` is a table, and means something else turned around
    "laws": ["black", "monotone"]
  },
  "source": "Walter et al. 2007 (GGX), Heitz 2014 (Smith), Schlick 1994 (Fresnel), Karis 2013 (environment)"
}*/
#include "brdf.glsl"
#include "distribution.glsl"
#include "environment.glsl"
#include "lamp.glsl"
#include "saturated.glsl"

Terms chosen_terms()
{
    return Terms(distribution, fresnel, geometry, ggx_form, fresnel_power, beckmann_masking);
}

vec3 lit_by_lamps(Surface surface, vec3 place, vec3 n, vec3 v)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count(); ++i) {
        Light lamp = light(i);
        vec3 way = way_to(lamp, place);
        float squared = dot(way, way);
        vec3 l = squared > 1e-12 ? way * inversesqrt(squared) : n; // a lamp in the surface shines straight onto it
        sum += reflected(surface, n, v, l, chosen_terms()) * irradiance(lamp, squared, l);
    }
    return sum;
}

vec3 lit_by_sky(Surface surface, vec3 base, vec3 matter, vec3 n, vec3 v)
{
    float roughness = max(saturated(matter.y), smallest_roughness);
    vec2 reflects = share(reflectance_place(surface.n_dot_v, roughness, vec2(share_size())));
    vec3 mirrored = sky(world_from_view(2.0 * dot(n, v) * n - v), environment_lod(matter.y, sky_top_lod()));
    vec3 around = sky_irradiance(world_from_view(n)) * inverse_pi;
    // What the dielectric's lobe reflects of a uniform sky does not reach the ground below it.
    float entering =
        (1.0 - saturated(matter.z)) * saturated(1.0 - (surface.dielectric_f0 * reflects.x + reflects.y));
    return mirrored * (surface.f0 * reflects.x + reflects.y) + around * saturated(base) * entering;
}

vec3 pbr_surface(vec2 uv)
{
    vec3 place = position(uv);
    vec3 n = normal(uv);
    vec3 base = albedo(uv);
    vec3 matter = material(uv); // specular, roughness, metallic
    matter.z = materials_have_metal() ? matter.z : 0.0;
    float squared = dot(place, place);
    vec3 v = -place * inversesqrt(squared); // undefined where squared is 0, and not used there

    Surface surface = make_surface(base, matter, dot(n, v), chosen_terms());
    vec3 lit = lit_by_lamps(surface, place, n, v) + environment * lit_by_sky(surface, base, matter, n, v);
    // Nothing can be seen at the viewer's own place: there a pixel without geometry keeps its position of 0.
    return emissive(uv) + (squared > 0.0 ? lit : vec3(0.0));
}
