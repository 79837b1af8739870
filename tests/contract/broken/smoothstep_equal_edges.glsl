/*{
  "pass": "smoothstep_equal_edges",
  "summary": "Broken on purpose: smoothstep is undefined where its edges meet, as these parameters may.",
  "inputs": { "image": "display" },
  "outputs": { "color": "display" },
  "params": {
    "inner": { "type": "float", "default": 0.2, "range": [0, 1] },
    "outer": { "type": "float", "default": 0.7, "range": [0, 1] }
  },
  "contract": { "non_finite": "contained", "laws": ["black", "mirror"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 smoothstep_equal_edges(vec2 uv)
{
    return image(uv) * (1.0 - smoothstep(inner, outer, length(uv - 0.5)));
}
