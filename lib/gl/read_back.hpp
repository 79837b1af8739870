// Texels from a texture into memory.
#pragma once

#include <passgraph/core/codec.hpp>
#include <passgraph/core/picture.hpp>

#include "gl/textures.hpp"

namespace passgraph::gl {

/// A rectangle of texels, from the bottom left.
struct Rectangle {
    int x = 0;
    int y = 0;
    Extent extent{};
};

/// Reads textures back through a framebuffer of its own.
class Reader {
public:
    /// Finds out with one texel whether this driver hands out sRGB texels as codes or as linear values.
    explicit Reader(Upload& upload);

    /// Shape    the window's extent, the window inside the texture; 4 channels, 1 for depth formats.
    /// Range    what a shader would fetch: sRGB texels are linear.
    /// Errors   framebuffer_incomplete, gl_error.
    Result<Picture> read(Upload& upload, GLuint texture, Format format, const Rectangle& window) const;

private:
    Result<Picture> read_raw(Upload& upload, GLuint texture, Format format, const Rectangle& window) const;

    FramebufferObject framebuffer_;
    bool hands_out_codes_ = true;
};

} // namespace passgraph::gl
