// How cells wrap: as their textures do, and what if these disagree.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "atlas_parts.hpp"

namespace passgraph::atlas {
namespace {

struct Axis {
    int component; ///< of uv
    int Extent::*size;
    Wrap Texture::*texture_wrap;
    Wrap Cell::*cell_wrap;
};

constexpr std::array<Axis, 2> kAxes{{{0, &Extent::width, &Texture::wrap_u, &Cell::wrap_u},
                                     {1, &Extent::height, &Texture::wrap_v, &Cell::wrap_v}}};
constexpr std::array<const char*, 3> kWraps{"repeats", "mirrors", "clamps"}; // in Wrap's order

/// Two textures of a cell that wrap differently along an axis. One texel wraps into itself in every mode.
struct Dispute {
    int one = -1;
    int other = -1;
};

Dispute settle(const Scene& scene, Cell& cell, const Axis& axis)
{
    Dispute dispute;
    for (const int index : textures_of(cell.recipe)) {
        const Texture& texture = scene.textures[static_cast<size_t>(index)];
        if (texture.extent.*axis.size == 1)
            continue;
        if (dispute.one < 0) {
            dispute.one = index;
            cell.*axis.cell_wrap = texture.*axis.texture_wrap;
        } else if (texture.*axis.texture_wrap != cell.*axis.cell_wrap) {
            dispute.other = index;
            cell.*axis.cell_wrap = Wrap::clamp; // leaves [0, 1] alone, where the gutters hold what each texture wants
            break;
        }
    }
    return dispute;
}

/// A mesh of the cell that goes beyond [0, 1], where wrap modes show; half a texel may be an exporter's rounding.
const Mesh* find_outside(const Scene& scene, const Cells& cells, int cell, const Axis& axis)
{
    const Extent extent = cells.cells[static_cast<size_t>(cell)].extent;
    const float slack = 0.5f / static_cast<float>(extent.*axis.size);
    for (const Element& element : scene.elements) {
        const Mesh& mesh = scene.meshes[static_cast<size_t>(element.mesh)];
        if (cells.of_material[static_cast<size_t>(mesh.material)] != cell)
            continue;
        for (const Vertex& vertex : mesh.vertices)
            if (vertex.uv[axis.component] < -slack || vertex.uv[axis.component] > 1.0f + slack)
                return &mesh;
    }
    return nullptr;
}

} // namespace

Errors choose_wraps(const Scene& scene, Cells& cells)
{
    Errors errors;
    for (size_t i = 0; i < cells.cells.size(); ++i) {
        Cell& cell = cells.cells[i];
        for (const Axis& axis : kAxes) {
            const auto [one, other] = settle(scene, cell, axis);
            const Mesh* mesh = other < 0 ? nullptr : find_outside(scene, cells, static_cast<int>(i), axis);
            if (!mesh)
                continue;
            const auto verb = [&](int texture) {
                return kWraps[static_cast<size_t>(scene.textures[static_cast<size_t>(texture)].*axis.texture_wrap)];
            };
            errors.push_back({"texture_wraps_differ",
                              fmt::format("material `{}`: along {} {} {} and {} {}, and mesh `{}` goes beyond [0, 1]",
                                          scene.materials[static_cast<size_t>(cell.material)].name,
                                          axis.component == 0 ? "u" : "v", texture_name(scene, one), verb(one),
                                          texture_name(scene, other), verb(other), mesh->name),
                              "give the textures of a material one wrap mode, or keep its uv inside [0, 1]"});
        }
    }
    return errors;
}

} // namespace passgraph::atlas
