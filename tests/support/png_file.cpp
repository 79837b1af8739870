// PNG without compression: signature, header, palette, stored blocks.
#include "support/png_file.hpp"

#include <algorithm>

namespace passgraph::test {
namespace {

void add_word(std::string& bytes, std::uint32_t word)
{
    for (const int shift : {24, 16, 8, 0})
        bytes += static_cast<char>(word >> shift & 0xFFu);
}

std::uint32_t crc_of(const std::string& bytes)
{
    std::uint32_t crc = ~0u;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

std::string chunk(const std::string& type, const std::string& data)
{
    std::string bytes;
    add_word(bytes, static_cast<std::uint32_t>(data.size()));
    bytes += type + data;
    add_word(bytes, crc_of(type + data));
    return bytes;
}

std::string zlib_stored(const std::string& data)
{
    constexpr size_t kLongest = 65535;
    std::string bytes = "\x78\x01";
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    for (size_t at = 0; at < data.size(); at += kLongest) {
        const size_t length = std::min(kLongest, data.size() - at);
        bytes += at + length == data.size() ? '\1' : '\0';
        for (const size_t word : {length, ~length})
            bytes += {static_cast<char>(word & 0xFF), static_cast<char>(word >> 8 & 0xFF)};
        bytes += data.substr(at, length);
    }
    add_word(bytes, b << 16 | a);
    return bytes;
}

/// One row: the filter's number (none), then the samples, most significant bit first.
std::string row_of(const FlatPng& png)
{
    std::string row(1, '\0');
    unsigned pending = 0;
    int pending_bits = 0;
    for (int x = 0; x < png.width; ++x) {
        for (const unsigned sample : png.samples) {
            if (png.bits == 16)
                row += static_cast<char>(sample >> 8);
            if (png.bits >= 8) {
                row += static_cast<char>(sample & 0xFF);
                continue;
            }
            pending = pending << png.bits | sample;
            pending_bits += png.bits;
            if (pending_bits == 8) {
                row += static_cast<char>(pending);
                pending = 0;
                pending_bits = 0;
            }
        }
    }
    if (pending_bits > 0)
        row += static_cast<char>(pending << (8 - pending_bits));
    return row;
}

} // namespace

std::string png_bytes(const FlatPng& png)
{
    std::string header;
    add_word(header, static_cast<std::uint32_t>(png.width));
    add_word(header, static_cast<std::uint32_t>(png.height));
    header += {static_cast<char>(png.bits), static_cast<char>(png.kind), '\0', '\0', '\0'};
    std::string colors;
    for (const auto& color : png.palette)
        for (const std::uint8_t c : color)
            colors += static_cast<char>(c);
    std::string rows;
    for (int y = 0; y < png.height; ++y)
        rows += row_of(png);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + (colors.empty() ? "" : chunk("PLTE", colors)) +
           chunk("IDAT", zlib_stored(rows)) + chunk("IEND", "");
}

} // namespace passgraph::test
