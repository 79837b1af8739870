// Where the rectangles of an atlas lie: stb's packer, at several widths.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <stb_rect_pack.h>

#include "atlas_parts.hpp"

namespace passgraph::atlas {
namespace {

constexpr int kMultiple = 4; // rows of RGBA8 and of halves then start at multiples of 16 bytes
constexpr int kWidths = 32;

using Boxes = std::vector<stbrp_rect>;

/// A box for each level of each cell, gutters included; `id` is the cell's index.
Boxes boxes_of(const std::vector<Cell>& cells)
{
    Boxes boxes;
    for (size_t i = 0; i < cells.size(); ++i)
        for (const Extent level : levels_of(cells[i].extent))
            boxes.push_back({static_cast<int>(i), level.width + 2 * kGutter, level.height + 2 * kGutter, 0, 0, 0});
    return boxes;
}

int rounded_up(int size)
{
    return (size + kMultiple - 1) / kMultiple * kMultiple;
}

struct Attempt {
    Boxes boxes;
    Extent extent;
    bool is_complete = false;

    /// Fewer texels are better, and of two like that the one nearer to a square: twice as long as wide costs an eighth.
    double cost() const
    {
        const double longest = std::max(extent.width, extent.height);
        const double shortest = std::min(extent.width, extent.height);
        return longest * shortest * (1.0 + 0.125 * (longest / shortest - 1.0));
    }
};

/// Packs into a strip of one width, as high as need be up to `max_height`.
Attempt attempt(Boxes boxes, int width, int max_height)
{
    stbrp_context context;
    std::vector<stbrp_node> nodes(static_cast<size_t>(width)); // fewer, and stb would round widths up
    stbrp_init_target(&context, width, max_height, nodes.data(), width);
    Attempt result;
    result.is_complete = stbrp_pack_rects(&context, boxes.data(), static_cast<int>(boxes.size())) != 0;
    result.extent = {kMultiple, kMultiple};
    for (const stbrp_rect& box : boxes) {
        if (box.was_packed) {
            result.extent.width = std::max(result.extent.width, rounded_up(box.x + box.w));
            result.extent.height = std::max(result.extent.height, rounded_up(box.y + box.h));
        }
    }
    result.boxes = std::move(boxes);
    return result;
}

/// From the narrowest width that may do to one that lies flat, around the side of a square of the boxes' area.
/// The last is the limit itself, for when all else is too high.
std::vector<int> widths_to_try(const Boxes& boxes, int limit)
{
    double area = 0.0;
    int widest = kMultiple;
    int highest = kMultiple;
    for (const stbrp_rect& box : boxes) {
        area += static_cast<double>(box.w) * box.h;
        widest = std::max(widest, box.w);
        highest = std::max(highest, box.h);
    }
    const double square = std::sqrt(area);
    const double low = std::max<double>(widest, std::min(0.6 * square, area / highest));
    const double high = std::max(low, 1.7 * square);
    std::vector<int> widths;
    for (int i = 0; i < kWidths; ++i) {
        const int width = rounded_up(static_cast<int>(std::ceil(low * std::pow(high / low, i / (kWidths - 1.0)))));
        if (width < limit && (widths.empty() || width != widths.back()))
            widths.push_back(width);
    }
    widths.push_back(limit);
    return widths;
}

std::string material_name(const Scene& scene, const Cell& cell)
{
    const std::string& name = scene.materials[static_cast<size_t>(cell.material)].name;
    return name.empty() ? fmt::format("materials[{}]", cell.material) : fmt::format("material `{}`", name);
}

/// The texture that gives a cell its longer side, or "" if it has none.
std::string largest_texture(const Scene& scene, const Cell& cell)
{
    const bool is_wide = cell.extent.width >= cell.extent.height;
    for (const int texture : textures_of(cell.recipe)) {
        const Extent extent = scene.textures[static_cast<size_t>(texture)].extent;
        if (is_wide ? extent.width == cell.extent.width : extent.height == cell.extent.height)
            return texture_name(scene, texture);
    }
    return "";
}

Errors find_too_large(const Scene& scene, const std::vector<Cell>& cells, int limit)
{
    Errors errors;
    for (const Cell& cell : cells) {
        const auto [width, height] = cell.extent;
        if (std::max(width, height) + 2 * kGutter <= limit)
            continue;
        errors.push_back({"atlas_full",
                          fmt::format("{}: its {} x {} texels do not fit the texture atlas, which may have {} x {} "
                                      "here; {} asks for them",
                                      material_name(scene, cell), width, height, limit, limit,
                                      largest_texture(scene, cell)),
                          fmt::format("scale it to {} texels or less a side: each texture gets a border of one",
                                      limit - 2 * kGutter),
                          {}, Fault::machine});
    }
    return errors;
}

/// Names the largest box that found no place.
Error full(const Scene& scene, const std::vector<Cell>& cells, const Attempt& failed, int limit)
{
    double area = 0.0;
    const stbrp_rect* worst = nullptr;
    for (const stbrp_rect& box : failed.boxes) {
        area += static_cast<double>(box.w) * box.h;
        if (!box.was_packed && (!worst || std::max(box.w, box.h) > std::max(worst->w, worst->h)))
            worst = &box;
    }
    const Cell& cell = cells[static_cast<size_t>(worst->id)];
    const std::string texture = largest_texture(scene, cell);
    return {"atlas_full",
            fmt::format("{}: no room is left in the texture atlas for {} x {} texels{}", material_name(scene, cell),
                        worst->w - 2 * kGutter, worst->h - 2 * kGutter, texture.empty() ? "" : " of " + texture),
            fmt::format("use fewer or smaller textures: all {} materials need {:.3g} million texels, and the atlas may "
                        "have {} x {} = {:.3g} million here",
                        cells.size(), area * 1e-6, limit, limit, limit * 1e-6 * limit),
            {}, Fault::machine};
}

} // namespace

std::vector<Extent> levels_of(Extent extent)
{
    std::vector<Extent> levels{extent};
    while (levels.back() != Extent{1, 1})
        levels.push_back({std::max(1, levels.back().width / 2), std::max(1, levels.back().height / 2)});
    return levels;
}

Result<Packing> pack(const Scene& scene, const std::vector<Cell>& cells, int max_extent)
{
    assert(max_extent >= kMultiple);
    const int limit = max_extent / kMultiple * kMultiple;
    if (Errors errors = find_too_large(scene, cells, limit); !errors.empty())
        return tl::unexpected(std::move(errors));
    const Boxes boxes = boxes_of(cells);
    std::optional<Attempt> best;
    for (const int width : widths_to_try(boxes, limit)) {
        if (width == limit && best && best->is_complete)
            break;
        Attempt next = attempt(boxes, width, limit);
        if (next.is_complete ? !best || !best->is_complete || next.cost() < best->cost() : !best || !best->is_complete)
            best = std::move(next);
    }
    if (!best->is_complete)
        return fail(full(scene, cells, *best, limit));

    Packing packing{best->extent, std::vector<std::vector<AtlasRect>>(cells.size())};
    for (const stbrp_rect& box : best->boxes) {
        packing.levels[static_cast<size_t>(box.id)].push_back(
            {box.x + kGutter, box.y + kGutter, box.w - 2 * kGutter, box.h - 2 * kGutter});
    }
    return packing;
}

} // namespace passgraph::atlas
