// Portable float maps: three header lines, then binary32 rows from the bottom.
//
// Source   Debevec, "PFM: Portable FloatMap image format"; a negative scale means little-endian.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "image/formats.hpp"

namespace passgraph::image_io
{

namespace
{

bool is_space(uint8_t byte)
{
    return byte == ' ' || byte == '\t' || byte == '\n' || byte == '\r';
}

/// Takes the next word off the front of `bytes`, and the one space that ends it.
std::string_view next_word(Bytes& bytes)
{
    size_t begin = 0;
    while (begin < bytes.size() && is_space(bytes[begin]))
        ++begin;
    size_t end = begin;
    while (end < bytes.size() && !is_space(bytes[end]))
        ++end;
    const std::string_view word(reinterpret_cast<const char*>(bytes.data()) + begin, end - begin);
    bytes = bytes.subspan(std::min(end + 1, bytes.size()));
    return word;
}

template <class Number> std::optional<Number> to_number(std::string_view word)
{
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return number;
}

float to_float(const uint8_t* bytes, bool is_swapped)
{
    uint32_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return std::bit_cast<float>(is_swapped ? __builtin_bswap32(bits) : bits);
}

} // namespace

Result<Picture> decode_pfm(const std::string& path, Bytes bytes)
{
    const int channels = next_word(bytes) == "PF" ? 3 : 1;
    const std::optional<int64_t> width = to_number<int64_t>(next_word(bytes));
    const std::optional<int64_t> height = to_number<int64_t>(next_word(bytes));
    const std::optional<double> scale = to_number<double>(next_word(bytes));
    if (!width || !height || *width < 1 || *height < 1)
        return malformed(path, "the second line of a .pfm file is its width and height");
    if (!scale || *scale == 0 || !std::isfinite(*scale))
        return malformed(path, "the third line of a .pfm file is a scale, negative for little-endian numbers");
    if (*width > kLargestSide || *height > kLargestSide)
        return too_large(path, *width, *height);
    const size_t count = static_cast<size_t>(*width) * static_cast<size_t>(*height) * static_cast<size_t>(channels);
    if (bytes.size() < 4 * count)
        return malformed(path, fmt::format("{} x {} texels need {} bytes, but only {} follow the header", *width,
                                           *height, 4 * count, bytes.size()));
    Picture picture({static_cast<int>(*width), static_cast<int>(*height)}, channels);
    const bool is_swapped = (*scale < 0) != (std::endian::native == std::endian::little);
    for (size_t i = 0; i < count; ++i)
        picture.texels[i] = to_float(&bytes[4 * i], is_swapped);
    return picture;
}

std::vector<uint8_t> encode_pfm(const Picture& picture)
{
    const std::string header =
        fmt::format("{}\n{} {}\n{}\n", picture.channels == 1 ? "Pf" : "PF", picture.extent.width, picture.extent.height,
                    std::endian::native == std::endian::little ? "-1.0" : "1.0");
    const size_t size = picture.texels.size() * sizeof(float);
    std::vector<uint8_t> bytes(header.size() + size);
    std::memcpy(bytes.data(), header.data(), header.size());
    std::memcpy(bytes.data() + header.size(), picture.texels.data(), size);
    return bytes;
}

} // namespace passgraph::image_io
