// One channel of a texture as numbers: decoded, enlarged, and averaged from level to level.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "atlas_codes.hpp"
#include "atlas_parts.hpp"

namespace passgraph::atlas {
namespace {

size_t area(Extent extent)
{
    return static_cast<size_t>(extent.width) * static_cast<size_t>(extent.height);
}

/// A texel of the result along one axis: the weighted sum of up to three neighbors of the source.
struct Taps {
    std::array<int, 3> index{};
    std::array<float, 3> weight{};
};

/// The average over the part of the source that each texel covers.  Between 2 and 3 texels wide, it begins i / n of a
/// texel after texel 2 i: with n = count / 2 an odd count is 2 n + 1, and (2 n + 1) / n * i = 2 i + i / n.
/// Every source texel gives the same in all, so the mean stays.
/// Source   Guthe and Heckbert 2005, "Non-power-of-two mipmap creation" (NVIDIA): the polyphase box filter.
std::vector<Taps> covering(int count, int result_count)
{
    if (count == result_count)
        return {};
    std::vector<Taps> taps(static_cast<size_t>(result_count));
    const double n = result_count;
    for (int i = 0; i < result_count; ++i) {
        const int first = 2 * i;
        const bool is_odd = count != 2 * result_count;
        const double before = is_odd ? i / n : 0.0;
        const double after = is_odd ? (i + 1) / n : 0.0;
        const double width = count / n;
        taps[static_cast<size_t>(i)] = {{first, first + 1, std::min(first + 2, count - 1)},
                                        {static_cast<float>((1.0 - before) / width), static_cast<float>(1.0 / width),
                                         static_cast<float>(after / width)}};
    }
    return taps;
}

/// The line between the two texels whose centers lie around each texel's center.
std::vector<Taps> between(int count, int result_count, Wrap wrap)
{
    if (count == result_count)
        return {};
    std::vector<Taps> taps(static_cast<size_t>(result_count));
    for (int i = 0; i < result_count; ++i) {
        const double place = (i + 0.5) * count / result_count - 0.5;
        const double first = std::floor(place);
        const int low = wrapped_index(static_cast<int>(first), count, wrap);
        const int high = wrapped_index(static_cast<int>(first) + 1, count, wrap);
        const double share = place - first;
        taps[static_cast<size_t>(i)] = {{low, high, high},
                                        {static_cast<float>(1.0 - share), static_cast<float>(share), 0.0f}};
    }
    return taps;
}

/// Both axes at once, row by row; an axis without taps stays as it is.
Grid filtered(const Grid& grid, Extent extent, const std::vector<Taps>& across, const std::vector<Taps>& down)
{
    Grid result{extent, grid.wrap_u, grid.wrap_v, std::vector<float>(area(extent))};
    std::vector<float> line(static_cast<size_t>(grid.extent.width));
    for (int y = 0; y < extent.height; ++y) {
        const float* from = grid.row(y);
        if (!down.empty()) {
            const auto& [index, weight] = down[static_cast<size_t>(y)];
            const float* a = grid.row(index[0]);
            const float* b = grid.row(index[1]);
            const float* c = grid.row(index[2]);
            for (size_t x = 0; x < line.size(); ++x)
                line[x] = a[x] * weight[0] + b[x] * weight[1] + c[x] * weight[2];
            from = line.data();
        }
        float* to = result.row(y);
        if (across.empty())
            std::copy(from, from + extent.width, to);
        for (const auto& [index, weight] : across)
            *to++ = from[index[0]] * weight[0] + from[index[1]] * weight[1] + from[index[2]] * weight[2];
    }
    return result;
}

} // namespace

int wrapped_index(int index, int count, Wrap wrap)
{
    if (wrap == Wrap::repeat)
        return (index + count) % count;
    return std::clamp(index, 0, count - 1); // a mirror stands at the border, so it shows the last texel too
}

float value_of(const Texture& texture, const Channel& channel, std::uint8_t code)
{
    const double value = code / 255.0;
    const bool is_curved = texture.is_srgb && channel.component != 3;
    return static_cast<float>((is_curved ? srgb_decode(value) : value) * static_cast<double>(channel.factor));
}

Grid load(const Texture& texture, const Channel& channel)
{
    std::array<float, 256> values{};
    for (size_t code = 0; code < values.size(); ++code)
        values[code] = value_of(texture, channel, static_cast<std::uint8_t>(code));
    Grid grid{texture.extent, texture.wrap_u, texture.wrap_v, std::vector<float>(area(texture.extent))};
    const std::uint8_t* code = texture.rgba.data() + channel.component;
    for (float& number : grid.values) {
        number = values[*code];
        code += 4;
    }
    return grid;
}

Grid enlarged(Grid grid, Extent extent)
{
    if (grid.extent == extent)
        return grid;
    return filtered(grid, extent, between(grid.extent.width, extent.width, grid.wrap_u),
                    between(grid.extent.height, extent.height, grid.wrap_v));
}

Grid shrunk(const Grid& grid, Extent extent)
{
    return filtered(grid, extent, covering(grid.extent.width, extent.width),
                    covering(grid.extent.height, extent.height));
}

} // namespace passgraph::atlas
