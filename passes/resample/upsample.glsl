/*{
  "pass": "upsample",
  "summary": "Doubles a picture, bilinearly.",
  "inputs": { "image": { "signal": "color", "filter": "linear" } },
  "outputs": { "color": { "signal": "color", "size": { "of": "image", "scale": [2, 1] } } },
  "black": ["image"],
  "bound": "image * 1.0001", // weights sum to 1 as far as a filter's rounding goes
  "contract": {
    "non_finite": { "contained": 1 },
    "laws": ["constant", "black", "energy", "monotone", "mirror", "scale"]
  },
  "source": "bilinear interpolation"
}*/
vec3 upsample(vec2 uv)
{
    return image(uv);
}
