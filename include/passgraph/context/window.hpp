// A window with a context, its keys and its mouse, and a user interface (Dear ImGui) drawn over it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <passgraph/context/context.hpp>

namespace passgraph {

struct WindowOptions {
    int width = 1280; ///< of the drawable, in pixels
    int height = 720;
    std::string title = "passgraph";
    std::vector<std::string> fonts{};      ///< TrueType files, the first that is there is used; else ImGui's own
    std::vector<std::string> mono_fonts{}; ///< the same for columns of text
    float font_pixels = 15.0f;
};

/// Something a person did. Keys are named by what is printed on them, in capitals ('A', '1'), or by these.
struct WindowEvent {
    enum class Kind { key_down, key_up, left_down, left_up, pointer, focus_lost };
    enum SpecialKey { escape = 256, tab, shift };
    Kind kind = Kind::key_down;
    int key = 0;
    bool with_shift = false;
    double x = 0.0; ///< pixels from the left
    double y = 0.0; ///< pixels from the top
};

/// One window on the machine's display; its context is current while it lives.
class Window {
public:
    /// Errors   no display, no OpenGL 3.3: what the machine lacks.
    static tl::expected<std::unique_ptr<Window>, ContextError> open(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GlLoader loader() const;
    /// What happened since the last call, in order. Sleeps up to `seconds` when nothing has (0: not at all). Events that the
    /// user interface takes (the pointer over a panel, keys into a text field) are left out.
    std::vector<WindowEvent> wait(double seconds);
    /// Ends another thread's or its own `wait` early. May be called from any thread.
    static void wake();
    /// True once when the window must be drawn again (uncovered, resized, or the user interface was touched). A press of the
    /// mouse becomes an event only with the next `begin_interface`.
    bool take_damage();

    int width() const; ///< of the drawable, pixels; 0 while minimised
    int height() const;
    bool is_minimised() const;
    bool wants_to_close() const;
    void set_title(const std::string& title);
    void set_full_screen(bool is_full);
    bool is_full_screen() const;

    /// Starts the user interface of one frame; ImGui calls go between this and `draw_interface`.
    void begin_interface();
    /// Draws it over what the default framebuffer holds.
    void draw_interface();
    /// The user interface still moves (a drag, a caret that blinks): draw again soon.
    bool is_interface_active() const;
    void show();

private:
    class Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace passgraph
