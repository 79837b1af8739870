// Uploading of a scene.
#include "gl/scene_buffers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

static_assert(sizeof(Vertex) == 32, "vertices are uploaded as they lie in memory");

template <class T> GLsizeiptr byte_count(const std::vector<T>& values)
{
    return static_cast<GLsizeiptr>(values.size() * sizeof(T));
}

void attribute(const Functions& gl, unsigned location, int components, size_t offset)
{
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                           reinterpret_cast<const void*>(offset));
}

MeshBuffers create_mesh(Upload& upload, const Mesh& mesh)
{
    const Functions& gl = upload.driver.gl;
    MeshBuffers buffers{.vertex_array = VertexArrayObject(upload.driver),
                        .vertices = BufferObject(upload.driver),
                        .indices = BufferObject(upload.driver),
                        .index_count = static_cast<GLsizei>(mesh.indices.size())};
    upload.state.vertex_array(buffers.vertex_array.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers.vertices.id());
    gl.BufferData(GL_ARRAY_BUFFER, byte_count(mesh.vertices), mesh.vertices.data(), GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices.id());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, byte_count(mesh.indices), mesh.indices.data(), GL_STATIC_DRAW);
    attribute(gl, glsl::kPositionLocation, 3, offsetof(Vertex, position));
    attribute(gl, glsl::kNormalLocation, 3, offsetof(Vertex, normal));
    attribute(gl, glsl::kUvLocation, 2, offsetof(Vertex, uv));
    return buffers;
}

AtlasTextures create_atlas(Upload& upload, Samplers& samplers, const Atlas& atlas)
{
    constexpr std::uint16_t kBlack[] = {0, 0, 0, 0};
    upload.watch.enter("the texture atlas");
    AtlasTextures textures{
        .albedo = create_filled(upload, Format::srgb8_a8, atlas.extent, atlas.albedo.data()),
        .material = create_filled(upload, Format::rgba8, atlas.extent, atlas.material.data()),
        .emissive = atlas.emissive.empty() ? create_filled(upload, Format::rgba16f, {1, 1}, kBlack)
                                           : create_filled(upload, Format::rgba16f, atlas.extent, atlas.emissive.data()),
        .sampler = samplers.get(Filter::linear, AddressMode::clamp, AddressMode::clamp, false)};
    upload.watch.check();
    upload.watch.leave();
    return textures;
}

std::vector<ElementDraw> draws_of(const Scene& scene)
{
    std::vector<ElementDraw> draws;
    for (size_t i = 0; i < scene.elements.size(); ++i) {
        const Element& element = scene.elements[i];
        const Mesh& mesh = scene.meshes[static_cast<size_t>(element.mesh)];
        const Material& material = scene.materials[static_cast<size_t>(mesh.material)];
        if (mesh.indices.empty())
            continue;
        draws.push_back({.is_double_sided = material.is_double_sided,
                         .is_mirrored = is_mirrored(glm::dmat3(element.world_from_model)),
                         .mesh = element.mesh,
                         .element = static_cast<int>(i),
                         .box = bounds(scene, element)});
    }
    return draws;
}

/// To the box's farthest place, squared.
double farthest(const Bounds& box, const glm::dvec3& viewer)
{
    const glm::dvec3 reach = glm::max(glm::abs(glm::dvec3(box.low) - viewer), glm::abs(glm::dvec3(box.high) - viewer));
    const double squared = glm::dot(reach, reach);
    return std::isfinite(squared) ? squared : std::numeric_limits<double>::infinity();
}

/// What ends first hides what reaches beyond it, like a ground that begins at the viewer's feet. Equally far ones stand next to those
/// that share their state.
void sort_front_to_back(std::vector<ElementDraw>& draws, const glm::dvec3& viewer)
{
    for (ElementDraw& draw : draws)
        draw.distance = farthest(draw.box, viewer);
    const auto key = [](const ElementDraw& draw) {
        return std::tie(draw.distance, draw.is_double_sided, draw.mesh, draw.is_mirrored, draw.element);
    };
    std::sort(draws.begin(), draws.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

BufferTexture create_buffer_texture(Upload& upload, size_t texels)
{
    const Functions& gl = upload.driver.gl;
    BufferTexture made{.buffer = BufferObject(upload.driver), .texture = TextureObject(upload.driver)};
    gl.BindBuffer(GL_TEXTURE_BUFFER, made.buffer.id());
    // Never empty: a step may have the sampler though there is nothing to fetch.
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(std::max<size_t>(texels, 1) * sizeof(glm::vec4)), nullptr,
                  GL_DYNAMIC_DRAW);
    upload.state.edit_texture(GL_TEXTURE_BUFFER, made.texture.id());
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, made.buffer.id());
    return made;
}

void fill(const Functions& gl, const BufferTexture& target, const std::vector<glm::vec4>& texels)
{
    if (texels.empty())
        return;
    gl.BindBuffer(GL_TEXTURE_BUFFER, target.buffer.id());
    // New storage: the frame in flight keeps reading the old one, and softpipe forgets what it cached of it.
    gl.BufferData(GL_TEXTURE_BUFFER, byte_count(texels), nullptr, GL_DYNAMIC_DRAW);
    gl.BufferSubData(GL_TEXTURE_BUFFER, 0, byte_count(texels), texels.data());
}

} // namespace

Result<SceneBuffers> create_scene_buffers(Upload& upload, Samplers& samplers, const Scene& scene, SceneImages::Impl images)
{
    SceneBuffers buffers;
    if (images.sky)
        buffers.sky = upload_cube(upload, *images.sky);
    for (const Mesh& mesh : scene.meshes) {
        upload.watch.enter(fmt::format("mesh `{}`", mesh.name));
        buffers.meshes.push_back(mesh.indices.empty() ? MeshBuffers{} : create_mesh(upload, mesh));
        upload.watch.check();
        upload.watch.leave();
    }
    buffers.atlas = create_atlas(upload, samplers, images.atlas);
    buffers.element_levels = element_levels(scene, images.atlas);
    buffers.places = {.extent = images.atlas.extent, .albedo = {}, .material = {}, .emissive = {}, .cells = std::move(images.atlas.cells)};
    buffers.draws = draws_of(scene);
    buffers.element_rows.resize(scene.elements.size() * glsl::kElementRows); // a plan may be warmed up before any camera
    buffers.facts = images.facts;
    buffers.light_order = std::move(images.lights);
    buffers.light_rows.resize(glsl::kFewLights * glsl::kLightTexels);
    buffers.lights = create_buffer_texture(upload, buffers.light_order.size() * glsl::kLightTexels);
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return buffers;
}

void upload_view(Upload& upload, SceneBuffers& buffers, const Scene& scene, const View& view)
{
    sort_front_to_back(buffers.draws, view.position);
    buffers.element_rows = element_rows(scene, buffers.places, view);
    buffers.light_rows = light_texels(scene, buffers.light_order, view);
    fill(upload.driver.gl, buffers.lights, buffers.light_rows);
    buffers.light_rows.resize(std::max<size_t>(buffers.light_rows.size(), glsl::kFewLights * glsl::kLightTexels));
}

} // namespace passgraph::gl
