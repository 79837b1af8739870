/*{
  "pass": "wrong_mirror",
  "summary": "Broken on purpose: one of the two offsets of a symmetric filter has the wrong sign.",
  "inputs": { "image": "color" },
  "outputs": { "color": "color" },
  "contract": { "non_finite": { "contained": 1 }, "laws": ["constant", "black", "mirror"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 wrong_mirror(vec2 uv)
{
    vec2 offset = vec2(image_texel().x, 0.0);
    return 0.5 * image(uv) + 0.25 * (image(uv + offset) + image(uv + offset));
}
