// Looks up the OpenGL functions by name, after asking the context how new it is.
#include "gl/functions.hpp"

#include <string_view>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

template <class Function> bool load(GlLoader loader, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(loader(name));
    return function != nullptr;
}

Error missing_function(std::string_view name)
{
    return {.code = "gl_function_missing",
            .message = fmt::format("the OpenGL driver has no function `{}`", name),
            .hint = "OpenGL 3.3 core is needed, and a context must be current",
            .fault = Fault::machine};
}

bool has_extension(const Functions& gl, std::string_view wanted)
{
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* name = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name != nullptr && wanted == reinterpret_cast<const char*>(name))
            return true;
    }
    return false;
}

/// A loader may return addresses of functions the context lacks, so the version or the extension decides, not the
/// pointer.
void load_optional(GlLoader loader, int version, Functions& gl)
{
    if (version >= 45 || has_extension(gl, "GL_ARB_clip_control"))
        load(loader, "glClipControl", gl.ClipControl);
    if (version >= 42 || has_extension(gl, "GL_ARB_shader_image_load_store"))
        load(loader, "glBindImageTexture", gl.BindImageTexture);
    gl.has_conservative_queries = version >= 43 || has_extension(gl, "GL_ARB_ES3_compatibility");
    gl.has_inverted_conditions = version >= 45 || has_extension(gl, "GL_ARB_conditional_render_inverted");
    if (version >= 43 || has_extension(gl, "GL_KHR_debug")) {
        gl.has_debug = true;
#define PASSGRAPH_GL_LOAD(type, name) gl.has_debug = load(loader, "gl" #name, gl.name) && gl.has_debug;
        PASSGRAPH_GL_DEBUG_FUNCTIONS(PASSGRAPH_GL_LOAD)
#undef PASSGRAPH_GL_LOAD
    }
}

} // namespace

Result<Functions> load_functions(GlLoader loader)
{
    Functions gl;
    if (loader == nullptr || !load(loader, "glGetString", gl.GetString))
        return fail(missing_function("glGetString"));
    if (!load(loader, "glGetIntegerv", gl.GetIntegerv))
        return fail(missing_function("glGetIntegerv"));
    // An older context does not know these two names and leaves the zeros.
    GLint major = 0;
    GLint minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    const int version = major * 10 + minor;
    if (version < 33) {
        const GLubyte* text = gl.GetString(GL_VERSION);
        return fail({.code = "gl_too_old",
                     .message = fmt::format("the context offers OpenGL `{}`, 3.3 core is needed",
                                            text == nullptr ? "none" : reinterpret_cast<const char*>(text)),
                     .hint = "ask for a 3.3 core context, or update the driver",
                     .fault = Fault::machine});
    }
    Errors errors;
#define PASSGRAPH_GL_LOAD(type, name)                                                                                  \
    if (!load(loader, "gl" #name, gl.name))                                                                            \
        errors.push_back(missing_function("gl" #name));
    PASSGRAPH_GL_FUNCTIONS(PASSGRAPH_GL_LOAD)
#undef PASSGRAPH_GL_LOAD
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    load_optional(loader, version, gl);
    return gl;
}

} // namespace passgraph::gl
