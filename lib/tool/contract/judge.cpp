// Tells good texels from bad ones.
#include "tool/contract/judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "tool/contract/values.hpp"

namespace passgraph::tool::contract {

bool is_finite(const Picture& picture, Texel texel)
{
    for (int c = 0; c < picture.channels; ++c)
        if (!std::isfinite(picture.at(texel.x, texel.y, c)))
            return false;
    return true;
}

bool is_all_finite(const Outputs& outputs)
{
    return std::none_of(outputs.begin(), outputs.end(), [](const auto& entry) {
        return find_texel(entry.second, [&](Texel texel) { return !is_finite(entry.second, texel); }).has_value();
    });
}

bool is_zero(const Picture& picture, Texel texel)
{
    for (int c = 0; c < picture.channels; ++c)
        if (picture.at(texel.x, texel.y, c) != 0.0f)
            return false;
    return true;
}

double largest_of(const Picture& picture)
{
    double largest = 0.0;
    for (const float value : picture.texels)
        if (std::isfinite(value))
            largest = std::max(largest, std::abs(static_cast<double>(value)));
    return largest;
}

bool is_in_range(const Picture& picture, Texel texel, Signal signal, const Contract::Span& range, double size)
{
    constexpr double kUnitLength = 1e-3; // as the signal table says
    double squared = 0.0;
    const double slack = kRounding * std::min(size, std::max(std::abs(range.lowest), std::abs(range.highest)));
    for (int c = 0; c < picture.channels; ++c) {
        const double value = static_cast<double>(picture.at(texel.x, texel.y, c));
        squared += value * value;
        const bool is_inside = value >= range.lowest - slack && (range.is_saturated || value <= range.highest + slack);
        if (!is_inside)
            return false;
    }
    return std::isfinite(squared) && (signal != Signal::normal || std::abs(std::sqrt(squared) - 1.0) <= kUnitLength);
}

bool is_same(const Picture& a, const Picture& b, Texel texel)
{
    return std::memcmp(&a.texels[a.index(texel.x, texel.y)], &b.texels[b.index(texel.x, texel.y)],
                       static_cast<size_t>(a.channels) * sizeof(float)) == 0;
}

std::string place_text(const std::string& output, Texel texel, Extent extent)
{
    return fmt::format("`{}` at ({}, {}) of {}x{}", output, texel.x, texel.y, extent.width, extent.height);
}

std::string texel_text(const Picture& picture, Texel texel)
{
    std::vector<std::string> values;
    for (int c = 0; c < picture.channels; ++c)
        values.push_back(fmt::format("{:.9g}", picture.at(texel.x, texel.y, c)));
    return fmt::format("{}", fmt::join(values, ", "));
}

std::string range_text(Signal signal, const Contract::Span& range)
{
    if (signal == Signal::normal)
        return "a vector of length 1";
    return fmt::format("from {} to {}", range.lowest, range.is_saturated ? "whatever is finite" : fmt::format("{:.9g}", range.highest));
}

} // namespace passgraph::tool::contract
