// What an OpenEXR file says about itself, checked before tinyexr sees it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "image/formats.hpp"

namespace passgraph::image_io
{

struct ExrChannel {
    std::string name;
    int type = 0; ///< TINYEXR_PIXELTYPE_...
    int x_sampling = 1;
    int y_sampling = 1;
};

/// The part of the header that decides where pixels are.
struct ExrLayout {
    std::vector<ExrChannel> channels;
    int compression = -1;
    int64_t min_x = 0;
    int64_t min_y = 0;
    int64_t width = 0; ///< of the data window; 0 while the header has not said it
    int64_t height = 0;
    bool is_tiled = false;
    int64_t tile_width = 0;
    int64_t tile_height = 0;
    size_t table = 0; ///< where the table of chunk offsets begins
};

/// Reads the header of a single-part file.
/// Errors   one sentence: what is malformed or not supported.
tl::expected<ExrLayout, std::string> read_exr_layout(Bytes bytes);

/// The first fault of the chunks, or nothing: after that every chunk is inside the file, has the place that its index
/// says, and is no longer than its pixels.
///
/// tinyexr relies on all of that without looking (its issues 102, 106, 167, 177). Only the finest level is looked at.
std::optional<std::string> find_exr_fault(Bytes bytes, const ExrLayout& layout);

} // namespace passgraph::image_io
