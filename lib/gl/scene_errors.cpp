// What keeps a scene from being drawn.
#include <algorithm>

#include <fmt/format.h>

#include "gl/scene_buffers.hpp"

namespace passgraph::gl {
namespace {

bool is_index(int index, size_t count)
{
    return index >= 0 && static_cast<size_t>(index) < count;
}

void malformed(Errors& errors, std::string message)
{
    errors.push_back({.code = "scene_malformed", .message = std::move(message)});
}

void check_meshes(const Scene& scene, Errors& errors)
{
    for (const Mesh& mesh : scene.meshes) {
        if (!is_index(mesh.material, scene.materials.size()))
            malformed(errors,
                      fmt::format("mesh `{}` has material {} of {}", mesh.name, mesh.material, scene.materials.size()));
        const auto largest = std::max_element(mesh.indices.begin(), mesh.indices.end());
        if (largest != mesh.indices.end() && *largest >= mesh.vertices.size())
            malformed(errors, fmt::format("mesh `{}` has an index {} for {} vertices", mesh.name, *largest,
                                          mesh.vertices.size()));
        if (mesh.indices.size() % 3 != 0)
            malformed(errors,
                      fmt::format("mesh `{}` has {} indices, not three per triangle", mesh.name, mesh.indices.size()));
    }
}

void check_materials(const Scene& scene, Errors& errors)
{
    for (const Material& material : scene.materials)
        for (const int texture :
             {material.base_color_texture, material.metallic_roughness_texture, material.emissive_texture,
              material.specular_texture})
            if (texture != -1 && !is_index(texture, scene.textures.size()))
                malformed(errors, fmt::format("material `{}` has texture {} of {}", material.name, texture,
                                              scene.textures.size()));
}

void check_textures(const Scene& scene, const Limits& limits, Errors& errors)
{
    for (const Texture& texture : scene.textures) {
        const auto [width, height] = texture.extent;
        if (width > limits.texture_size || height > limits.texture_size)
            errors.push_back({.code = "texture_too_large",
                              .message = fmt::format("texture `{}` has {} x {} texels, the device takes {}",
                                                     texture.name, width, height, limits.texture_size),
                              .hint = "make the texture smaller",
                              .fault = Fault::machine});
        else if (width <= 0 || height <= 0 ||
                 texture.rgba.size() != static_cast<size_t>(width) * static_cast<size_t>(height) * 4)
            malformed(errors, fmt::format("texture `{}` has {} bytes for {} x {} RGBA texels", texture.name,
                                          texture.rgba.size(), width, height));
    }
}

void check_count(size_t count, int texels_each, std::string_view what, const Limits& limits, Errors& errors)
{
    const size_t most = static_cast<size_t>(limits.texture_buffer_texels / texels_each);
    if (count > most)
        errors.push_back({.code = "scene_too_large",
                          .message = fmt::format("the scene has {} {}, the device takes {}", count, what, most),
                          .hint = "merge or remove some",
                          .fault = Fault::machine});
}

} // namespace

Errors find_scene_errors(const Scene& scene, const Limits& limits)
{
    Errors errors;
    check_meshes(scene, errors);
    check_materials(scene, errors);
    check_textures(scene, limits, errors);
    for (const Element& element : scene.elements)
        if (!is_index(element.mesh, scene.meshes.size()))
            malformed(errors,
                      fmt::format("element `{}` has mesh {} of {}", element.name, element.mesh, scene.meshes.size()));
    check_count(scene.lights.size(), glsl::kLightTexels, "lights", limits, errors);
    return errors;
}

} // namespace passgraph::gl
