/*{
  "pass": "center_counted_twice",
  "summary": "Broken on purpose: a blur whose loop begins at the middle, which is added once more.",
  "inputs": { "image": "color" },
  "outputs": { "blurred": "color" },
  "contract": {
    "range": { "blurred": [0, "saturated"] },
    "non_finite": { "contained": 2 },
    "laws": ["constant", "black", "mirror"]
  },
  "source": "a mistake seen in many renderers"
}*/
vec3 center_counted_twice(vec2 uv)
{
    const float weights[3] = float[3](0.4, 0.2, 0.1);
    vec3 sum = image(uv) * weights[0];
    for (int i = 0; i < 3; ++i) {
        vec2 offset = vec2(float(i) * image_texel().x, 0.0);
        sum += 0.5 * (image(uv + offset) + image(uv - offset)) * weights[i] * (i == 0 ? 1.0 : 2.0);
    }
    return sum;
}
