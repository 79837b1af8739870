// All materials of a scene in one texture.
#include "passgraph/scene/atlas.hpp"

#include <algorithm>

#include "atlas_parts.hpp"

namespace passgraph {
namespace {

/// Zeros, and the material's fourth channel, which no cell writes.
Atlas blank(Extent extent, bool has_emission)
{
    const size_t texels = static_cast<size_t>(extent.width) * static_cast<size_t>(extent.height);
    Atlas atlas;
    atlas.extent = extent;
    atlas.albedo.resize(4 * texels);
    atlas.material.resize(4 * texels);
    for (size_t i = 3; i < atlas.material.size(); i += 4)
        atlas.material[i] = 255;
    if (has_emission)
        atlas.emissive.resize(4 * texels);
    return atlas;
}

bool emits(const atlas::Cell& cell)
{
    const auto& [red, green, blue] = cell.recipe.emissive;
    return red.factor > 0.0f || green.factor > 0.0f || blue.factor > 0.0f;
}

} // namespace

Result<Atlas> make_atlas(const Scene& scene, int max_extent)
{
    atlas::Cells found = atlas::find_cells(scene);
    if (Errors errors = atlas::choose_wraps(scene, found); !errors.empty())
        return tl::unexpected(std::move(errors));
    const std::vector<atlas::Cell>& cells = found.cells;
    const Result<atlas::Packing> packing = atlas::pack(scene, cells, max_extent);
    if (!packing)
        return tl::unexpected(packing.error());

    Atlas atlas = blank(packing->extent, std::any_of(cells.begin(), cells.end(), emits));
    for (size_t i = 0; i < cells.size(); ++i)
        atlas::draw_cell(scene, cells[i], packing->levels[i], atlas);
    for (const int index : found.of_material) {
        AtlasCell& cell = atlas.cells.emplace_back();
        if (index >= 0) {
            const auto at = static_cast<size_t>(index);
            cell = {packing->levels[at], cells[at].wrap_u, cells[at].wrap_v};
        }
    }
    return atlas;
}

} // namespace passgraph
