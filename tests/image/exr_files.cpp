// Writes OpenEXR test files by tinyexr and finds places in them to damage.
#include "image/exr_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace
{

using Planes = std::vector<std::vector<float>>;

Planes make_planes(int x0, int y0, int width, int height, int stride, size_t channels)
{
    Planes planes(channels, std::vector<float>(static_cast<size_t>(stride) * static_cast<size_t>(height)));
    for (size_t c = 0; c < channels; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                planes[c][static_cast<size_t>(y * stride + x)] = exr_value(c, x0 + x, y0 + y);
    return planes;
}

std::vector<unsigned char*> pointers_to(Planes& planes)
{
    std::vector<unsigned char*> pointers;
    for (std::vector<float>& plane : planes)
        pointers.push_back(reinterpret_cast<unsigned char*>(plane.data()));
    return pointers;
}

} // namespace

std::vector<uint8_t> make_exr(int width, int height, const ExrOptions& options)
{
    const size_t channels = options.names.size();
    std::vector<EXRChannelInfo> infos(channels);
    for (size_t c = 0; c < channels; ++c)
        std::strncpy(infos[c].name, options.names[c].c_str(), 255);
    std::vector<int> given(channels, options.type == TINYEXR_PIXELTYPE_UINT ? options.type : TINYEXR_PIXELTYPE_FLOAT);
    std::vector<int> stored(channels, options.type);
    EXRHeader header;
    InitEXRHeader(&header);
    header.channels = infos.data();
    header.num_channels = static_cast<int>(channels);
    header.pixel_types = given.data();
    header.requested_pixel_types = stored.data();
    header.compression_type = options.compression;
    header.data_window = {0, 0, width - 1, height - 1}; // tiles are counted by it
    EXRImage image;
    InitEXRImage(&image);
    image.width = width;
    image.height = height;
    image.num_channels = header.num_channels;
    Planes whole = make_planes(0, 0, width, height, width, channels);
    std::vector<unsigned char*> whole_pointers = pointers_to(whole);
    std::vector<Planes> tile_planes;
    std::vector<std::vector<unsigned char*>> tile_pointers;
    std::vector<EXRTile> tiles;
    if (options.tile == 0) {
        image.images = whole_pointers.data();
    } else {
        const int size = options.tile;
        header.tiled = 1;
        header.tile_size_x = size;
        header.tile_size_y = size;
        header.tile_level_mode = TINYEXR_TILE_ONE_LEVEL;
        header.tile_rounding_mode = TINYEXR_TILE_ROUND_DOWN;
        for (int y = 0; y < height; y += size)
            for (int x = 0; x < width; x += size) {
                EXRTile tile{};
                tile.offset_x = x / size;
                tile.offset_y = y / size;
                tile.width = std::min(size, width - x);
                tile.height = std::min(size, height - y);
                tiles.push_back(tile);
                tile_planes.push_back(make_planes(x, y, tile.width, tile.height, size, channels));
                tile_pointers.push_back(pointers_to(tile_planes.back()));
            }
        for (size_t i = 0; i < tiles.size(); ++i)
            tiles[i].images = tile_pointers[i].data();
        image.tiles = tiles.data();
        image.num_tiles = static_cast<int>(tiles.size());
    }
    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    if (size == 0)
        throw std::runtime_error(message ? message : "no EXR was made");
    std::vector<uint8_t> bytes(memory, memory + size);
    std::free(memory);
    return bytes;
}

size_t exr_attribute(const std::vector<uint8_t>& bytes, const std::string& name)
{
    const auto found = std::search(bytes.begin(), bytes.end(), name.c_str(), name.c_str() + name.size() + 1);
    if (found == bytes.end())
        throw std::runtime_error("no attribute " + name);
    const auto type = found + static_cast<std::ptrdiff_t>(name.size()) + 1;
    return static_cast<size_t>(std::find(type, bytes.end(), 0) - bytes.begin()) + 1 + 4;
}

size_t exr_table(const std::vector<uint8_t>& bytes)
{
    size_t at = 8; // behind the magic number and the version
    while (bytes.at(at) != 0) {
        at += std::strlen(reinterpret_cast<const char*>(&bytes[at])) + 1;
        at += std::strlen(reinterpret_cast<const char*>(&bytes[at])) + 1;
        uint32_t size;
        std::memcpy(&size, &bytes.at(at), sizeof size);
        at += sizeof size + size;
    }
    return at + 1;
}
