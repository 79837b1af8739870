// glGetError and KHR_debug, turned into error values.
#include "gl/error_watch.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

// A lost context reports an error for ever.
constexpr int kMostErrors = 16;
// Drivers refuse longer ones, some from 256 letters on.
constexpr size_t kLongestGroupName = 200;

std::string_view error_name(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "an unknown GL error";
    }
}

void set_enabled(const Functions& gl, GLenum capability, bool is_on)
{
    if (is_on)
        gl.Enable(capability);
    else
        gl.Disable(capability);
}

} // namespace

ErrorWatch::ErrorWatch(const Driver& driver) : gl_(driver.gl)
{
    for (int i = 0; i < kMostErrors && gl_.GetError() != GL_NO_ERROR; ++i) {
    }
    if (!gl_.has_debug)
        return;
    gl_.GetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &old_callback_);
    gl_.GetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &old_argument_);
    was_output_ = gl_.IsEnabled(GL_DEBUG_OUTPUT) == GL_TRUE;
    was_synchronous_ = gl_.IsEnabled(GL_DEBUG_OUTPUT_SYNCHRONOUS) == GL_TRUE;
    gl_.DebugMessageCallback(&ErrorWatch::receive, this);
    gl_.Enable(GL_DEBUG_OUTPUT);
    gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
}

ErrorWatch::~ErrorWatch()
{
    if (!gl_.has_debug)
        return;
    gl_.DebugMessageCallback(reinterpret_cast<GLDEBUGPROC>(old_callback_), old_argument_);
    set_enabled(gl_, GL_DEBUG_OUTPUT, was_output_);
    set_enabled(gl_, GL_DEBUG_OUTPUT_SYNCHRONOUS, was_synchronous_);
}

void ErrorWatch::enter(std::string subject)
{
    subject_ = std::move(subject);
    if (gl_.has_debug)
        gl_.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0,
                           static_cast<GLsizei>(std::min(subject_.size(), kLongestGroupName)), subject_.c_str());
}

void ErrorWatch::leave()
{
    if (gl_.has_debug)
        gl_.PopDebugGroup();
    if (!words_.empty())
        check();
    subject_.clear();
}

void ErrorWatch::check()
{
    for (int i = 0; i < kMostErrors; ++i) {
        const GLenum error = gl_.GetError();
        if (error == GL_NO_ERROR)
            break;
        const std::string words = words_.empty() ? std::string(error_name(error)) : std::exchange(words_, {});
        add(error == GL_OUT_OF_MEMORY ? "out_of_memory" : "gl_error", words);
    }
    if (!words_.empty())
        add("gl_error", std::exchange(words_, {}));
}

Errors ErrorWatch::take()
{
    check();
    return std::exchange(errors_, {});
}

void ErrorWatch::add(std::string code, std::string_view words)
{
    if (errors_.size() >= kMostErrors)
        return;
    Error error{.code = std::move(code),
                .message = fmt::format("{}: {}", subject_.empty() ? "the frame" : subject_, words),
                .fault = Fault::machine};
    if (error.code == "out_of_memory")
        error.hint = "use smaller extents or codecs of fewer bytes";
    errors_.push_back(std::move(error));
}

void APIENTRY ErrorWatch::receive(GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                                  const void* watch)
{
    // The compiler's complaints come with its log, which has the lines.
    if (type != GL_DEBUG_TYPE_ERROR || source != GL_DEBUG_SOURCE_API)
        return;
    std::string& words = const_cast<ErrorWatch*>(static_cast<const ErrorWatch*>(watch))->words_;
    if (words.empty())
        words = message;
}

} // namespace passgraph::gl
