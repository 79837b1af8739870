/*{
  "pass": "clamp_as_guard_unstated",
  "summary": "Broken on purpose: clamp of NaN is undefined, so it guards nothing; no contract says so.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "display" },
  "source": "a mistake seen in many renderers"
}*/
vec3 clamp_as_guard_unstated(vec2 uv)
{
    vec3 seen = clamp(image(uv), 0.0, 65504.0);
    return seen / (1.0 + seen);
}
