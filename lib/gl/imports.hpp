// The pictures, cube maps and host textures that a plan reads from outside.
#pragma once

#include <string_view>
#include <vector>

#include <passgraph/core/plan.hpp>

#include "gl/textures.hpp"

namespace passgraph::gl {

/// One import of a plan, and the texture that stands for it; `id` 0 is "not supplied yet".
struct ImportTexture {
    Plan::Import import;
    bool wants_levels = false; ///< a step samples it with mip levels
    bool has_levels = false;
    GLuint id = 0;
    std::uint64_t version = 0; ///< another whenever the host supplies anew; 0: may change any time
    TextureObject owned{}; ///< empty for a host's own texture
    Harmonics harmonics{}; ///< of a cube
    double brightest = Facts::kUnknown; ///< component of a cube

    bool is_cube() const { return import.kind == Plan::Import::Kind::cube || import.kind == Plan::Import::Kind::sky; }
    GLenum target() const { return is_cube() ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D; }
};

class Imports {
public:
    explicit Imports(const Plan& plan);

    /// Takes over what an older plan was given, where name, kind, signal and extent are the same.
    void adopt(Upload& upload, Imports&& old);
    /// Reads the same textures as another plan, which goes on owning them.
    void borrow(const Imports& other);

    /// Errors   unknown_import, import_extent, wrong_import_kind, gl_error, out_of_memory.
    Result<void> set_picture(Upload& upload, std::string_view name, const Picture& picture);
    /// Errors   unknown_import, wrong_import_kind, and those of cube_faces.
    Result<void> set_cube(Upload& upload, std::string_view name, const std::array<Picture, 6>& faces);
    /// Errors   unknown_import, import_extent, texture_missing (no such texture in this context).
    Result<void> set_host_texture(Upload& upload, std::string_view name, const HostTexture& texture);

    /// import_missing for each import without a texture; a sky may be absent.
    Errors find_missing() const;

    const ImportTexture& operator[](int index) const { return textures_[static_cast<size_t>(index)]; }

private:
    Result<ImportTexture*> find(std::string_view name);

    std::vector<ImportTexture> textures_;
};

} // namespace passgraph::gl
