// OpenEXR by tinyexr: single-part scanline and tiled files of R G B A, Y A, or one channel.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <tinyexr.h>

#include "image/exr_layout.hpp"
#include "image/formats.hpp"

namespace passgraph::image_io
{

namespace
{

struct Header : EXRHeader {
    Header() { InitEXRHeader(this); }
    ~Header() { FreeEXRHeader(this); }
    Header(const Header&) = delete;
    Header& operator=(const Header&) = delete;
};

struct Image : EXRImage {
    Image() { InitEXRImage(this); }
    ~Image()
    {
        if (is_loaded) // after a failure tinyexr has freed it
            FreeEXRImage(this);
    }
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;

    bool is_loaded = false;
};

/// tinyexr's message, freed when read.
std::string taken(const char* message)
{
    std::string text = message ? message : "its pixels cannot be decoded";
    FreeEXRErrorMessage(message);
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return text;
}

/// Which channel of the file feeds each channel of the picture; empty when the names mean nothing here.
std::vector<size_t> choose_channels(const std::vector<ExrChannel>& channels)
{
    const auto find = [&](std::string_view name) -> size_t {
        for (size_t i = 0; i < channels.size(); ++i)
            if (channels[i].name == name)
                return i;
        return channels.size();
    };
    const size_t none = channels.size();
    if (channels.size() == 1)
        return {0};
    if (channels.size() == 2 && find("Y") != none && find("A") != none)
        return {find("Y"), find("Y"), find("Y"), find("A")};
    std::vector<size_t> chosen;
    for (const std::string_view name : {"R", "G", "B", "A"})
        if (chosen.size() < channels.size())
            chosen.push_back(find(name));
    const bool is_all =
        chosen.size() == channels.size() && std::find(chosen.begin(), chosen.end(), none) == chosen.end();
    return is_all ? chosen : std::vector<size_t>();
}

std::string channel_fault(const ExrLayout& layout)
{
    std::vector<std::string> names;
    for (const ExrChannel& channel : layout.channels) {
        names.push_back(channel.name);
        if (channel.x_sampling != 1 || channel.y_sampling != 1)
            return fmt::format("its channel {} is stored at a lower resolution", channel.name);
        if (channel.type == TINYEXR_PIXELTYPE_UINT)
            return fmt::format("its channel {} holds integers", channel.name);
    }
    if (choose_channels(layout.channels).empty())
        return fmt::format("its channels are {}", fmt::join(names, ", "));
    return {};
}

/// Copies a block whose rows run downwards; `stride` and the rows are in texels of the block.
void copy_block(unsigned char* const* planes, std::pair<int, int> corner, Extent size, int stride,
                const std::vector<size_t>& chosen, Picture& picture)
{
    for (size_t c = 0; c < chosen.size(); ++c) {
        const auto* plane = reinterpret_cast<const float*>(planes[chosen[c]]);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                picture.at(corner.first + x, picture.extent.height - 1 - corner.second - y, static_cast<int>(c)) =
                    plane[static_cast<size_t>(y) * static_cast<size_t>(stride) + static_cast<size_t>(x)];
    }
}

Picture to_picture(const EXRImage& image, const ExrLayout& layout, const std::vector<size_t>& chosen)
{
    Picture picture({static_cast<int>(layout.width), static_cast<int>(layout.height)}, static_cast<int>(chosen.size()));
    if (!layout.is_tiled) {
        copy_block(image.images, {0, 0}, picture.extent, picture.extent.width, chosen, picture);
        return picture;
    }
    const int tile_width = static_cast<int>(layout.tile_width);
    const int tile_height = static_cast<int>(layout.tile_height);
    for (int i = 0; i < image.num_tiles; ++i) {
        const EXRTile& tile = image.tiles[i];
        copy_block(tile.images, {tile.offset_x * tile_width, tile.offset_y * tile_height}, {tile.width, tile.height},
                   tile_width, chosen, picture);
    }
    return picture;
}

} // namespace

Result<Picture> decode_exr(const std::string& path, Bytes bytes)
{
    const tl::expected<ExrLayout, std::string> layout = read_exr_layout(bytes);
    if (!layout)
        return malformed(path, layout.error());
    if (layout->width > kLargestSide || layout->height > kLargestSide)
        return too_large(path, layout->width, layout->height);
    if (const std::string fault = channel_fault(*layout); !fault.empty())
        return malformed(path, fault,
                         "R, G, B and A of binary16 or binary32 are read, or Y with or without A, or any one channel");
    if (const auto fault = find_exr_fault(bytes, *layout))
        return malformed(path, *fault);
    try {
        EXRVersion version;
        Header header;
        Image image;
        const char* message = nullptr;
        if (ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size()) != TINYEXR_SUCCESS)
            return malformed(path, "its version cannot be read");
        if (ParseEXRHeaderFromMemory(&header, &version, bytes.data(), bytes.size(), &message) != TINYEXR_SUCCESS)
            return malformed(path, taken(message));
        for (int c = 0; c < header.num_channels; ++c)
            header.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
        header.line_order = 0;                           // it orders the file, but tinyexr flips the picture by it
        header.chunk_count = 0;                          // to be derived, not believed
        header.tile_level_mode = TINYEXR_TILE_ONE_LEVEL; // the finest level comes first
        if (LoadEXRImageFromMemory(&image, &header, bytes.data(), bytes.size(), &message) != TINYEXR_SUCCESS)
            return malformed(path, taken(message));
        image.is_loaded = true;
        return to_picture(image, *layout, choose_channels(layout->channels));
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return malformed(path, error.what());
    }
}

std::vector<uint8_t> encode_exr(const Picture& picture)
{
    const auto channels = static_cast<size_t>(picture.channels);
    const std::string_view names = channels == 1 ? "Y" : channels == 3 ? "BGR" : "ABGR"; // sorted, as the format asks
    const Picture rows = flipped(picture);
    const size_t count = rows.texels.size() / channels;
    std::vector<std::vector<float>> planes(channels, std::vector<float>(count));
    std::array<EXRChannelInfo, 4> infos{};
    std::array<unsigned char*, 4> pointers{};
    std::array<int, 4> types{};
    for (size_t c = 0; c < channels; ++c) {
        infos[c].name[0] = names[c];
        types[c] = TINYEXR_PIXELTYPE_FLOAT;
        pointers[c] = reinterpret_cast<unsigned char*>(planes[c].data());
        for (size_t i = 0; i < count; ++i)
            planes[c][i] = rows.texels[i * channels + channels - 1 - c];
    }
    EXRImage image;
    InitEXRImage(&image);
    image.images = pointers.data();
    image.width = picture.extent.width;
    image.height = picture.extent.height;
    image.num_channels = picture.channels;
    EXRHeader header;
    InitEXRHeader(&header);
    header.channels = infos.data();
    header.num_channels = picture.channels;
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIPS; // a fifth less time than zip for 3 % more bytes
    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    FreeEXRErrorMessage(message);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owned(memory, &std::free);
    return std::vector<uint8_t>(memory, memory + size);
}

} // namespace passgraph::image_io
