// The six faces of an environment, one file each.
#include <algorithm>
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

using Faces = std::array<std::optional<Picture>, 6>;

bool is_square(const Picture& face)
{
    return face.extent.width == face.extent.height;
}

/// The extent that most of the square faces have; the first such among equals.
Extent usual_extent(const Faces& faces)
{
    Extent usual;
    std::ptrdiff_t most = 0;
    for (const auto& face : faces) {
        if (!face || !is_square(*face))
            continue;
        const auto same = std::count_if(faces.begin(), faces.end(),
                                        [&](const auto& other) { return other && other->extent == face->extent; });
        if (same > most) {
            most = same;
            usual = face->extent;
        }
    }
    return usual;
}

void find_shape_errors(const std::string& folder, const Faces& faces, Errors& errors)
{
    const Extent usual = usual_extent(faces);
    for (size_t i = 0; i < faces.size(); ++i) {
        if (!faces[i])
            continue;
        const auto [width, height] = faces[i]->extent;
        if (width != height)
            errors.push_back(
                {.code = "cube_face_not_square",
                 .message = fmt::format("`{}` of `{}` has {} x {} texels", kFaces[i], folder, width, height),
                 .hint = "the faces of a cube are square"});
        else if (faces[i]->extent != usual)
            errors.push_back({.code = "cube_face_size",
                              .message = fmt::format("`{}` of `{}` has {} x {} texels, but others have {} x {}",
                                                     kFaces[i], folder, width, height, usual.width, usual.height),
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
    Faces faces;
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
    find_shape_errors(folder, faces, errors);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    std::array<Picture, 6> cube;
    for (size_t i = 0; i < faces.size(); ++i)
        cube[i] = std::move(*faces[i]);
    return cube;
}

} // namespace passgraph
