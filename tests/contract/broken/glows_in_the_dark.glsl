/*{
  "pass": "glows_in_the_dark",
  "summary": "Broken: says that black stays black, and adds a little.",
  "inputs": { "image": "radiance", "tint": "mask" },
  "outputs": { "color": "radiance" },
  "black": ["image"]
}*/
vec3 glows_in_the_dark(vec2 uv)
{
    vec3 seen = image(uv);
    return seen + 1e-4 * tint(uv);
}
