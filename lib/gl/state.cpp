// The state cache, and the state that every step shares.
#include "gl/state.hpp"

#include "gl/state_names.hpp"

namespace passgraph::gl {

State::State(const Driver& driver)
    : driver_(driver), units_(static_cast<size_t>(driver.limits.texture_units)),
      image_units_(static_cast<size_t>(driver.limits.image_units)), uniform_buffers_(kUniformBufferCount)
{
}

template <class T> bool State::changes(T& known, T wanted)
{
    if (known == wanted) {
        ++redundant_;
        return false;
    }
    known = wanted;
    ++issued_;
    return true;
}

void State::reset()
{
    units_.assign(units_.size(), {});
    image_units_.assign(image_units_.size(), {});
    uniform_buffers_.assign(uniform_buffers_.size(), kUnknown);
    program_ = framebuffer_ = vertex_array_ = kUnknown;
    active_unit_ = -1;
    viewport_ = {-1, -1};
    depth_.reset();
    cull_ = mirrored_ = srgb_ = Switch::unknown;
    set_fixed_state();
}

void State::set_fixed_state()
{
    const Functions& gl = driver_.gl;
    for (const GLenum capability : kAlwaysOff)
        gl.Disable(capability);
    gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.CullFace(GL_BACK);
    if (gl.ClipControl != nullptr)
        gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.ClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const PixelStore& row : kPixelStores)
        gl.PixelStorei(row.name, row.value);
    issued_ += static_cast<std::int64_t>(std::size(kAlwaysOff) + std::size(kPixelStores)) + 9;
}

void State::enable(GLenum capability, bool is_on)
{
    if (is_on)
        driver_.gl.Enable(capability);
    else
        driver_.gl.Disable(capability);
}

void State::use_program(GLuint program)
{
    if (changes(program_, program))
        driver_.gl.UseProgram(program);
}

void State::draw_framebuffer(GLuint framebuffer)
{
    if (changes(framebuffer_, framebuffer))
        driver_.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
}

void State::viewport(Extent extent)
{
    if (changes(viewport_, extent))
        driver_.gl.Viewport(0, 0, extent.width, extent.height);
}

void State::vertex_array(GLuint vertex_array)
{
    if (changes(vertex_array_, vertex_array))
        driver_.gl.BindVertexArray(vertex_array);
}

void State::active_unit(int unit)
{
    if (changes(active_unit_, unit))
        driver_.gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
}

void State::texture(int unit, GLenum target, GLuint texture)
{
    Unit& known = units_[static_cast<size_t>(unit)];
    GLuint& bound = target == GL_TEXTURE_2D       ? known.texture_2d
                    : target == GL_TEXTURE_BUFFER ? known.buffer
                                                  : known.cube;
    if (!changes(bound, texture))
        return;
    active_unit(unit);
    driver_.gl.BindTexture(target, texture);
}

void State::sampler(int unit, GLuint sampler)
{
    if (changes(units_[static_cast<size_t>(unit)].sampler, sampler))
        driver_.gl.BindSampler(static_cast<GLuint>(unit), sampler);
}

void State::image(int unit, GLuint texture, GLenum format)
{
    if (changes(image_units_[static_cast<size_t>(unit)], {texture, format}))
        driver_.gl.BindImageTexture(static_cast<GLuint>(unit), texture, 0, GL_FALSE, 0, GL_READ_ONLY, format);
}

void State::uniform_buffer(int binding, GLuint buffer)
{
    if (changes(uniform_buffers_[static_cast<size_t>(binding)], buffer))
        driver_.gl.BindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer);
}

void State::depth(Depth use)
{
    if (!changes(depth_, std::optional(use)))
        return;
    const Functions& gl = driver_.gl;
    enable(GL_DEPTH_TEST, use != Depth::unused);
    gl.DepthMask(use == Depth::tested_and_written ? GL_TRUE : GL_FALSE);
    // Reversed: 1 near, 0 far and where nothing is. A full-screen triangle is put at 0 by its range, whatever the clip
    // space's depth is.
    gl.DepthRange(0.0, use == Depth::tested_and_written ? 1.0 : 0.0);
    gl.DepthFunc(use == Depth::surfaces ? GL_LESS : use == Depth::background ? GL_EQUAL : GL_GREATER);
}

void State::cull_back_faces(bool is_on)
{
    if (changes(cull_, is_on))
        enable(GL_CULL_FACE, is_on);
}

void State::mirrored_front_face(bool is_mirrored)
{
    if (changes(mirrored_, is_mirrored))
        driver_.gl.FrontFace(is_mirrored ? GL_CW : GL_CCW);
}

void State::encodes_srgb(bool is_on)
{
    if (changes(srgb_, is_on))
        enable(GL_FRAMEBUFFER_SRGB, is_on);
}

void State::edit_texture(GLenum target, GLuint texture)
{
    active_unit(0);
    this->texture(0, target, texture);
}

} // namespace passgraph::gl
