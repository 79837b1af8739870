/*{
  "pass": "gbuffer",
  "summary": "Draws the scene's surfaces and stores what lighting needs to know of each pixel.",
  "kind": "geometry",
  "reads": ["elements"],
  "outputs": { "albedo": "albedo", "material": "material", "normal": "normal", "position": "position",
               "depth": "depth", "emissive": "radiance" },
  "layouts": {
    "four_target": { "albedo": "srgb8_a8", "material": "rgba8", "normal": "octahedral_rg16", "position": "rgba32f",
                     "depth": "depth32f", "emissive": "r11f_g11f_b10f" }
  },
  "source": "Saito and Takahashi 1990, Comprehensible Rendering of 3-D Shapes"
}*/
#include "unit_vector.glsl"

void gbuffer_vertex(vec3 position, vec3 normal, vec2 texcoord, out vec3 placed, out vec3 facing, out vec2 uv)
{
    placed = element_to_view(position);
    // Length 1 at each vertex, whatever the element's scale, so that all weigh the same between them; 0 says "none".
    facing = unit_vector_or(element_normal_to_view(normal), vec3(0.0));
    uv = texcoord;
}

void gbuffer_surface(vec3 placed, vec3 facing, vec2 uv, out vec3 albedo, out vec3 material, out vec3 normal,
                     out vec3 position, out vec3 emissive)
{
    // A mesh without normals, or opposite ones that meet between vertices, has no direction there: it faces the viewer.
    // 1e-6 of a unit normal's length is what rounding leaves of two that cancel.
    float squared = dot(facing, facing);
    vec3 front = element_is_back_facing() ? -facing : facing;
    normal = squared > 1e-12 ? front * inversesqrt(squared) : unit_vector_or(-placed, vec3(0.0, 0.0, 1.0));

    albedo = element_base_color(uv).rgb;
    material = vec3(element_specular(), element_roughness_metallic(uv));
    position = placed;
    emissive = element_emissive(uv);
}
