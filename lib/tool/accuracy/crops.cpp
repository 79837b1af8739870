// Crops and difference maps.
#include "tool/accuracy/crops.hpp"

#include <algorithm>
#include <cmath>

namespace passgraph::accuracy {
namespace {

using Color = std::array<float, 3>;
constexpr Color kBroken = {1.0f, 0.0f, 1.0f};

struct Part {
    int x = 0;
    int y = 0;
    Extent extent;
};

Part part_of(const Ladder& ladder, Extent whole)
{
    const Extent extent{std::min(ladder.crop.width, whole.width), std::min(ladder.crop.height, whole.height)};
    const auto start = [](double center, int size, int all) {
        return std::clamp(static_cast<int>(center * all) - size / 2, 0, all - size);
    };
    return {start(ladder.crop_center[0], extent.width, whole.width), start(ladder.crop_center[1], extent.height, whole.height), extent};
}

float encoded(double linear)
{
    const double x = std::clamp(linear, 0.0, 1.0);
    return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
}

/// `lowest` and `highest` are those of the truth's part, for what has no scale of its own.
Color color_of(Shown shown, const double* value, int components, double lowest, double highest)
{
    const double last = value[components - 1];
    const auto channel = [&](int c) { return components == 3 ? value[c] : last; };
    Color color{};
    for (int c = 0; c < 3; ++c) {
        double level = 0.0;
        switch (shown) {
        case Shown::direction:
            level = 0.5 + 0.5 * channel(c);
            break;
        case Shown::radiance: // the part's brightest is white
            level = encoded(channel(c) / highest);
            break;
        case Shown::display:
            level = channel(c);
            break;
        case Shown::distance:
            level = std::log(-value[2] / lowest) / std::log(highest / lowest);
            break;
        case Shown::logarithmic:
            level = std::log(std::max(last, lowest) / lowest) / std::log(highest / lowest);
            break;
        }
        color[static_cast<size_t>(c)] = static_cast<float>(std::clamp(level, 0.0, 1.0));
    }
    return color;
}

struct Range {
    double lowest = 0.0;
    double highest = 1.0;
};

/// From the least to the greatest positive size in the part; of radiance to all but the brightest fiftieth, so that a spark
/// does not leave the rest black.
Range range_of(const Ladder& ladder, const Truth& truth, const Part& part)
{
    std::vector<double> sizes;
    for (int y = 0; y < part.extent.height; ++y)
        for (int x = 0; x < part.extent.width; ++x)
            for (int c = 0; c < truth.components; ++c) {
                const double* texel = truth.at(part.x + x, part.y + y);
                if (const double size = ladder.shown == Shown::distance ? -texel[2] : texel[c]; size > 0.0)
                    sizes.push_back(size);
            }
    if (sizes.empty())
        return {};
    std::sort(sizes.begin(), sizes.end());
    const double share = ladder.shown == Shown::radiance ? 0.98 : 1.0;
    const double highest = sizes[static_cast<size_t>(share * static_cast<double>(sizes.size() - 1))];
    return {std::max(sizes.front(), 1e-6 * highest), highest};
}

template <class Value>
Picture crop_of(const Ladder& ladder, const Truth& truth, const Value& value)
{
    const Part part = part_of(ladder, truth.extent);
    const Range range = range_of(ladder, truth, part);
    Picture picture(part.extent, 3);
    for (int y = 0; y < part.extent.height; ++y)
        for (int x = 0; x < part.extent.width; ++x) {
            const std::array<double, 3> texel = value(part.x + x, part.y + y);
            const bool is_finite = std::all_of(texel.begin(), texel.end(), [](double v) { return std::isfinite(v); });
            const Color color = is_finite ? color_of(ladder.shown, texel.data(), truth.components, range.lowest, range.highest) : kBroken;
            std::copy(color.begin(), color.end(), &picture.at(x, y));
        }
    return picture;
}

} // namespace

Picture truth_crop(const Ladder& ladder, const Truth& truth)
{
    return crop_of(ladder, truth, [&](int x, int y) {
        std::array<double, 3> texel{};
        std::copy(truth.at(x, y), truth.at(x, y) + truth.components, texel.begin());
        return texel;
    });
}

Picture result_crop(const Ladder& ladder, const Truth& truth, const Picture& result)
{
    return crop_of(ladder, truth, [&](int x, int y) {
        std::array<double, 3> texel{};
        for (int c = 0; c < truth.components; ++c)
            texel[static_cast<size_t>(c)] = result.at(x, y, c);
        return texel;
    });
}

std::vector<double> crop_differences(const Ladder& ladder, const Truth& truth, const Picture& result)
{
    const Part part = part_of(ladder, truth.extent);
    std::vector<double> differences;
    for (int y = 0; y < part.extent.height; ++y)
        for (int x = 0; x < part.extent.width; ++x)
            differences.push_back(signed_difference(ladder.metric, truth, result, part.x + x, part.y + y));
    return differences;
}

Color map_color(double difference, double limit)
{
    if (!std::isfinite(difference))
        return kBroken;
    if (!(limit > 0.0) || difference == 0.0)
        return {1.0f, 1.0f, 1.0f};
    const double decades = std::log10(std::abs(difference) / limit) + kMapDecades;
    const auto strength = static_cast<float>(std::clamp(decades / kMapDecades, 0.0, 1.0));
    // White over orange to dark red, and over sky to dark blue: brightness falls evenly, so that both read without color.
    const Color end = difference > 0.0 ? Color{0.55f, 0.05f, 0.10f} : Color{0.03f, 0.16f, 0.50f};
    const Color middle = difference > 0.0 ? Color{0.96f, 0.55f, 0.30f} : Color{0.35f, 0.64f, 0.90f};
    Color color{};
    for (size_t c = 0; c < 3; ++c)
        color[c] = strength < 0.5f ? 1.0f + 2.0f * strength * (middle[c] - 1.0f) : middle[c] + (2.0f * strength - 1.0f) * (end[c] - middle[c]);
    return color;
}

Picture difference_map(const std::vector<double>& differences, Extent extent, double limit)
{
    Picture picture(extent, 3);
    for (size_t i = 0; i < differences.size(); ++i) {
        const Color color = map_color(differences[i], limit);
        std::copy(color.begin(), color.end(), picture.texels.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    return picture;
}

} // namespace passgraph::accuracy
