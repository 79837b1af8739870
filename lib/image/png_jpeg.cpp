// PNG and JPEG by stb: 8 and 16 bits in, 8 bits out.
#include <memory>
#include <mutex>
#include <utility>

#include <stb_image.h>
#include <stb_image_write.h>

#include "image/codes.hpp"
#include "image/formats.hpp"

namespace passgraph::image_io
{

namespace
{

struct FreeImage {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

void append(void* context, void* data, int size)
{
    auto& bytes = *static_cast<std::vector<uint8_t>*>(context);
    const auto* first = static_cast<const uint8_t*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

int64_t big_endian(Bytes bytes)
{
    return int64_t{bytes[0]} << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
}

bool is_jpeg(Bytes bytes)
{
    return bytes.size() > 2 && bytes[0] == 0xff && bytes[1] == 0xd8;
}

/// True when a JPEG's scans are followed by its end marker. stb fills what a cut file lacks with grey and says nothing.
bool has_end_marker(Bytes bytes)
{
    size_t at = 2;
    while (at + 4 <= bytes.size() && bytes[at] == 0xff && bytes[at + 1] != 0xda) {
        const bool is_padding = bytes[at + 1] == 0xff;
        at += is_padding ? 1 : 2 + (static_cast<size_t>(bytes[at + 2]) << 8 | bytes[at + 3]);
    }
    for (; at + 2 <= bytes.size(); ++at) // inside a scan 0xff is followed by 0 or by a restart marker
        if (bytes[at] == 0xff && bytes[at + 1] == 0xd9)
            return true;
    return false;
}

template <class Code>
Result<Picture> to_picture(const std::string& path, const Code* pixels, Extent extent, int channels, Transfer transfer)
{
    if (!pixels)
        return malformed(path, stbi_failure_reason());
    if (channels < 1 || channels > 4)
        return malformed(path, "it has an unusual number of channels");
    Picture picture(extent, channels);
    const std::span<const Code> codes(pixels, picture.texels.size());
    if (channels != 2) {
        from_codes(codes, transfer, picture);
        return picture;
    }
    std::vector<Code> wide; // grey and alpha: one grey for each color
    wide.reserve(2 * codes.size());
    for (size_t i = 0; i < codes.size(); i += 2)
        wide.insert(wide.end(), {codes[i], codes[i], codes[i], codes[i + 1]});
    Picture widened(extent, 4);
    from_codes(std::span<const Code>(wide), transfer, widened);
    return widened;
}

} // namespace

Result<Picture> decode_png_or_jpeg(const std::string& path, Bytes bytes, Transfer transfer)
{
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (!is_jpeg(bytes) && bytes.size() >= 24) { // by hand, as stb calls what it finds too large just unknown
        const auto png_width = big_endian(bytes.subspan(16));
        const auto png_height = big_endian(bytes.subspan(20));
        if (png_width > kLargestSide || png_height > kLargestSide)
            return too_large(path, png_width, png_height);
    }
    stbi_info_from_memory(bytes.data(), size, &width, &height, &channels); // a failure comes again, better explained
    if (width > kLargestSide || height > kLargestSide)
        return too_large(path, width, height);
    if (is_jpeg(bytes) && !has_end_marker(bytes))
        return malformed(path, "the file ends before the picture does");
    if (stbi_is_16_bit_from_memory(bytes.data(), size)) {
        const std::unique_ptr<stbi_us, FreeImage> pixels(
            stbi_load_16_from_memory(bytes.data(), size, &width, &height, &channels, 0));
        return to_picture(path, pixels.get(), {width, height}, channels, transfer);
    }
    const std::unique_ptr<stbi_uc, FreeImage> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 0));
    return to_picture(path, pixels.get(), {width, height}, channels, transfer);
}

std::vector<uint8_t> encode_png(const Picture& picture)
{
    constexpr int kQuickLevel = 5; // a fifth less time than stb's 8 for 5 % more bytes; lower ones are taken as 5
    const std::vector<uint8_t> codes = to_codes(picture);
    const auto [width, height] = picture.extent;
    std::vector<uint8_t> bytes;
    static std::mutex level_mutex; // stb keeps the level in a global
    const std::scoped_lock lock(level_mutex);
    const int level = std::exchange(stbi_write_png_compression_level, kQuickLevel);
    const int is_done =
        stbi_write_png_to_func(append, &bytes, width, height, picture.channels, codes.data(), width * picture.channels);
    stbi_write_png_compression_level = level;
    return is_done ? bytes : std::vector<uint8_t>();
}

std::vector<uint8_t> encode_jpeg(const Picture& picture)
{
    constexpr int kQuality = 95; // above 90 stb keeps the color at full resolution
    const auto [width, height] = picture.extent;
    const std::vector<uint8_t> codes = to_codes(picture);
    std::vector<uint8_t> bytes;
    const int is_done = stbi_write_jpg_to_func(append, &bytes, width, height, picture.channels, codes.data(), kQuality);
    return is_done ? bytes : std::vector<uint8_t>();
}

} // namespace passgraph::image_io
