// A GLFW window: events in order, full screen, and ImGui's back ends.
#include "passgraph/context/window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include "context/glfw.hpp"
#include "context/theme.hpp"

namespace passgraph {
namespace {

/// The letter or digit printed on the key, which depends on the keyboard; else the one at its place on a US keyboard.
int printed_key(int key, int scancode)
{
    switch (key) {
    case GLFW_KEY_ESCAPE: return WindowEvent::escape;
    case GLFW_KEY_TAB: return WindowEvent::tab;
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT: return WindowEvent::shift;
    default: break;
    }
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) // some keyboards print digits above others
        return key;
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return '0' + key - GLFW_KEY_KP_0;
    const char* name = glfwGetKeyName(key, scancode);
    if (name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0')
        return name[0] - 'a' + 'A';
    return key >= GLFW_KEY_A && key <= GLFW_KEY_Z ? key : 0;
}

} // namespace

class Window::Impl {
public:
    Impl(std::unique_ptr<Context> context, const WindowOptions& options)
        : context_(std::move(context)), window_(context_kinds::window_of(*context_))
    {
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
            self(w).take_key(key, scancode, action, mods);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) { self(w).take_button(button, action); });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { self(w).take_pointer(x, y); });
        glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int has_focus) {
            if (!has_focus)
                self(w).events_.push_back({.kind = WindowEvent::Kind::focus_lost});
        });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { self(w).is_damaged_ = true; });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { self(w).is_damaged_ = true; });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w).is_damaged_ = true; });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w).is_damaged_ = true; });
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        context_kinds::set_theme(options);
        ImGui_ImplGlfw_InitForOpenGL(window_, true); // calls ours after its own
        ImGui_ImplOpenGL3_Init("#version 330 core");
        glfwSwapInterval(1);
    }
    ~Impl()
    {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }

    static Impl& self(GLFWwindow* window) { return *static_cast<Impl*>(glfwGetWindowUserPointer(window)); }

    void take_key(int key, int scancode, int action, int mods)
    {
        const int printed = printed_key(key, scancode);
        if (printed == 0 || action == GLFW_REPEAT)
            return;
        // A key that goes up is always told, or what it moves would never stop.
        if (action == GLFW_PRESS && (ImGui::GetIO().WantTextInput || (mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0))
            return;
        events_.push_back({.kind = action == GLFW_PRESS ? WindowEvent::Kind::key_down : WindowEvent::Kind::key_up,
                           .key = printed,
                           .with_shift = (mods & GLFW_MOD_SHIFT) != 0});
    }

    void take_button(int button, int action)
    {
        is_damaged_ = true;
        if (button != GLFW_MOUSE_BUTTON_LEFT)
            return;
        double x = 0.0;
        double y = 0.0;
        glfwGetCursorPos(window_, &x, &y);
        push_pointer(action == GLFW_PRESS ? WindowEvent::Kind::left_down : WindowEvent::Kind::left_up, x, y);
    }

    void take_pointer(double x, double y) { push_pointer(WindowEvent::Kind::pointer, x, y); }

    /// From the window's units to pixels, which differ on dense displays.
    void push_pointer(WindowEvent::Kind kind, double x, double y)
    {
        int width = 0;
        int height = 0;
        glfwGetWindowSize(window_, &width, &height);
        const Size drawable = size();
        const WindowEvent event{.kind = kind,
                                .x = width > 0 ? x * drawable.width / width : x,
                                .y = height > 0 ? y * drawable.height / height : y};
        const bool waits = kind == WindowEvent::Kind::left_down || !held_.empty();
        (waits ? held_ : events_).push_back(event);
    }

    /// Whose a press is, the user interface knows only when it has seen where the pointer went. What followed the press
    /// has waited for that.
    void release_held()
    {
        for (const WindowEvent& event : held_)
            if (event.kind != WindowEvent::Kind::left_down || !ImGui::GetIO().WantCaptureMouse)
                events_.push_back(event);
        held_.clear();
    }

    struct Size {
        int width = 0;
        int height = 0;
    };
    Size size() const
    {
        Size size;
        if (!glfwGetWindowAttrib(window_, GLFW_ICONIFIED))
            glfwGetFramebufferSize(window_, &size.width, &size.height);
        return size;
    }

    void set_full_screen(bool is_full)
    {
        if (is_full == (glfwGetWindowMonitor(window_) != nullptr))
            return;
        if (!is_full) {
            glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], GLFW_DONT_CARE);
            return;
        }
        GLFWmonitor* monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
        if (mode == nullptr)
            return;
        glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
        glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

    std::unique_ptr<Context> context_;
    GLFWwindow* window_;
    std::vector<WindowEvent> events_;
    std::vector<WindowEvent> held_; ///< of the mouse, from a press on
    bool is_damaged_ = true;
    int windowed_[4] = {0, 0, 640, 360}; ///< place and size before full screen
};

tl::expected<std::unique_ptr<Window>, ContextError> Window::open(const WindowOptions& options)
{
    auto context = create_context(ContextKind::glfw, {options.width, options.height, true, options.title});
    if (!context)
        return tl::unexpected(context.error());
    return std::unique_ptr<Window>(new Window(std::make_unique<Impl>(std::move(*context), options)));
}

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Window::~Window() = default;

GlLoader Window::loader() const { return impl_->context_->loader(); }

std::vector<WindowEvent> Window::wait(double seconds)
{
    if (seconds > 0.0 && impl_->events_.empty() && impl_->held_.empty())
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    return std::exchange(impl_->events_, {});
}

void Window::wake() { glfwPostEmptyEvent(); }
bool Window::take_damage() { return std::exchange(impl_->is_damaged_, false); }
int Window::width() const { return impl_->size().width; }
int Window::height() const { return impl_->size().height; }
bool Window::is_minimised() const { return impl_->size().width < 1 || impl_->size().height < 1; }
bool Window::wants_to_close() const { return glfwWindowShouldClose(impl_->window_) != 0; }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(impl_->window_, title.c_str()); }
void Window::set_full_screen(bool is_full) { impl_->set_full_screen(is_full); }
bool Window::is_full_screen() const { return glfwGetWindowMonitor(impl_->window_) != nullptr; }

void Window::begin_interface()
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    impl_->release_held();
}

void Window::draw_interface()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Window::is_interface_active() const { return ImGui::IsAnyItemActive() || ImGui::GetIO().WantTextInput; }
void Window::show() { glfwSwapBuffers(impl_->window_); }

} // namespace passgraph
