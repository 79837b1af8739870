/*{
  "pass": "gbuffer",
  "summary": "Draws the scene's surfaces and stores what lighting needs to know of each pixel.",
  "kind": "geometry",
  "reads": ["elements"],
  "outputs": { "albedo": "albedo", "material": "material", "normal": "normal", "position": "position",
               "depth": "depth", "atlas_uv": "atlas_uv", "emissive": "radiance" },
  "layouts": {
    // The place in the atlas stands for all that the surface is made of; depth and a view ray for where it is.
    "two_target": {
      "targets": { "surface": "rgba16" },
      "normal": "surface.xy : octahedral_rg16", "atlas_uv": "surface.zw : rg16", "depth": "depth32f",
      "position": "from position_from_depth",
      "albedo": "from surface_from_atlas", "material": "from surface_from_atlas", "emissive": "from surface_from_atlas"
    },
    // The 2017 demo's redesign: its depth is a distance in a color target, its normals a sphere map.
    "three_target": {
      "targets": { "shape": "rgba32f" },
      "atlas_uv": "rg16", "normal": "shape.xy : sphere_map_rg32f", "depth": "shape.z : linear_r32f",
      "position": "rgba32f",
      "albedo": "from surface_from_atlas", "material": "from surface_from_atlas", "emissive": "from surface_from_atlas"
    },
    // What blending prevented there: specular, roughness and metallic in the three alphas.
    "packed_alpha": {
      "targets": { "diffuse": "srgb8_a8", "facing": "rgba16f", "place": "rgba32f" },
      "albedo": "diffuse.rgb", "normal": "facing.rgb", "position": "place.rgb",
      "material": "diffuse.a, facing.a, place.a",
      "depth": "depth32f", "emissive": "r11f_g11f_b10f"
    },
    "four_target": {
      "albedo": "srgb8_a8", "material": "rgba8", "normal": "octahedral_rg16", "position": "rgba32f",
      "depth": "depth32f", "emissive": "r11f_g11f_b10f"
    }
  },
  "bound": { "emissive": "emission" },
  "contract": { "non_finite": "contained" },
  "source": "Saito and Takahashi 1990, Comprehensible Rendering of 3-D Shapes"
}*/
#include "atlas.glsl"
#include "unit_vector.glsl"

/// `uv` leaves in texels of the element's largest level, so that its gradients are those of a level's texels.
void gbuffer_vertex(vec3 position, vec3 normal, vec2 texcoord, out vec3 placed, out vec3 facing, out vec2 uv)
{
    placed = element_to_view(position);
    // Length 1 at each vertex, whatever the element's scale, so that all weigh the same between them; 0 says "none".
    facing = unit_vector_or(element_normal_to_view(normal), vec3(0.0));
    uv = texcoord * element_texels();
}

/// The level is chosen from the gradients of the unwrapped uv: they do not jump where a texture repeats.
vec2 place_in_atlas(vec2 texels)
{
    int level = atlas_level(dFdx(texels), dFdy(texels), element_last_level());
    vec2 whole = texels / element_texels();
    ivec2 wrap = element_wrap();
    return atlas_place(element_level(level), vec2(atlas_wrap(whole.x, wrap.x), atlas_wrap(whole.y, wrap.y)));
}

void gbuffer_surface(vec3 placed, vec3 facing, vec2 uv, out vec3 albedo, out vec3 material, out vec3 normal,
                     out vec3 position, out vec2 atlas_uv, out vec3 emissive)
{
    // A mesh without normals, or opposite ones that meet between vertices, has no direction there: it faces the screen.
    // 1e-6 of a unit normal's length is what rounding leaves of two that cancel.
    float squared = dot(facing, facing);
    vec3 front = element_is_back_facing() ? -facing : facing;
    normal = squared > 1e-12 ? front * inversesqrt(squared) : vec3(0.0, 0.0, 1.0);
    position = placed;

    atlas_uv = place_in_atlas(uv);
    albedo = element_albedo(atlas_uv);
    material = element_material(atlas_uv);
    emissive = element_emissive(atlas_uv);
}
