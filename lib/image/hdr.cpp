// Radiance pictures: a text header, then four bytes per texel, mostly run-length encoded.
//
// Written by stb, but read here: stb's reader loops forever on a file that is cut inside a run, and takes other cut
// files for black.
//
// Source   Ward, "Real Pixels", Graphics Gems II, 1991; the Radiance reference, "filefmts".
#include <cmath>
#include <cstdio>
#include <optional>

#include <stb_image_write.h>

#include "image/formats.hpp"

namespace passgraph::image_io
{

namespace
{

/// The next line without its end; nothing once the bytes run out.
std::optional<std::string_view> next_line(Bytes& bytes)
{
    for (size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] != '\n')
            continue;
        const std::string_view line(reinterpret_cast<const char*>(bytes.data()), i);
        bytes = bytes.subspan(i + 1);
        return line;
    }
    return std::nullopt;
}

/// One component of an encoded row: runs (128 + n, value) and literals (n, n values). False when it does not fit.
bool read_component(Bytes& bytes, int width, int component, std::vector<uint8_t>& row)
{
    int x = 0;
    const auto put = [&](uint8_t value) { row[static_cast<size_t>(4 * x++ + component)] = value; };
    while (x < width) {
        if (bytes.size() < 2)
            return false;
        const bool is_run = bytes[0] > 128;
        const int count = is_run ? bytes[0] - 128 : bytes[0];
        const size_t used = is_run ? 2 : static_cast<size_t>(count) + 1;
        if (count == 0 || count > width - x || bytes.size() < used)
            return false;
        for (int i = 0; i < count; ++i)
            put(bytes[is_run ? 1 : static_cast<size_t>(i) + 1]);
        bytes = bytes.subspan(used);
    }
    return true;
}

/// A row of whole texels, in which (1, 1, 1, n) repeats the one before.
bool read_flat_row(Bytes& bytes, int width, std::vector<uint8_t>& row)
{
    int shift = 0;
    for (int x = 0; x < width;) {
        if (bytes.size() < 4)
            return false;
        uint8_t* const texel = &row[static_cast<size_t>(4 * x)];
        const bool is_repeat = bytes[0] == 1 && bytes[1] == 1 && bytes[2] == 1;
        if (!is_repeat) {
            std::copy_n(bytes.begin(), 4, texel);
            ++x;
            shift = 0;
        } else {
            if (x == 0 || shift > 16)
                return false;
            const int count = bytes[3] << shift;
            if (count > width - x)
                return false;
            for (int i = 0; i < count; ++i, ++x)
                std::copy_n(texel - 4, 4, texel + 4 * i);
            shift += 8;
        }
        bytes = bytes.subspan(4);
    }
    return true;
}

bool read_row(Bytes& bytes, int width, std::vector<uint8_t>& row)
{
    const bool is_encoded = width >= 8 && width < 32768 && bytes.size() >= 4 && bytes[0] == 2 && bytes[1] == 2 &&
                            (bytes[2] << 8 | bytes[3]) == width;
    if (!is_encoded)
        return read_flat_row(bytes, width, row);
    bytes = bytes.subspan(4);
    for (int component = 0; component < 4; ++component)
        if (!read_component(bytes, width, component, row))
            return false;
    return true;
}

/// Where a texel's color ends up: mantissa / 256 * 2^(exponent - 128).
void decode_row(const std::vector<uint8_t>& row, int y, Picture& picture)
{
    for (int x = 0; x < picture.extent.width; ++x) {
        const uint8_t* const texel = &row[static_cast<size_t>(4 * x)];
        for (int c = 0; c < 3; ++c)
            picture.at(x, y, c) = texel[3] == 0 ? 0.0f : std::ldexp(static_cast<float>(texel[c]), texel[3] - 136);
    }
}

} // namespace

Result<Picture> decode_hdr(const std::string& path, Bytes bytes)
{
    bool is_rgbe = false;
    std::optional<std::string_view> line;
    while ((line = next_line(bytes)) && !line->empty())
        if (*line == "FORMAT=32-bit_rle_rgbe")
            is_rgbe = true;
    if (!line)
        return malformed(path, "its header has no end");
    if (!is_rgbe)
        return malformed(path, "its format is not 32-bit_rle_rgbe");
    line = next_line(bytes);
    long width = 0;
    long height = 0;
    if (!line || std::sscanf(std::string(*line).c_str(), "-Y %9ld +X %9ld", &height, &width) != 2 || width < 1 ||
        height < 1)
        return malformed(path, "the line after its header is not `-Y HEIGHT +X WIDTH`",
                         "other orientations are not read");
    if (width > kLargestSide || height > kLargestSide)
        return too_large(path, width, height);
    // A run of the old encoding is the shortest: a row takes at least four bytes.
    if (bytes.size() < 4 * static_cast<size_t>(height))
        return malformed(path, "the file ends before the picture does");
    Picture picture({static_cast<int>(width), static_cast<int>(height)}, 3);
    std::vector<uint8_t> row(4 * static_cast<size_t>(width));
    for (int y = picture.extent.height - 1; y >= 0; --y) {
        if (!read_row(bytes, picture.extent.width, row))
            return malformed(path, "the file ends before the picture does, or a run leaves its row");
        decode_row(row, y, picture);
    }
    return picture;
}

std::vector<uint8_t> encode_hdr(const Picture& picture)
{
    constexpr float kLargest = 0x1.fep126f; // mantissa 255, exponent 255; stb's exponent wraps beyond
    Picture storable = flipped(picture);
    for (float& value : storable.texels)
        value = value > 0 ? std::fmin(value, kLargest) : 0.0f; // negative and NaN become 0
    std::vector<uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& all = *static_cast<std::vector<uint8_t>*>(context);
        const auto* first = static_cast<const uint8_t*>(data);
        all.insert(all.end(), first, first + size);
    };
    const int is_done = stbi_write_hdr_to_func(append, &bytes, picture.extent.width, picture.extent.height,
                                               picture.channels, storable.texels.data());
    return is_done ? bytes : std::vector<uint8_t>();
}

} // namespace passgraph::image_io
