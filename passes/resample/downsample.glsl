/*{
  "pass": "downsample",
  "summary": "Halves a picture: each texel is the mean of the four it covers.",
  "inputs": { "image": { "signal": "color", "filter": "linear" } },
  "outputs": { "color": { "signal": "color", "size": { "of": "image", "scale": [1, 2] } } },
  "black": ["image"],
  "bound": "image * 1.0001", // weights sum to 1 as far as a filter's rounding goes
  "contract": {
    "non_finite": { "contained": 1 },
    "laws": ["constant", "black", "energy", "monotone", "mirror", "scale"]
  },
  "source": "the box filter"
}*/
vec3 downsample(vec2 uv)
{
    // The center of a halved texel is the corner between four, where the linear filter weighs each by 1/4. An odd size
    // is rounded up and sampled at the centers all the same: nothing shifts. Below 1/2, repeat instead of scaling more.
    return image(uv);
}
