/*{
  "pass": "skips_too_much",
  "summary": "Broken: the condition forgets the knee.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "radiance" },
  "params": {
    "threshold": { "type": "float", "default": 1, "range": [0, 10] },
    "knee":      { "type": "float", "default": 0.5, "range": [0, 1] }
  },
  "black": ["image"],
  "skip": { "when": "image(uv).r <= threshold", "value": 0 }
}*/
vec3 skips_too_much(vec2 uv)
{
    vec3 seen = image(uv);
    return seen.r > threshold - threshold * knee ? seen : vec3(0.0);
}
