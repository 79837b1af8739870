/*{
  "pass": "surface_from_atlas",
  "summary": "What a surface is made of, read from the texture atlas at the place that the G-buffer names.",
  "inputs": {
    "atlas_uv": "atlas_uv",
    "atlas_albedo": { "signal": "albedo", "over": "table", "filter": "linear" },
    "atlas_material": { "signal": "material", "over": "table", "filter": "linear" },
    "atlas_emissive": { "signal": "radiance", "over": "table", "filter": "linear" }
  },
  "outputs": { "albedo": "albedo", "material": "material", "emissive": "radiance" },
  "black": { "albedo": ["atlas_albedo"], "material": ["atlas_material"], "emissive": ["atlas_emissive"] },
  "contract": { "non_finite": "contained", "laws": ["black"] },
  "source": "the 2017 demo's three-target layout"
}*/
void surface_from_atlas(vec2 uv, out vec3 albedo, out vec3 material, out vec3 emissive)
{
    vec2 place = atlas_uv(uv); // of the level that the geometry pass chose: no gradients are needed here
    albedo = atlas_albedo(place);
    material = atlas_material(place);
    emissive = place.x > 0.0 ? atlas_emissive(place) : vec3(0.0); // 0 is the border, where only empty pixels are
}
