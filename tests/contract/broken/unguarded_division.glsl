/*{
  "pass": "unguarded_division",
  "summary": "Broken on purpose: takes a color's hue by dividing by its luminance, which black has none of.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "display" },
  "contract": { "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 unguarded_division(vec2 uv)
{
    vec3 seen = image(uv);
    return seen / (seen.x + seen.y + seen.z);
}
