// Saving and restoring of the host's GL state.
#include "gl/state_guard.hpp"

namespace passgraph::gl {
namespace {

/// What steps switch, or the baseline switches on.
constexpr std::array<GLenum, 4> kSwitches = {GL_DEPTH_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB,
                                             GL_TEXTURE_CUBE_MAP_SEAMLESS};

GLuint name_of(GLint value)
{
    return static_cast<GLuint>(value);
}

} // namespace

StateGuard::StateGuard(const Driver& driver, Units units)
    : gl_(driver.gl), program_(get(GL_CURRENT_PROGRAM)), draw_framebuffer_(get(GL_DRAW_FRAMEBUFFER_BINDING)),
      read_framebuffer_(get(GL_READ_FRAMEBUFFER_BINDING)), vertex_array_(get(GL_VERTEX_ARRAY_BINDING)),
      active_texture_(get(GL_ACTIVE_TEXTURE)), array_buffer_(get(GL_ARRAY_BUFFER_BINDING)),
      texture_buffer_(get(GL_TEXTURE_BUFFER)), uniform_buffer_(get(GL_UNIFORM_BUFFER_BINDING)),
      pack_buffer_(get(GL_PIXEL_PACK_BUFFER_BINDING)), unpack_buffer_(get(GL_PIXEL_UNPACK_BUFFER_BINDING)),
      depth_func_(get(GL_DEPTH_FUNC)), cull_mode_(get(GL_CULL_FACE_MODE)), front_face_(get(GL_FRONT_FACE)),
      clamp_read_color_(get(GL_CLAMP_READ_COLOR))
{
    for (size_t i = 0; i < enabled_.size(); ++i)
        enabled_[i] = gl_.IsEnabled(kAlwaysOff[i]) == GL_TRUE;
    for (size_t i = 0; i < switches_.size(); ++i)
        switches_[i] = gl_.IsEnabled(kSwitches[i]) == GL_TRUE;
    for (GLuint i = 0; i < kDrawBuffers; ++i) {
        blends_[i] = gl_.IsEnabledi(GL_BLEND, i) == GL_TRUE;
        gl_.GetBooleani_v(GL_COLOR_WRITEMASK, i, color_masks_[i].data());
    }
    for (size_t i = 0; i < pixel_stores_.size(); ++i)
        pixel_stores_[i] = get(kPixelStores[i].name);
    for (GLuint i = 0; i < kUniformBufferCount; ++i) {
        gl_.GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, i, &uniform_buffers_[i].buffer);
        gl_.GetInteger64i_v(GL_UNIFORM_BUFFER_START, i, &uniform_buffers_[i].start);
        gl_.GetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, i, &uniform_buffers_[i].size);
    }
    gl_.GetIntegerv(GL_VIEWPORT, viewport_.data());
    // A core context answers with one value, a compatibility context with two.
    gl_.GetIntegerv(GL_POLYGON_MODE, polygon_mode_.data());
    gl_.GetDoublev(GL_DEPTH_RANGE, depth_range_.data());
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    if (gl_.ClipControl != nullptr) {
        clip_origin_ = get(GL_CLIP_ORIGIN);
        clip_depth_ = get(GL_CLIP_DEPTH_MODE);
    }
    save_units(units.textures);
    save_image_units(units.images);
}

StateGuard::~StateGuard()
{
    restore_units();
    restore_image_units();
    restore_bindings();
    restore_fixed_state();
}

GLint StateGuard::get(GLenum name) const
{
    GLint value = 0;
    gl_.GetIntegerv(name, &value);
    return value;
}

void StateGuard::set_enabled(GLenum capability, bool is_on) const
{
    if (is_on)
        gl_.Enable(capability);
    else
        gl_.Disable(capability);
}

void StateGuard::save_units(int units)
{
    units_.resize(static_cast<size_t>(units));
    for (size_t i = 0; i < units_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        units_[i] = {get(GL_TEXTURE_BINDING_2D), get(GL_TEXTURE_BINDING_CUBE_MAP), get(GL_TEXTURE_BINDING_BUFFER),
                     get(GL_SAMPLER_BINDING)};
    }
}

void StateGuard::restore_units() const
{
    for (size_t i = 0; i < units_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        // The host may have bound an output of ours that `replace` has deleted since.
        const GLuint texture_2d = name_of(units_[i].texture_2d);
        gl_.BindTexture(GL_TEXTURE_2D, gl_.IsTexture(texture_2d) == GL_TRUE ? texture_2d : 0);
        gl_.BindTexture(GL_TEXTURE_CUBE_MAP, name_of(units_[i].cube));
        gl_.BindTexture(GL_TEXTURE_BUFFER, name_of(units_[i].buffer));
        gl_.BindSampler(static_cast<GLuint>(i), name_of(units_[i].sampler));
    }
    gl_.ActiveTexture(static_cast<GLenum>(active_texture_));
}

void StateGuard::save_image_units(int units)
{
    image_units_.resize(static_cast<size_t>(units));
    for (GLuint i = 0; i < image_units_.size(); ++i) {
        ImageUnit& unit = image_units_[i];
        gl_.GetIntegeri_v(GL_IMAGE_BINDING_NAME, i, &unit.texture);
        gl_.GetIntegeri_v(GL_IMAGE_BINDING_LEVEL, i, &unit.level);
        gl_.GetIntegeri_v(GL_IMAGE_BINDING_LAYERED, i, &unit.is_layered);
        gl_.GetIntegeri_v(GL_IMAGE_BINDING_LAYER, i, &unit.layer);
        gl_.GetIntegeri_v(GL_IMAGE_BINDING_ACCESS, i, &unit.access);
        gl_.GetIntegeri_v(GL_IMAGE_BINDING_FORMAT, i, &unit.format);
    }
}

void StateGuard::restore_image_units() const
{
    for (GLuint i = 0; i < image_units_.size(); ++i) {
        const ImageUnit& was = image_units_[i];
        const GLuint texture = name_of(was.texture); // the host's, or an output of ours that `replace` has deleted since
        gl_.BindImageTexture(i, gl_.IsTexture(texture) == GL_TRUE ? texture : 0, was.level, was.is_layered != 0 ? GL_TRUE : GL_FALSE,
                             was.layer, static_cast<GLenum>(was.access), static_cast<GLenum>(was.format));
    }
}

void StateGuard::restore_bindings() const
{
    gl_.UseProgram(name_of(program_));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name_of(draw_framebuffer_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, name_of(read_framebuffer_));
    gl_.BindVertexArray(name_of(vertex_array_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, name_of(array_buffer_));
    gl_.BindBuffer(GL_TEXTURE_BUFFER, name_of(texture_buffer_));
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, name_of(pack_buffer_));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, name_of(unpack_buffer_));
    for (GLuint i = 0; i < kUniformBufferCount; ++i) {
        const UniformBuffer& was = uniform_buffers_[i];
        if (was.size > 0)
            gl_.BindBufferRange(GL_UNIFORM_BUFFER, i, name_of(was.buffer), static_cast<GLintptr>(was.start),
                                static_cast<GLsizeiptr>(was.size));
        else
            gl_.BindBufferBase(GL_UNIFORM_BUFFER, i, name_of(was.buffer));
    }
    gl_.BindBuffer(GL_UNIFORM_BUFFER, name_of(uniform_buffer_)); // the indexed calls above change this one too
}

void StateGuard::restore_fixed_state() const
{
    for (size_t i = 0; i < enabled_.size(); ++i)
        set_enabled(kAlwaysOff[i], enabled_[i]);
    for (size_t i = 0; i < switches_.size(); ++i)
        set_enabled(kSwitches[i], switches_[i]);
    for (GLuint i = 0; i < kDrawBuffers; ++i) {
        if (blends_[i])
            gl_.Enablei(GL_BLEND, i);
        else
            gl_.Disablei(GL_BLEND, i);
        gl_.ColorMaski(i, color_masks_[i][0], color_masks_[i][1], color_masks_[i][2], color_masks_[i][3]);
    }
    for (size_t i = 0; i < pixel_stores_.size(); ++i)
        gl_.PixelStorei(kPixelStores[i].name, pixel_stores_[i]);
    gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl_.PolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygon_mode_[0]));
    gl_.DepthRange(depth_range_[0], depth_range_[1]);
    gl_.DepthMask(depth_mask_);
    gl_.DepthFunc(static_cast<GLenum>(depth_func_));
    gl_.CullFace(static_cast<GLenum>(cull_mode_));
    gl_.FrontFace(static_cast<GLenum>(front_face_));
    gl_.ClampColor(GL_CLAMP_READ_COLOR, static_cast<GLenum>(clamp_read_color_));
    if (gl_.ClipControl != nullptr)
        gl_.ClipControl(static_cast<GLenum>(clip_origin_), static_cast<GLenum>(clip_depth_));
}

} // namespace passgraph::gl
