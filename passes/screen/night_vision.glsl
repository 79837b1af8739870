/*{
  "pass": "night_vision",
  "summary": "Shows a picture as an image intensifier does: in shades of green.",
  "inputs":  { "image": "display" },
  "outputs": { "color": "display" },
  "params":  { "tint": { "type": "color", "default": [0.40, 0.79, 0.11], "range": [0, 1] },
               "amount": { "type": "float", "default": 1.0, "range": [0, 1] } },
  "identity": { "when": "amount == 0", "is": "image" },
  "black": ["image"],
  "contract": { "non_finite": "contained", "laws": ["black", "energy", "monotone", "mirror", "scale"] },
  "source":  "the 2017 demo"
}*/
vec3 night_vision(vec2 uv)
{
    vec3 seen = image(uv);
    return mix(seen, seen * tint, amount);
}
