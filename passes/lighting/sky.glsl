/*{
  "pass": "sky",
  "summary": "Shows the sky where no surface is.",
  "reads": ["camera"],
  "inputs": { "image": "radiance", "depth": "depth", "sky": { "signal": "radiance", "over": "sphere" } },
  "outputs": { "color": { "signal": "radiance", "size": { "of": "image" } } },
  "only_where": { "no_depth": "image" },
  "identity": { "when": "image_behind == 0 && (sky == 0 || intensity == 0)", "is": "image" },
  "bound": "max(image, intensity * sky)",
  "params": { "intensity": { "type": "float", "default": 1, "range": [0, 100] } },
  "black": ["image", "sky"],
  "contract": {
    "range": { "color": [0, "saturated"] },
    "non_finite": "contained",
    "laws": ["constant", "black", "energy", "monotone"]
  },
  "source": "Greene 1986, Environment Mapping and Other Applications of World Projections"
}*/
vec3 sky(vec2 uv)
{
    // Depth is reversed: 0 is the far end of everything, which only a cleared pixel has.
    return depth(uv) > 0.0 ? image(uv) : intensity * sky(world_from_view(view_ray(uv)), 0.0);
}
