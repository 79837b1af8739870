// The ladders, each made by one function; `all_ladders` lists them.
#pragma once

#include "tool/accuracy/ladder.hpp"

namespace passgraph::accuracy {

Ladder normal_codec();
Ladder position_source();
Ladder radiance_codec();
Ladder beckmann_masking();
Ladder ggx_form();
Ladder fresnel_power();
Ladder blur();
Ladder tone_curve();
Ladder srgb_transfer();
Ladder guards();

/// A picture whose texels are `value(x, y)`, three numbers each.
template <class Value>
Picture picture_of(Extent extent, const Value& value)
{
    Picture picture(extent, 3);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const auto texel = value(x, y);
            for (int c = 0; c < 3; ++c)
                picture.at(x, y, c) = static_cast<float>(texel[static_cast<size_t>(c)]);
        }
    return picture;
}

/// The truth whose texels are `value(x, y)`, three numbers each.
template <class Value>
Truth truth_of(Extent extent, const Value& value)
{
    Truth truth{extent, 3, {}};
    truth.values.reserve(static_cast<size_t>(extent.width) * static_cast<size_t>(extent.height) * 3);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            for (const double number : value(x, y))
                truth.values.push_back(number);
    return truth;
}

/// Radiance over the whole of `lowest` to `highest` along x, its hue turning along y: no two texels alike.
Picture radiance_field(Extent extent, double lowest, double highest);

std::array<double, 3> texel(const Picture& picture, int x, int y);

/// "(0.1, 0.2, 0.3)"
std::string vector_text(const std::array<double, 3>& v);

} // namespace passgraph::accuracy
