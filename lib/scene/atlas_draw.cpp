// Writes a cell's levels into the atlas's images, each with its gutter.
#include "atlas_codes.hpp"
#include "atlas_parts.hpp"

namespace passgraph::atlas {
namespace {

/// One channel of an image of the atlas.
template <class Code> struct Target {
    Code* first;
    int width;

    Code& at(int x, int y) const
    {
        return first[4 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x))];
    }
};

template <class Code> void fill(const AtlasRect& rect, Code code, Target<Code> target)
{
    for (int y = rect.y - kGutter; y < rect.y + rect.height + kGutter; ++y)
        for (int x = rect.x - kGutter; x < rect.x + rect.width + kGutter; ++x)
            target.at(x, y) = code;
}

/// The texels, then the gutter's columns, then its rows, whose corners so come out wrapped along both axes.
template <class Code, class Encode>
void store(const Grid& grid, const AtlasRect& rect, Encode encode, Target<Code> target)
{
    const auto [width, height] = grid.extent;
    for (int y = 0; y < height; ++y) {
        const float* row = grid.row(y);
        for (int x = 0; x < width; ++x)
            target.at(rect.x + x, rect.y + y) = encode(row[x]);
        for (const int x : {-1, width})
            target.at(rect.x + x, rect.y + y) = target.at(rect.x + wrapped_index(x, width, grid.wrap_u), rect.y + y);
    }
    for (const int y : {-1, height})
        for (int x = -1; x <= width; ++x)
            target.at(rect.x + x, rect.y + y) = target.at(rect.x + x, rect.y + wrapped_index(y, height, grid.wrap_v));
}

template <class Code, class Encode>
void draw_channel(const Scene& scene, const Channel& channel, const std::vector<AtlasRect>& levels, Encode encode,
                  Target<Code> target)
{
    if (channel.texture < 0) {
        for (const AtlasRect& rect : levels)
            fill(rect, encode(channel.factor), target);
        return;
    }
    const Texture& texture = scene.textures[static_cast<size_t>(channel.texture)];
    Grid grid = load(texture, channel.component, channel.factor);
    for (const AtlasRect& rect : levels) {
        const Extent extent{rect.width, rect.height};
        grid = rect == levels.front() ? enlarged(std::move(grid), extent) : shrunk(grid, extent);
        store(grid, rect, encode, target);
    }
}

} // namespace

void draw_cell(const Scene& scene, const Cell& cell, const std::vector<AtlasRect>& levels, Atlas& atlas)
{
    const int width = atlas.extent.width;
    for (size_t c = 0; c < 4; ++c) {
        const Target<std::uint8_t> albedo{atlas.albedo.data() + c, width};
        if (c < 3)
            draw_channel(scene, cell.recipe.albedo[c], levels, srgb_code, albedo);
        else
            draw_channel(scene, cell.recipe.albedo[c], levels, linear_code, albedo);
        const Target<std::uint8_t> material{atlas.material.data() + c, width};
        draw_channel(scene, cell.recipe.material[c], levels, linear_code, material);
        if (!atlas.emissive.empty()) {
            const Target<std::uint16_t> emissive{atlas.emissive.data() + c, width};
            draw_channel(scene, cell.recipe.emissive[c], levels, half_code, emissive);
        }
    }
}

} // namespace passgraph::atlas
