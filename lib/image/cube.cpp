// The six faces of an environment, one file each.
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "image/formats.hpp"

namespace passgraph
{

namespace fs = std::filesystem;

namespace
{

constexpr std::array<std::string_view, 6> kFaces = {"px", "nx", "py", "ny", "pz", "nz"};
constexpr std::array<std::string_view, 6> kFaceSuffixes = {".hdr", ".exr", ".pfm", ".png", ".jpg", ".jpeg"};

/// The face's file; with several suffixes the one of larger range.
std::optional<std::string> find_face(const fs::path& folder, std::string_view face)
{
    std::error_code failed;
    for (const std::string_view suffix : kFaceSuffixes)
        if (const fs::path path = folder / fmt::format("{}{}", face, suffix); fs::exists(path, failed))
            return path.string();
    return std::nullopt;
}

void find_shape_errors(const std::string& folder, const std::array<Picture, 6>& faces, Errors& errors)
{
    for (size_t i = 0; i < faces.size(); ++i) {
        const auto [width, height] = faces[i].extent;
        if (width != height)
            errors.push_back(
                {.code = "cube_face_not_square",
                 .message = fmt::format("`{}` of `{}` has {} x {} texels", kFaces[i], folder, width, height),
                 .hint = "the faces of a cube are square"});
        else if (faces[i].extent != faces[0].extent)
            errors.push_back(
                {.code = "cube_face_size",
                 .message = fmt::format("`{}` of `{}` has {} x {} texels, but `px` has {} x {}", kFaces[i], folder,
                                        width, height, faces[0].extent.width, faces[0].extent.height),
                 .hint = "all six faces have the same size"});
    }
}

} // namespace

Result<std::array<Picture, 6>> read_cube(const std::string& folder, Transfer transfer)
{
    std::error_code failed;
    if (!fs::is_directory(folder, failed))
        return fail({.code = "file_missing", .message = fmt::format("there is no folder `{}`", folder)});
    Errors errors;
    std::array<Picture, 6> faces;
    for (size_t i = 0; i < faces.size(); ++i) {
        const std::optional<std::string> path = find_face(folder, kFaces[i]);
        if (!path) {
            errors.push_back({.code = "file_missing",
                              .message = fmt::format("`{}` has no face `{}`", folder, kFaces[i]),
                              .hint = fmt::format("a cube is six files px nx py ny pz nz, e.g. {}.png", kFaces[i])});
            continue;
        }
        const Result<Picture> face = read_picture(*path, transfer);
        if (face)
            faces[i] = image_io::flipped(image_io::with_channels(*face, 3));
        else
            errors.insert(errors.end(), face.error().begin(), face.error().end());
    }
    if (errors.empty())
        find_shape_errors(folder, faces, errors);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return faces;
}

} // namespace passgraph
