/*{
  "pass": "naive_ggx",
  "summary": "Broken on purpose: the textbook's GGX peak, 0 / 0 where roughness is 0.",
  "inputs": { "material": "material" },
  "outputs": { "color": "radiance" },
  "contract": { "range": { "color": [0, "saturated"] }, "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 naive_ggx(vec2 uv)
{
    float roughness = material(uv).y;
    float alpha_squared = roughness * roughness * roughness * roughness;
    float n_dot_h = 1.0;
    float bracket = n_dot_h * n_dot_h * (alpha_squared - 1.0) + 1.0;
    return vec3(alpha_squared / (3.14159265 * bracket * bracket));
}
