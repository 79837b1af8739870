/*{
  "pass": "clamp_as_guard",
  "summary": "Broken on purpose: clamp of NaN is undefined, so it guards nothing.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "display" },
  "contract": { "non_finite": "replaced", "laws": ["black", "monotone", "mirror"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 clamp_as_guard(vec2 uv)
{
    vec3 seen = clamp(image(uv), 0.0, 65504.0);
    return seen / (1.0 + seen);
}
