/*{
  "pass": "slightly_negative",
  "summary": "Broken: takes a black level away and stops nowhere.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "radiance" }
}*/
vec3 slightly_negative(vec2 uv) { return image(uv) - 0.01; }
