// OpenEXR files that passgraph itself never writes: other channels, types, compressions, tiles, row orders.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <tinyexr.h>

struct ExrOptions {
    std::vector<std::string> names;     ///< sorted
    int type = TINYEXR_PIXELTYPE_FLOAT; ///< how values are stored
    int compression = TINYEXR_COMPRESSIONTYPE_NONE;
    int tile = 0; ///< the tiles' size, 0 for rows
};

/// The value of a channel at column x of row y from the top; exact in binary16.
inline float exr_value(size_t channel, int x, int y)
{
    return static_cast<float>(channel) * 256.0f + static_cast<float>(y) * 16.0f + static_cast<float>(x);
}

/// The bytes of a file of `width` x `height` texels that holds exr_value.
std::vector<uint8_t> make_exr(int width, int height, const ExrOptions& options);

/// Where the value of an attribute begins.
size_t exr_attribute(const std::vector<uint8_t>& bytes, const std::string& name);

/// Where the table of block offsets begins.
size_t exr_table(const std::vector<uint8_t>& bytes);
