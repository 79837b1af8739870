// The tables of sRGB's curve.
#include "atlas_codes.hpp"

#include <cmath>

namespace passgraph::atlas {

double srgb_decode(double code)
{
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

SrgbCode::SrgbCode()
{
    for (size_t code = 0; code + 1 < next_.size(); ++code)
        next_[code] = static_cast<float>(srgb_decode((static_cast<double>(code) + 0.5) / 255.0));
    next_.back() = 2.0f; // nothing is brighter
    size_t code = 0;
    for (size_t i = 0; i < code_.size(); ++i) {
        while (static_cast<float>(i) / kBuckets >= next_[code])
            ++code;
        code_[i] = static_cast<std::uint8_t>(code);
    }
}

} // namespace passgraph::atlas
