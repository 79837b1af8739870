// World to view space in double precision.
#include "gl/view_space.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <passgraph/scene/camera_matrices.hpp>
#include <passgraph/scene/facts.hpp>

namespace passgraph::gl {
namespace {

double largest_element(const glm::dmat3& m)
{
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(m[c][r]));
    return largest;
}

glm::dmat3 cofactors(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void store(std::array<float, 16>& to, const glm::dmat4& from)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            to[static_cast<size_t>(c * 4 + r)] = static_cast<float>(from[c][r]);
}

const AtlasCell& cell_of(const Scene& scene, const Atlas& atlas, const Element& element)
{
    return atlas.cells[static_cast<size_t>(scene.meshes[static_cast<size_t>(element.mesh)].material)];
}

glm::vec4 row(const glm::dmat3& m, int r, double w)
{
    return glm::vec4(glm::dvec4(m[0][r], m[1][r], m[2][r], w));
}

} // namespace

View view_of(const Camera& camera, Extent extent, bool has_clip_control)
{
    const CameraMatrices given = matrices(camera, extent);
    View view;
    view.rotation = glm::dmat3(given.view_from_world);
    view.position = camera.position;

    glm::dmat4 clip(given.clip_from_view);
    // View space of the ray through (ndc.x, ndc.y), where clip.w = 1.
    view.block.ray = {static_cast<float>(1.0 / clip[0][0]), static_cast<float>(1.0 / clip[1][1]),
                      static_cast<float>(clip[2][0] / clip[0][0]), static_cast<float>(clip[2][1] / clip[1][1])};
    view.block.range = {camera.near_plane, camera.far_plane, 0.0f, 0.0f};
    if (!has_clip_control)
        for (int c = 0; c < 4; ++c)
            clip[c][2] = 2.0 * clip[c][2] - clip[c][3];
    store(view.block.clip_from_view, clip);

    glm::dmat4 view_from_world(view.rotation);
    view_from_world[3] = glm::dvec4(-(view.rotation * view.position), 1.0);
    glm::dmat4 world_from_view(glm::transpose(view.rotation)); // a rotation's inverse
    world_from_view[3] = glm::dvec4(view.position, 1.0);
    store(view.block.view_from_world, view_from_world);
    store(view.block.world_from_view, world_from_view);
    return view;
}

bool same_camera(const Camera& a, const Camera& b)
{
    return a.position == b.position && a.direction == b.direction && a.up == b.up && a.vertical_fov == b.vertical_fov &&
           a.near_plane == b.near_plane && a.far_plane == b.far_plane;
}

bool is_mirrored(const glm::dmat3& matrix)
{
    const double largest = largest_element(matrix);
    return largest > 0.0 && glm::determinant(matrix / largest) < 0.0;
}

glm::dmat3 normal_matrix(const glm::dmat3& matrix)
{
    // Scaled before and after: the cofactors of a tiny or huge matrix would leave the range of single precision.
    const double largest = largest_element(matrix);
    if (!(largest > 0.0))
        return glm::dmat3(1.0);
    const glm::dmat3 cofactor = cofactors(matrix / largest);
    const double largest_cofactor = largest_element(cofactor);
    if (!(largest_cofactor > 0.0))
        return glm::dmat3(1.0);
    return cofactor / (is_mirrored(matrix) ? -largest_cofactor : largest_cofactor);
}

std::vector<glm::vec4> element_rows(const Scene& scene, const Atlas& atlas, const View& view)
{
    std::vector<glm::vec4> texels;
    texels.reserve(scene.elements.size() * glsl::kElementRows);
    for (const Element& element : scene.elements) {
        const glm::dmat4& world_from_model = element.world_from_model;
        const glm::dmat3 linear = view.rotation * glm::dmat3(world_from_model);
        // The difference first: both places may be a million metres from the origin.
        const glm::dvec3 place = view.rotation * (glm::dvec3(world_from_model[3]) - view.position);
        const glm::dmat3 normals = normal_matrix(linear);
        const AtlasCell& cell = cell_of(scene, atlas, element);
        for (int r = 0; r < 3; ++r)
            texels.push_back(row(linear, r, place[r]));
        for (int r = 0; r < 3; ++r)
            texels.push_back(row(normals, r, r == 0 && is_mirrored(linear) ? 1.0 : 0.0));
        const AtlasRect whole = cell.levels.empty() ? AtlasRect{0, 0, 1, 1} : cell.levels.front();
        texels.emplace_back(static_cast<float>(whole.width), static_cast<float>(whole.height),
                            static_cast<float>(std::max<size_t>(cell.levels.size(), 1) - 1),
                            static_cast<float>(static_cast<int>(cell.wrap_u) + 4 * static_cast<int>(cell.wrap_v)));
    }
    return texels;
}

std::vector<glm::vec4> element_levels(const Scene& scene, const Atlas& atlas)
{
    const glm::vec2 texel = 1.0f / glm::vec2(atlas.extent.width, atlas.extent.height);
    std::vector<glm::vec4> levels;
    levels.reserve(scene.elements.size() * glsl::kAtlasLevelCount);
    for (const Element& element : scene.elements) {
        const AtlasCell& cell = cell_of(scene, atlas, element);
        assert(cell.levels.size() <= glsl::kAtlasLevelCount);
        for (size_t i = 0; i < glsl::kAtlasLevelCount; ++i) {
            const AtlasRect rect = cell.levels.empty() ? AtlasRect{} : cell.levels[std::min(i, cell.levels.size() - 1)];
            levels.emplace_back(glm::vec2(rect.x, rect.y) * texel, glm::vec2(rect.width, rect.height) * texel);
        }
    }
    return levels;
}

float per_radius_squared(float radius)
{
    // Of the square as binary32 rounds it, and up by a few units: d = r then gives a product of at least 1 in a shader, even
    // one whose d * d has rounded down twice.
    const double squared = static_cast<double>(radius * radius);
    return static_cast<float>((1.0 + 4.0 / 16777216.0) / squared);
}

glm::vec4 cone_texel(const Light& light, const glm::dmat3& rotation)
{
    const glm::dvec3 axis = rotation * glm::dvec3(light.direction);
    const double length = glm::length(axis);
    if (light.kind != Light::Kind::spot || !(length > 0.0)) // without an axis there is no cone: it shines all around
        return {0.0f, 0.0f, 0.0f, 1.0f};
    const double inner = std::cos(static_cast<double>(std::min(light.inner_angle, light.outer_angle)));
    const double outer = std::cos(static_cast<double>(light.outer_angle));
    // A sharp edge is 1e-4 wide in the cosine, outwards from nothing at the outer angle: binary32 tells 600 steps of it.
    const double scale = 1.0 / std::max(inner - outer, 1e-4);
    return {glm::vec3(axis * (scale / length)), static_cast<float>(-outer * scale)};
}

std::vector<glm::vec4> light_texels(const Scene& scene, const std::vector<int>& order, const View& view)
{
    std::vector<glm::vec4> texels;
    texels.reserve(order.size() * glsl::kLightTexels);
    for (const int index : order) {
        const Light& light = scene.lights[static_cast<size_t>(index)];
        if (!shines(light)) {
            texels.insert(texels.end(), {glm::vec4(0.0f), glm::vec4(0.0f), {0.0f, 0.0f, 0.0f, 1.0f}});
            continue;
        }
        const bool is_near = light.kind != Light::Kind::directional;
        const glm::dvec3 place = is_near ? light.position - view.position : -glm::dvec3(light.direction);
        texels.emplace_back(light.color, is_near ? per_radius_squared(light.radius) : 0.0f);
        texels.emplace_back(glm::vec3(view.rotation * place), is_near ? 1.0f : 0.0f);
        texels.push_back(cone_texel(light, view.rotation));
    }
    return texels;
}

} // namespace passgraph::gl
