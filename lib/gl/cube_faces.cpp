// The six pictures of a cube map, checked.
#include "gl/cube_faces.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "gl/textures.hpp"

namespace passgraph::gl {
namespace {

constexpr std::array<std::string_view, 6> kNames = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
constexpr float kLargestHalf = 65504.0f;

} // namespace

Result<std::array<Picture, 6>> cube_faces(const std::array<Picture, 6>& faces, Signal signal, std::string_view subject,
                                          const Limits& limits, bool is_guarded)
{
    Errors errors;
    for (size_t i = 0; i < faces.size(); ++i) {
        const Extent extent = faces[i].extent;
        const std::string face =
            fmt::format("{}: face {} has {} x {} texels", subject, kNames[i], extent.width, extent.height);
        if (extent.width != extent.height || extent.width <= 0)
            errors.push_back(
                {.code = "cube_face_not_square", .message = face, .hint = "the faces of a cube are square"});
        else if (extent != faces[0].extent)
            errors.push_back({.code = "cube_face_size",
                              .message = fmt::format("{}, but face +X has {} x {}", face, faces[0].extent.width,
                                                     faces[0].extent.height),
                              .hint = "all six faces have the same size"});
        else if (extent.width > limits.cube_size)
            errors.push_back({.code = "texture_too_large",
                              .message = fmt::format("{}, the device takes {}", face, limits.cube_size),
                              .hint = "make the faces smaller",
                              .fault = Fault::machine});
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    std::array<Picture, 6> rgba;
    for (size_t i = 0; i < faces.size(); ++i) {
        rgba[i] = to_rgba(faces[i], signal, is_guarded);
        for (float& value : rgba[i].texels) // stored in binary16
            value = std::clamp(value, -kLargestHalf, kLargestHalf);
    }
    return rgba;
}

} // namespace passgraph::gl
