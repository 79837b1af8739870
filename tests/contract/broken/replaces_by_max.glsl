/*{
  "pass": "replaces_by_max",
  "summary": "Broken on purpose: max(NaN, 0) is 0 on some devices and NaN on others.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "radiance" },
  "contract": { "non_finite": "replaced" },
  "source": "a mistake seen in many renderers"
}*/
vec3 replaces_by_max(vec2 uv)
{
    return min(max(image(uv), vec3(0.0)), vec3(65504.0));
}
