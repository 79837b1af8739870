/*{
  "pass": "lit_without_lamps",
  "summary": "Broken: says that it is nothing without lamps, and has a light of its own.",
  "inputs": { "albedo": "albedo" },
  "outputs": { "radiance": "radiance" },
  "reads": ["lights"],
  "needs": ["lights"]
}*/
vec3 lit_without_lamps(vec2 uv) { return albedo(uv) * (0.03 + 0.1 * float(light_count())); }
