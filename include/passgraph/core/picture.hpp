// Pixels in memory: binary32, row by row from the bottom, so that uv (0, 0) is the first texel.
#pragma once

#include <cstddef>
#include <vector>

namespace passgraph {

/// Width and height in texels.
struct Extent {
    int width = 0;
    int height = 0;

    friend bool operator==(const Extent&, const Extent&) = default;
};

/// An image on the host.
///
/// Shape    `extent.width * extent.height` texels of `channels` (1 to 4) interleaved floats; row 0 is the bottom row.
struct Picture {
    Extent extent;
    int channels = 0;
    std::vector<float> texels;

    Picture() = default;
    Picture(Extent size, int channel_count)
        : extent(size), channels(channel_count),
          texels(static_cast<size_t>(size.width) * static_cast<size_t>(size.height) *
                 static_cast<size_t>(channel_count))
    {
    }

    size_t index(int x, int y, int channel = 0) const
    {
        return (static_cast<size_t>(y) * static_cast<size_t>(extent.width) + static_cast<size_t>(x)) *
                   static_cast<size_t>(channels) +
               static_cast<size_t>(channel);
    }
    float& at(int x, int y, int channel = 0) { return texels[index(x, y, channel)]; }
    float at(int x, int y, int channel = 0) const { return texels[index(x, y, channel)]; }
};

} // namespace passgraph
