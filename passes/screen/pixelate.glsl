/*{
  "pass": "pixelate",
  "summary": "Shows a picture in square cells of one color, counted from the bottom left.",
  "inputs": { "image": "color" },
  "outputs": { "color": "color" },
  "params": { "cell": { "type": "float", "default": 8, "range": [1, 512], "unit": "texels" } },
  "identity": { "when": "cell == 1", "is": "image" },
  "black": ["image"],
  "contract": { "non_finite": { "contained": "cell" }, "laws": ["constant", "black", "energy", "monotone", "scale"] },
  "source": "the 2017 demo"
}*/
vec3 pixelate(vec2 uv)
{
    vec2 extent = vec2(image_size());
    vec2 texel_center = floor(uv * extent) + 0.5; // exact, so that one on a fractional cell's border stays with its row
    vec2 low = floor(texel_center / cell) * cell;
    vec2 high = min(low + cell, extent); // the last cells may be partial: their center is that of what is left
    vec2 middle = 0.5 * (low + high);
    // The center of a cell of even size lies between texels. Four nearest reads a quarter texel around it are what a
    // linear filter would give there, and exactly the texel itself where the center is a texel's: cells of 1 change no bit.
    vec2 a = (middle - 0.25) * image_texel();
    vec2 b = (middle + 0.25) * image_texel();
    return 0.25 * ((image(a) + image(b)) + (image(vec2(a.x, b.y)) + image(vec2(b.x, a.y))));
}
