/*{
  "pass": "original_mirror",
  "summary": "The cube map as the original could show it: instead of the surface, and with reflect's arguments swapped.",
  "reads": ["camera"],
  "inputs": { "normal": "normal", "position": "position",
              "sky": { "signal": "radiance", "over": "sphere" } },
  "outputs": { "radiance": "radiance" },
  "source": "reconstructed from the description of the 2017 demo"
}*/
vec3 original_mirror(vec2 uv)
{
    vec3 seen = normalize(position(uv));
    return sky(world_from_view(reflect(normal(uv), seen)), 0.0); // reflect wants the incident vector first
}
