// How numbers are stored in an atlas: as 8-bit codes, linear or along sRGB's curve, and as halves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/gtc/packing.hpp>

namespace passgraph::atlas {

/// IEC 61966-2-1, from [0, 1] to linear light in [0, 1].
double srgb_decode(double code);

/// The nearest code; what is outside [0, 1] is clamped, and NaN is 0.
struct LinearCode {
    std::uint8_t operator()(float value) const
    {
        const float limited = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
        return static_cast<std::uint8_t>(limited * 255.0f + 0.5f);
    }
};

/// The code nearest to sRGB's curve, as exact as the curve in double: a table gives the code where a bucket of numbers
/// begins, and a comparison tells whether the next one has begun.
class SrgbCode {
public:
    SrgbCode();

    std::uint8_t operator()(float value) const
    {
        const float limited = value > 0.0f ? (value < kMost ? value : kMost) : 0.0f;
        const std::uint8_t code = code_[static_cast<size_t>(limited * kBuckets)];
        return static_cast<std::uint8_t>(code + (limited >= next_[code] ? 1 : 0));
    }

private:
    static constexpr float kMost = 0.99999994f;
    static constexpr int kBuckets = 4096; ///< codes are 1 / (12.92 * 255) wide at least: one begins in each at most

    std::array<float, 256> next_{}; ///< by code: the least number whose code is higher
    std::array<std::uint8_t, kBuckets> code_{};
};

/// The nearest half.
struct HalfCode {
    std::uint16_t operator()(float value) const { return glm::packHalf1x16(value); }
};

} // namespace passgraph::atlas
