// Contexts of a window, hidden unless asked otherwise, by GLFW.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/format.h>

#include "context/glfw.hpp"
#include "context/kinds.hpp"

namespace passgraph::context_kinds
{

namespace
{

/// Windows that exist; GLFW is initialized while there are any. GLFW wants all of this on the main thread.
int windows = 0;

ContextError lack(std::string_view what)
{
    const char* description = nullptr;
    glfwGetError(&description);
    return {fmt::format("glfw: {}{}{}", what, description ? ": " : "", description ? description : ""),
            "run with a display, e.g. under Xvfb (xvfb-run), or use --context osmesa"};
}

void release_glfw()
{
    if (--windows == 0)
        glfwTerminate();
}

void* load_gl(const char* function)
{
    return reinterpret_cast<void*>(glfwGetProcAddress(function));
}

class GlfwContext final : public Context
{
public:
    explicit GlfwContext(GLFWwindow* window) : window_(window) {}
    ~GlfwContext() override
    {
        release();
        glfwDestroyWindow(window_);
        release_glfw();
    }

    bool make_current() override
    {
        before_made_current(*this);
        glfwMakeContextCurrent(window_);
        const bool is_done = glfwGetCurrentContext() == window_;
        if (!is_done)
            release(); // a refused context must not leave the one before behind unnoticed
        return is_done;
    }
    void release() override
    {
        if (after_released(*this))
            glfwMakeContextCurrent(nullptr);
    }
    GlLoader loader() const override { return load_gl; }
    ContextKind kind() const override { return ContextKind::glfw; }
    GLFWwindow* window() const { return window_; }

private:
    GLFWwindow* window_;
};

GLFWwindow* create_window(const ContextOptions& options)
{
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    for (const auto& [major, minor] : kVersions) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        if (GLFWwindow* const window =
                glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr))
            return window;
    }
    return nullptr;
}

} // namespace

GLFWwindow* window_of(const Context& context)
{
    return static_cast<const GlfwContext&>(context).window();
}

Created create_glfw(const ContextOptions& options)
{
    if (!glfwInit())
        return tl::unexpected(lack("no display can be opened"));
    ++windows;
    // glfwCreateWindow makes the new context current for a moment, which is not allowed on top of another kind's.
    release_other_kinds(ContextKind::glfw);
    GLFWwindow* const window = create_window(options);
    if (!window) {
        const ContextError error = lack("no window with OpenGL 3.3 core can be made");
        release_glfw();
        return tl::unexpected(error);
    }
    return std::make_unique<GlfwContext>(window);
}

} // namespace passgraph::context_kinds
