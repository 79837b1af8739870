// The list of ladders, and what several share.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tool/accuracy/ladders/ladders.hpp"

namespace passgraph::accuracy {

const std::vector<Ladder>& all_ladders()
{
    static const std::vector<Ladder> all = {normal_codec(), position_source(), ggx_form(),      fresnel_power(), beckmann_masking(), radiance_codec(),
                                            guards(),       blur(),            tone_curve(), srgb_transfer()};
    return all;
}

Picture radiance_field(Extent extent, double lowest, double highest)
{
    return picture_of(extent, [&](int x, int y) {
        const double along = (x + 0.5) / extent.width;
        const double hue = 2.0 * std::numbers::pi * (y + 0.5) / extent.height;
        const double level = lowest * std::pow(highest / lowest, along);
        std::array<double, 3> color{};
        for (int c = 0; c < 3; ++c) // each channel from a fifth of the level to all of it
            color[static_cast<size_t>(c)] = level * (0.6 + 0.4 * std::cos(hue - 2.0 * std::numbers::pi * c / 3.0));
        return color;
    });
}

std::array<double, 3> texel(const Picture& picture, int x, int y)
{
    return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

std::string vector_text(const std::array<double, 3>& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]); }

} // namespace passgraph::accuracy
