// Taking in of pictures, cube maps and host textures.
#include "gl/imports.hpp"

#include <atomic>

#include <fmt/format.h>

#include "gl/cube_faces.hpp"

namespace passgraph::gl {
namespace {

Error wrong_extent(const Plan::Import& import, Extent extent)
{
    return {.code = "import_extent",
            .message = fmt::format("`{}` has {} x {} texels, but the plan was compiled for {} x {}", import.name,
                                   extent.width, extent.height, import.extent.width, import.extent.height),
            .hint = "compile with CompileOptions::picture_extents set to the picture's extent, then replace(plan)"};
}

Error wrong_kind(const Plan::Import& import, std::string_view given)
{
    return {.code = "wrong_import_kind",
            .message = fmt::format("`{}` is a {}, got a {}", import.name,
                                   import.kind == Plan::Import::Kind::picture ? "picture" : "cube map", given),
            .hint = "import_picture is for pictures, import_cube for cube maps and the sky"};
}

bool is_level_there(Upload& upload, const ImportTexture& texture, int level)
{
    GLint width = 0;
    upload.state.edit_texture(texture.target(), texture.id);
    upload.driver.gl.GetTexLevelParameteriv(texture.is_cube() ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : GL_TEXTURE_2D, level,
                                            GL_TEXTURE_WIDTH, &width);
    return width > 0;
}

/// Numbers that no import of any plan had before; the host's own count in the other half.
std::uint64_t next_version()
{
    static std::atomic<std::uint64_t> latest = 0;
    return ++latest;
}
constexpr std::uint64_t hosts_version(std::uint64_t version) { return version | std::uint64_t{1} << 63; }

bool fits(const Plan::Import& wanted, const Plan::Import& old)
{
    return wanted.name == old.name && wanted.kind == old.kind && wanted.signal == old.signal &&
           (wanted.kind != Plan::Import::Kind::picture || wanted.extent == old.extent);
}

} // namespace

Imports::Imports(const Plan& plan)
{
    for (const Plan::Import& import : plan.imports)
        textures_.push_back({.import = import});
    for (const Plan::Step& step : plan.steps)
        for (const Plan::Read& read : step.reads)
            if (read.source == Plan::Read::Source::import && read.has_levels)
                textures_[static_cast<size_t>(read.index)].wants_levels = true;
}

void Imports::adopt(Upload& upload, Imports&& old)
{
    for (ImportTexture& texture : textures_) {
        for (ImportTexture& candidate : old.textures_) {
            if (candidate.id == 0 || !fits(texture.import, candidate.import))
                continue;
            texture.id = candidate.id;
            texture.owned = std::move(candidate.owned);
            texture.has_levels = candidate.has_levels;
            texture.version = candidate.version;
            texture.harmonics = candidate.harmonics;
            if (texture.owned && texture.wants_levels && !texture.has_levels) {
                add_levels(upload, texture.id);
                texture.has_levels = true;
            }
        }
    }
}

void Imports::borrow(const Imports& other)
{
    for (ImportTexture& texture : textures_)
        for (const ImportTexture& candidate : other.textures_)
            if (candidate.id != 0 && fits(texture.import, candidate.import)) {
                texture.id = candidate.id;
                texture.has_levels = candidate.has_levels;
                texture.version = candidate.version;
            }
}

Result<ImportTexture*> Imports::find(std::string_view name)
{
    std::vector<std::string> names;
    for (ImportTexture& texture : textures_) {
        if (texture.import.name == name)
            return &texture;
        names.push_back(texture.import.name);
    }
    return fail({.code = "unknown_import",
                 .message = fmt::format("the plan has no import `{}`", name),
                 .hint = suggest(name, names, "imports")});
}

Result<void> Imports::set_picture(Upload& upload, std::string_view name, const Picture& picture)
{
    const Result<ImportTexture*> found = find(name);
    if (!found)
        return tl::unexpected(found.error());
    ImportTexture& texture = **found;
    if (texture.is_cube())
        return fail(wrong_kind(texture.import, "picture"));
    if (picture.extent != texture.import.extent)
        return fail(wrong_extent(texture.import, picture.extent));
    upload.watch.enter(fmt::format("import `{}`", name));
    if (!texture.owned || texture.has_levels != texture.wants_levels) {
        TextureObject made = create_picture(upload, picture.extent, texture.wants_levels);
        upload.watch.leave();
        if (Errors errors = upload.watch.take(); !errors.empty())
            return tl::unexpected(std::move(errors));
        upload.watch.enter(fmt::format("import `{}`", name));
        texture.owned = std::move(made);
        texture.has_levels = texture.wants_levels;
    }
    texture.id = texture.owned.id();
    texture.version = next_version();
    fill_picture(upload, texture.id, to_rgba(picture, texture.import.signal, upload.scrubs_imports), texture.has_levels);
    upload.watch.check();
    upload.watch.leave();
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

Result<void> Imports::set_cube(Upload& upload, std::string_view name, const std::array<Picture, 6>& faces)
{
    const Result<ImportTexture*> found = find(name);
    if (!found)
        return tl::unexpected(found.error());
    ImportTexture& texture = **found;
    if (!texture.is_cube())
        return fail(wrong_kind(texture.import, "cube map"));
    const auto rgba = cube_faces(faces, texture.import.signal, fmt::format("`{}`", name), upload.driver.limits, upload.scrubs_imports);
    if (!rgba)
        return tl::unexpected(rgba.error());
    double brightest = 0.0;
    for (const Picture& face : *rgba)
        for (size_t i = 0; i < face.texels.size(); ++i)
            brightest = i % 4 == 3 ? brightest : std::max(brightest, static_cast<double>(face.texels[i]));
    upload.watch.enter(fmt::format("import `{}`", name));
    Cube made = create_cube(upload, *rgba);
    upload.watch.check();
    upload.watch.leave();
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    texture.owned = std::move(made.texture);
    texture.harmonics = made.harmonics;
    texture.brightest = brightest;
    texture.id = texture.owned.id();
    texture.version = next_version();
    texture.has_levels = true;
    return {};
}

Result<void> Imports::set_host_texture(Upload& upload, std::string_view name, const HostTexture& host)
{
    const Result<ImportTexture*> found = find(name);
    if (!found)
        return tl::unexpected(found.error());
    ImportTexture& texture = **found;
    if (upload.driver.gl.IsTexture(host.id) != GL_TRUE)
        return fail({.code = "texture_missing",
                     .message = fmt::format("`{}`: there is no texture {} in the current context", name, host.id),
                     .hint = "bind the texture once after glGenTextures, in this context or one that shares with it"});
    if (!texture.is_cube() && host.extent != texture.import.extent)
        return fail(wrong_extent(texture.import, host.extent));
    texture.owned = {};
    texture.id = host.id;
    texture.version = host.version == 0 ? 0 : hosts_version(host.version);
    texture.has_levels = (texture.wants_levels || texture.is_cube()) && is_level_there(upload, texture, 1);
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

Errors Imports::find_missing() const
{
    Errors errors;
    for (const ImportTexture& texture : textures_)
        if (texture.id == 0 && !texture.import.is_of_scene())
            errors.push_back({.code = "import_missing",
                              .message = fmt::format("nothing was imported as `{}`", texture.import.name),
                              .hint = texture.is_cube() ? "call import_cube before render"
                                                        : "call import_picture or import_texture before render"});
    return errors;
}

} // namespace passgraph::gl
