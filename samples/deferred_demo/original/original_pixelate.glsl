/*{
  "pass": "original_pixelate",
  "summary": "A hundred by a hundred cells whatever the picture's shape, read with the linear filter at their corners.",
  "inputs": { "image": { "signal": "color", "filter": "linear" } },
  "outputs": { "color": "color" },
  "source": "reconstructed from the description of the 2017 demo"
}*/
vec3 original_pixelate(vec2 uv)
{
    return image(floor(uv * 100.0) / 100.0);
}
