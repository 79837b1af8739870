/*{
  "pass": "downsample",
  "summary": "Makes a picture smaller, by half unless a graph scales it: each texel is the mean of those it covers.",
  "inputs": { "image": { "signal": "color", "filter": "linear", "once": true } },
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
    // A corner between four texels, where the linear filter weighs each by 1/4, for every two texels that a new one covers: 1 for
    // a half, 4 x 4 for an eighth. An odd size is rounded up and sampled at the same shares of it: nothing shifts.
    ivec2 count = max((image_size() + pixel_count()) / (2 * pixel_count()), ivec2(1));
    vec2 covered = 1.0 / vec2(pixel_count());
    vec3 sum = vec3(0.0);
    for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x)
            sum += image(uv + ((vec2(x, y) + 0.5) / vec2(count) - 0.5) * covered);
    return sum / float(count.x * count.y);
}
