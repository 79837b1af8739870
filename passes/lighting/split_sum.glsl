/*{
  "pass": "split_sum",
  "summary": "The share of a uniform environment that a surface reflects, by the angle it is seen at and its roughness.",
  "outputs": { "share": { "signal": "reflectance", "size": { "texels": [64, 64] } } },
  "choices": {
    "distribution": ["ggx", "beckmann"],
    "geometry": ["smith_correlated", "smith_separable", "cook_torrance", "neumann", "implicit"]
  },
  "ladders": {
    "fresnel_power": { "items": ["pow", "multiplications"], "default": "multiplications" },
    "beckmann_masking": { "items": ["rational", "erf"], "default": "erf" }
  },
  "contract": { "non_finite": "contained" },
  "source": "Karis 2013, Real Shading in Unreal Engine 4"
}*/
#include "brdf.glsl"
#include "distribution.glsl"
#include "environment.glsl"

vec2 split_sum(vec2 uv)
{
    Terms terms = Terms(distribution, fresnel_of_schlick, geometry, lagrange_form, fresnel_power, beckmann_masking);
    vec2 surface = reflectance_surface(uv, vec2(64.0));
    return environment_reflectance(surface.x, surface.y, terms);
}
