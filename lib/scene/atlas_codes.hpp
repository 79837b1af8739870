// How numbers are stored in an atlas: as 8-bit codes, linear or along sRGB's curve, and as halves.
#pragma once

#include <cstdint>

namespace passgraph::atlas {

/// IEC 61966-2-1, from [0, 1] to linear light in [0, 1].
double srgb_decode(double code);

/// The nearest code; what is outside [0, 1] is clamped.
std::uint8_t linear_code(float value);

/// The code nearest to sRGB's curve at `value`, the curve taken in double; what is outside [0, 1] is clamped.
std::uint8_t srgb_code(float value);

/// The nearest half.
std::uint16_t half_code(float value);

} // namespace passgraph::atlas
