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

/// An atlas begins as zeros.
template <class Code> void fill(const AtlasRect& rect, Code code, Target<Code> target)
{
    if (code == 0)
        return;
    for (int y = rect.y - kGutter; y < rect.y + rect.height + kGutter; ++y)
        for (int x = rect.x - kGutter; x < rect.x + rect.width + kGutter; ++x)
            target.at(x, y) = code;
}

/// The texels, then the gutter's columns, then its rows, whose corners so come out wrapped along both axes.
template <class Code, class Encode>
void store(const Grid& grid, const AtlasRect& rect, const Encode& encode, Target<Code> target)
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

/// Often so: the alpha of an opaque texture, the metalness of stone.
bool is_constant(const Texture& texture, size_t component)
{
    for (size_t i = component; i < texture.rgba.size(); i += 4)
        if (texture.rgba[i] != texture.rgba[component])
            return false;
    return true;
}

template <class Code, class Encode>
void draw_channel(const Scene& scene, const Channel& channel, const std::vector<AtlasRect>& levels,
                  const Encode& encode, Target<Code> target)
{
    const auto index = static_cast<size_t>(channel.texture);
    const Texture* texture = channel.texture < 0 ? nullptr : &scene.textures[index];
    if (!texture || is_constant(*texture, channel.component)) {
        const float value =
            texture ? value_of(*texture, channel, texture->rgba[channel.component]) : channel.factor;
        for (const AtlasRect& rect : levels)
            fill(rect, encode(value), target);
        return;
    }
    Grid grid = load(*texture, channel);
    for (const AtlasRect& rect : levels) {
        const Extent extent{rect.width, rect.height};
        grid = rect == levels.front() ? enlarged(std::move(grid), extent) : shrunk(grid, extent);
        store(grid, rect, encode, target);
    }
}

} // namespace

void draw_cell(const Scene& scene, const Cell& cell, const std::vector<AtlasRect>& levels, Atlas& atlas)
{
    static const SrgbCode srgb;
    const int width = atlas.extent.width;
    const auto channel_of = [&](auto& image, size_t channel) { return Target{image.data() + channel, width}; };
    const auto& [albedo, material, emissive] = cell.recipe;
    for (size_t c = 0; c < 3; ++c) {
        draw_channel(scene, albedo[c], levels, srgb, channel_of(atlas.albedo, c));
        draw_channel(scene, material[c], levels, LinearCode{}, channel_of(atlas.material, c));
        if (!atlas.emissive.empty())
            draw_channel(scene, emissive[c], levels, HalfCode{}, channel_of(atlas.emissive, c));
    }
    draw_channel(scene, albedo[3], levels, LinearCode{}, channel_of(atlas.albedo, 3));
}

} // namespace passgraph::atlas
