/*{
  "pass": "original_lighting",
  "summary": "Lighting with the original's terms: 5000 / d^2 without an end, V.H as a divisor, specular times N.V.",
  "reads": ["camera", "lights"],
  "inputs": { "albedo": "albedo", "material": "material", "normal": "normal", "position": "position",
              "emissive": { "signal": "radiance", "optional": true, "default": 0 } },
  "outputs": { "radiance": "radiance" },
  "choices": { "normals": ["given", "sphere_map"] },
  "source": "reconstructed from the description of the 2017 demo; sphere map: Crytek 2009, A bit more deferred"
}*/
const float pi = 3.14159265;

/// The original fed world-space normals to a formula of view space; at x = y = 0 the first line divides 0 by 0.
vec3 stored_and_read(vec3 n)
{
    vec2 code = normalize(n.xy) * sqrt(0.5 - 0.5 * n.z);
    code = 0.5 * code + 0.5;
    vec3 read = vec3(2.0 * code - 1.0, 1.0);
    float l = dot(read, vec3(-read.xy, 1.0));
    return vec3(read.xy * sqrt(l), l) * 2.0 - vec3(0.0, 0.0, 1.0);
}

float ggx(float n_dot_h, float roughness)
{
    float a2 = roughness * roughness * roughness * roughness;
    float d = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
    return a2 / (pi * d * d);
}

vec3 lit_by(Light lamp, vec3 place, vec3 n, vec3 v, vec3 base, vec3 matter)
{
    vec3 way = lamp.position - place * lamp.nearness; // of a directional light, against its direction
    // The lamp's color there was at most 1, and 5000 what we have in the color itself.
    float attenuation = lamp.nearness > 0.0 ? 1.0 / dot(way, way) : 1.0;
    vec3 l = normalize(way);
    vec3 h = normalize(v + l);
    float n_dot_l = max(dot(n, l), 0.0);
    float n_dot_v = dot(n, v);
    float n_dot_h = dot(n, h);
    vec3 f0 = mix(vec3(0.08 * matter.x), base, matter.z);
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - dot(v, h), 5.0);
    float masking = min(1.0, min(2.0 * n_dot_h * n_dot_v / dot(v, h), 2.0 * n_dot_h * n_dot_l / dot(v, h)));
    vec3 specular = fresnel * ggx(n_dot_h, matter.y) * masking * n_dot_v; // times what it should be divided by
    return (base * (1.0 - matter.z) / pi + specular) * n_dot_l * lamp.color * attenuation;
}

vec3 original_lighting(vec2 uv)
{
    vec3 place = position(uv);
    vec3 n = normal(uv);
#if normals == normals_sphere_map
    n = view_from_world(stored_and_read(world_from_view(n)));
#endif
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count(); ++i)
        sum += lit_by(light(i), place, n, normalize(-place), albedo(uv), material(uv));
    return emissive(uv) + (dot(place, place) > 0.0 ? sum : vec3(0.0));
}
