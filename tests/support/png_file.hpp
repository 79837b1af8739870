// PNG files of kinds that our own writer does not make: grey, 16-bit, one bit, with a palette.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace passgraph::test {

enum class PngKind : std::uint8_t { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6 };

/// A PNG whose every texel has these samples (for `palette` one index into `palette`, and 8 bits at most).
struct FlatPng {
    int width = 1;
    int height = 1;
    PngKind kind = PngKind::rgb;
    int bits = 8; ///< per sample
    std::vector<unsigned> samples{};
    std::vector<std::array<std::uint8_t, 3>> palette{};
};

/// The file's bytes. Source: RFC 2083 (PNG), RFC 1950 and 1951 (zlib with stored blocks).
std::string png_bytes(const FlatPng& png);

} // namespace passgraph::test
