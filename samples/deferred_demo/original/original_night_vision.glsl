/*{
  "pass": "original_night_vision",
  "summary": "Green, minus a vignette: below zero towards the rim. Alpha is tinted and dimmed like a color.",
  "inputs": { "image": "display" },
  "outputs": { "color": "display" }, // which begins at 0, as the screen does: what was negative is black
  "source": "reconstructed from the description of the 2017 demo"
}*/
vec3 original_night_vision(vec2 uv)
{
    vec3 seen = image(uv) * vec3(0.40, 0.79, 0.11);
    return seen - smoothstep(0.5, 0.9, length(uv - 0.5) * 1.41421356);
}
