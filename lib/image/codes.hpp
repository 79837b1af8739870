// From the codes of a display to numbers and back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "passgraph/image/image_file.hpp"

namespace passgraph::image_io
{

/// Numbers for the codes 0 ... `largest` (255 or 65535), each rounded once from the formula in double.
///
/// Source   IEC 61966-2-1.
std::span<const float> code_values(int largest, Transfer transfer);

/// The nearest of 256 codes to each value clamped to [0, 1]; a NaN is 0. The bottom row comes last, as files want it.
std::vector<uint8_t> to_codes(const Picture& picture);

/// Fills `picture` from codes that are stored top row first; alpha (the fourth channel) is never decoded.
template <class Code> void from_codes(std::span<const Code> codes, Transfer transfer, Picture& picture)
{
    const int largest = sizeof(Code) == 1 ? 255 : 65535;
    const std::span<const float> color = code_values(largest, transfer);
    const std::span<const float> alpha = code_values(largest, Transfer::as_is);
    const Code* next = codes.data();
    for (int y = picture.extent.height - 1; y >= 0; --y)
        for (int x = 0; x < picture.extent.width; ++x)
            for (int c = 0; c < picture.channels; ++c)
                picture.at(x, y, c) = (c == 3 ? alpha : color)[*next++];
}

} // namespace passgraph::image_io
