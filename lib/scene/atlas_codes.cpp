// Rounding to the nearest code, quickly.
#include "atlas_codes.hpp"

#include <array>
#include <cmath>

#include <glm/gtc/packing.hpp>

namespace passgraph::atlas {
namespace {

constexpr int kBuckets = 4096; // the curve climbs 12.92 * 255 codes per unit at most, so less than one in a bucket

/// Where each code begins in linear light, and the code at the start of each bucket.
struct Curve {
    std::array<float, 256> next{}; ///< the least number whose code is higher
    std::array<std::uint8_t, kBuckets> code{};

    Curve()
    {
        for (size_t c = 0; c + 1 < next.size(); ++c)
            next[c] = static_cast<float>(srgb_decode((static_cast<double>(c) + 0.5) / 255.0));
        next.back() = 2.0f; // nothing is brighter
        size_t c = 0;
        for (size_t i = 0; i < code.size(); ++i) {
            while (static_cast<float>(i) / kBuckets >= next[c])
                ++c;
            code[i] = static_cast<std::uint8_t>(c);
        }
    }
};

} // namespace

double srgb_decode(double code)
{
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

std::uint8_t linear_code(float value)
{
    const float limited = value > 0.0f ? std::fmin(value, 1.0f) : 0.0f;
    return static_cast<std::uint8_t>(limited * 255.0f + 0.5f);
}

std::uint8_t srgb_code(float value)
{
    static const Curve curve;
    const float limited = value > 0.0f ? std::fmin(value, 0.99999994f) : 0.0f;
    size_t code = curve.code[static_cast<size_t>(limited * kBuckets)];
    while (limited >= curve.next[code])
        ++code;
    return static_cast<std::uint8_t>(code);
}

std::uint16_t half_code(float value)
{
    return glm::packHalf1x16(value);
}

} // namespace passgraph::atlas
