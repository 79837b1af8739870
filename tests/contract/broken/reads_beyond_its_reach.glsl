/*{
  "pass": "reads_beyond_its_reach",
  "summary": "Broken on purpose: says that a bad texel reaches one texel far, and reads five away.",
  "inputs": { "image": "color" },
  "outputs": { "color": "color" },
  "contract": { "non_finite": { "contained": 1 }, "laws": ["constant"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 reads_beyond_its_reach(vec2 uv)
{
    return 0.5 * (image(uv) + image(uv + vec2(5.0, 0.0) * image_texel()));
}
