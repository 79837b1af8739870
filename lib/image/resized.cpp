// Resampling a picture to another extent.
#include <cassert>
#include <new>

#include <stb_image_resize.h>

#include "passgraph/image/image_file.hpp"

namespace passgraph
{

Picture resized(const Picture& picture, Extent extent)
{
    assert(extent.width > 0 && extent.height > 0);
    if (extent == picture.extent)
        return picture;
    Picture result(extent, picture.channels);
    // A triangle has no negative weights: radiance stays positive beside a lamp.
    const int is_done = stbir_resize_float_generic(picture.texels.data(), picture.extent.width, picture.extent.height,
                                                   0, result.texels.data(), extent.width, extent.height, 0,
                                                   picture.channels, STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP,
                                                   STBIR_FILTER_TRIANGLE, STBIR_COLORSPACE_LINEAR, nullptr);
    if (!is_done)
        throw std::bad_alloc();
    return result;
}

} // namespace passgraph
