/*{
  "pass": "sky_over_everything",
  "summary": "Broken: says that surfaces stay as they are, and fogs them.",
  "inputs": { "image": "radiance", "depth": "depth" },
  "outputs": { "color": "radiance" },
  "only_where": { "no_depth": "image" }
}*/
vec3 sky_over_everything(vec2 uv) { return mix(image(uv), vec3(0.5), depth(uv) > 0.0 ? 0.001 : 1.0); }
