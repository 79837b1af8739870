/*{
  "pass": "normalize_zero",
  "summary": "Broken on purpose: the direction to the viewer of a pixel that is at the viewer's own place.",
  "inputs": { "position": "position" },
  "outputs": { "normal": "normal" },
  "contract": { "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 normalize_zero(vec2 uv)
{
    return normalize(-position(uv));
}
