// glReadPixels, and what sRGB needs beside it.
#include "gl/read_back.hpp"

#include <cmath>

namespace passgraph::gl {
namespace {

/// IEC 61966-2-1, in double so that a code gives the nearest float.
float linear_from_srgb(float code)
{
    const double x = static_cast<double>(code);
    return static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
}

} // namespace

Reader::Reader(Upload& upload) : framebuffer_(upload.driver)
{
    // 3.3 calls a framebuffer incomplete whose draw buffer names an empty attachment.
    constexpr GLenum kNone = GL_NONE;
    upload.state.draw_framebuffer(framebuffer_.id());
    upload.driver.gl.DrawBuffers(1, &kNone);
    // OpenGL 3.3 does not say whether glReadPixels decodes. Code 128 is 0.50 as it stands and 0.22 when decoded.
    const TextureObject probe(upload.driver);
    upload.state.edit_texture(GL_TEXTURE_2D, probe.id());
    constexpr std::uint8_t kTexel[] = {128, 128, 128, 255};
    upload.driver.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexel);
    const Result<Picture> texel = read_raw(upload, probe.id(), Format::srgb8_a8, {0, 0, {1, 1}});
    hands_out_codes_ = !texel || texel->texels[0] > 0.35f;
    upload.state.edit_texture(GL_TEXTURE_2D, 0); // the probe's name may be given to another texture
}

Result<Picture> Reader::read(Upload& upload, GLuint texture, Format format, const Rectangle& window) const
{
    Result<Picture> raw = read_raw(upload, texture, format, window);
    if (raw && format == Format::srgb8_a8 && hands_out_codes_)
        for (size_t i = 0; i < raw->texels.size(); ++i)
            if (i % 4 != 3) // alpha is stored as it is
                raw->texels[i] = linear_from_srgb(raw->texels[i]);
    return raw;
}

Result<Picture> Reader::read_raw(Upload& upload, GLuint texture, Format format, const Rectangle& window) const
{
    const Functions& gl = upload.driver.gl;
    const bool reads_depth = is_depth(format);
    const GLenum attachment = reads_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    gl.ReadBuffer(reads_depth ? GL_NONE : GL_COLOR_ATTACHMENT0);
    Picture picture(window.extent, reads_depth ? 1 : 4);
    const bool is_complete = gl.CheckFramebufferStatus(GL_READ_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (is_complete)
        gl.ReadPixels(window.x, window.y, window.extent.width, window.extent.height, reads_depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT,
                      picture.texels.data());
    gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER, attachment, GL_TEXTURE_2D, 0, 0);
    if (!is_complete)
        return fail({.code = "framebuffer_incomplete",
                     .message = "a texture of this format cannot be read back",
                     .hint = "import a texture of a color-renderable format",
                     .fault = Fault::machine});
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return picture;
}

} // namespace passgraph::gl
