// The steps of making a texture atlas, in the order in which `make_atlas` takes them.
#pragma once

#include <array>
#include <compare>
#include <string>
#include <vector>

#include <passgraph/core/error.hpp>
#include <passgraph/scene/atlas.hpp>

namespace passgraph::atlas {

inline constexpr int kGutter = 1; ///< texels on each side: what a linear fetch reaches beyond a rectangle

/// Where one channel of a cell comes from: a channel of a texture, or 1 where there is none, times a factor.
struct Channel {
    int texture = -1;
    size_t component = 0;
    float factor = 0.0f;

    friend auto operator<=>(const Channel&, const Channel&) = default;
};

/// The channels of the atlas's three images: RGBA; specular, roughness, metallic; RGB.
struct Recipe {
    std::array<Channel, 4> albedo;
    std::array<Channel, 3> material;
    std::array<Channel, 3> emissive;

    friend auto operator<=>(const Recipe&, const Recipe&) = default;
};

/// A cell that has no place yet.
struct Cell {
    int material = 0; ///< the first of those that share it
    Recipe recipe;
    Extent extent;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
};

struct Cells {
    std::vector<Cell> cells;
    std::vector<int> of_material; ///< by index of Scene::materials; -1 for one that no element uses
};

/// One channel in linear light at one level, and how its texture wraps.
struct Grid {
    Extent extent;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    std::vector<float> values;

    const float* row(int y) const { return values.data() + static_cast<size_t>(y) * static_cast<size_t>(extent.width); }
    float* row(int y) { return values.data() + static_cast<size_t>(y) * static_cast<size_t>(extent.width); }
};

struct Packing {
    Extent extent;
    std::vector<std::vector<AtlasRect>> levels; ///< by cell
};

// atlas_cells.cpp: which cells there are
Cells find_cells(const Scene& scene);
/// The cell's textures, each once.
std::vector<int> textures_of(const Recipe& recipe);
/// "texture `x`", or "textures[3]" for one without a name.
std::string texture_name(const Scene& scene, int texture);

// atlas_wraps.cpp: how they wrap
/// Sets each cell's wrap modes from its textures'; reports those that no one mode can stand for.
Errors choose_wraps(const Scene& scene, Cells& cells);

// atlas_pack.cpp: where they are
/// From an extent down to one texel, sides halved and rounded down.
std::vector<Extent> levels_of(Extent extent);
Result<Packing> pack(const Scene& scene, const std::vector<Cell>& cells, int max_extent);

// atlas_grid.cpp: what is in them
/// The texel before the first (-1) or behind the last (`count`), and those between, as indices of texels that exist.
int wrapped_index(int index, int count, Wrap wrap);
/// What a code of the channel's texture stands for, in linear light, times the factor.
float value_of(const Texture& texture, const Channel& channel, std::uint8_t code);
Grid load(const Texture& texture, const Channel& channel);
Grid enlarged(Grid grid, Extent extent);
Grid shrunk(const Grid& grid, Extent extent);

// atlas_draw.cpp: as codes
void draw_cell(const Scene& scene, const Cell& cell, const std::vector<AtlasRect>& levels, Atlas& atlas);

} // namespace passgraph::atlas
