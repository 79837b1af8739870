// Collects what the driver complains about, and which step or upload it was.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gl/objects.hpp"

namespace passgraph::gl {

/// Watches the driver during one public call of the renderer.
///
/// The errors that the host left in the queue are dropped when it is made. Where KHR_debug exists its callback tells
/// the driver's own words; the host's callback is put back at the end.
class ErrorWatch {
public:
    explicit ErrorWatch(const Driver& driver);
    ~ErrorWatch();
    ErrorWatch(const ErrorWatch&) = delete;
    ErrorWatch& operator=(const ErrorWatch&) = delete;

    /// What follows belongs to `subject` ("step `glow`"); also a debug group where there are some.
    void enter(std::string subject);
    void leave();
    /// Asks the driver now.
    void check();
    /// Everything so far: gl_error, or out_of_memory.
    Errors take();

private:
    static void APIENTRY receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                 const GLchar* message, const void* watch);
    void add(std::string code, std::string_view words);

    const Functions& gl_;
    std::string subject_;
    std::string words_; ///< of the driver, since the last check
    Errors errors_;
    void* old_callback_ = nullptr;
    void* old_argument_ = nullptr;
    bool was_output_ = false;
    bool was_synchronous_ = false;
};

} // namespace passgraph::gl
