/*{
  "pass": "output_above_range",
  "summary": "Broken on purpose: leaves it to the store to cut off what is above white.",
  "inputs": { "image": "display" },
  "outputs": { "color": "display" },
  "params": { "gain": { "type": "float", "default": 1, "range": [0, 2] } },
  "contract": { "non_finite": "contained", "laws": ["black", "monotone"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 output_above_range(vec2 uv)
{
    return image(uv) * gain;
}
