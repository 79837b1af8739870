/*{
  "pass": "bloom_combine",
  "summary": "Adds the glow of bright places to a picture; the glow may be smaller than the picture.",
  "inputs": { "scene": "radiance", "bloom": { "signal": "radiance", "filter": "linear" } },
  "outputs": { "color": { "signal": "radiance", "size": { "of": "scene" } } },
  "params": { "strength": { "type": "float", "default": 1, "range": [0, 8] } },
  "identity": { "when": "strength == 0 || bloom == 0", "is": "scene" },
  "black": ["scene", "bloom"],
  "contract": {
    "range": { "color": [0, "saturated"] },
    "non_finite": "contained",
    "laws": ["black", "energy", "monotone", "mirror", "scale"]
  },
  "source": "the 2017 demo"
}*/
vec3 bloom_combine(vec2 uv)
{
    return scene(uv) + strength * bloom(uv);
}
