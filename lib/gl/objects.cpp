// Creation, counting and deletion of GL objects; the limits of a context.
#include "gl/objects.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

int query_limit(const Functions& gl, GLenum name)
{
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

std::string_view query_text(const Functions& gl, GLenum name)
{
    const GLubyte* text = gl.GetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

/// Of 1280x720 texels of halves, llvmpipe loads all in 0.45 ms, and fetches all through a nearest sampler in 0.65, by texelFetch
/// in 1.1.  A graphics card has caches for samplers, and may keep what is loaded from uncompressed.
bool loads_quicker_than_it_samples(const Driver& driver) { return driver.device_name.starts_with("llvmpipe"); }

} // namespace

Result<Driver> create_driver(GlLoader loader)
{
    Result<Functions> functions = load_functions(loader);
    if (!functions)
        return tl::unexpected(functions.error());
    Driver driver{.gl = *functions, .limits = {}, .device_name = {}};
    const Functions& gl = driver.gl;
    driver.limits.texture_size = query_limit(gl, GL_MAX_TEXTURE_SIZE);
    driver.limits.cube_size = query_limit(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    driver.limits.texture_units = query_limit(gl, GL_MAX_TEXTURE_IMAGE_UNITS);
    driver.limits.color_targets =
        std::min(query_limit(gl, GL_MAX_DRAW_BUFFERS), query_limit(gl, GL_MAX_COLOR_ATTACHMENTS));
    driver.limits.varying_components = query_limit(gl, GL_MAX_VARYING_COMPONENTS);
    if (gl.BindImageTexture != nullptr)
        driver.limits.image_units = std::min(query_limit(gl, GL_MAX_IMAGE_UNITS), query_limit(gl, GL_MAX_FRAGMENT_IMAGE_UNIFORMS));
    driver.limits.texture_buffer_texels = query_limit(gl, GL_MAX_TEXTURE_BUFFER_SIZE);
    driver.device_name = fmt::format("{}, OpenGL {}", query_text(gl, GL_RENDERER), query_text(gl, GL_VERSION));
    return driver;
}

GLuint create_object(Driver& driver, ObjectKind kind, GLenum detail)
{
    const Functions& gl = driver.gl;
    GLuint id = 0;
    switch (kind) {
    case ObjectKind::texture: gl.GenTextures(1, &id); break;
    case ObjectKind::framebuffer: gl.GenFramebuffers(1, &id); break;
    case ObjectKind::sampler: gl.GenSamplers(1, &id); break;
    case ObjectKind::vertex_array: gl.GenVertexArrays(1, &id); break;
    case ObjectKind::buffer: gl.GenBuffers(1, &id); break;
    case ObjectKind::query: gl.GenQueries(1, &id); break;
    case ObjectKind::program: id = gl.CreateProgram(); break;
    case ObjectKind::shader: id = gl.CreateShader(detail); break;
    }
    ++driver.objects_created;
    return id;
}

void delete_object(Driver& driver, ObjectKind kind, GLuint id)
{
    const Functions& gl = driver.gl;
    switch (kind) {
    case ObjectKind::texture: gl.DeleteTextures(1, &id); break;
    case ObjectKind::framebuffer: gl.DeleteFramebuffers(1, &id); break;
    case ObjectKind::sampler: gl.DeleteSamplers(1, &id); break;
    case ObjectKind::vertex_array: gl.DeleteVertexArrays(1, &id); break;
    case ObjectKind::buffer: gl.DeleteBuffers(1, &id); break;
    case ObjectKind::query: gl.DeleteQueries(1, &id); break;
    case ObjectKind::program: gl.DeleteProgram(id); break;
    case ObjectKind::shader: gl.DeleteShader(id); break;
    }
}

} // namespace passgraph::gl

namespace passgraph {

Result<Device> query_device(GlLoader loader)
{
    const Result<gl::Driver> driver = gl::create_driver(loader);
    if (!driver)
        return tl::unexpected(driver.error());
    return Device{.max_texture_size = driver->limits.texture_size,
                  .max_texture_units = driver->limits.texture_units,
                  .max_color_targets = driver->limits.color_targets,
                  .max_varying_components = driver->limits.varying_components,
                  .max_loaded_images = gl::loads_quicker_than_it_samples(*driver) ? driver->limits.image_units : 0};
}

} // namespace passgraph
