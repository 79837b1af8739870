// A display without a screen, a window manager on it, and `passgraph view` in a window, worked by keys and mouse.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <passgraph/core/picture.hpp>

#include <sys/types.h>

namespace passgraph::test {

/// One Xvfb with openbox for the whole program; ended with it. Its screen has 800 x 600 pixels.
const std::string& display();

/// The demo in a window of 320 x 180, over copies of its files that a test may change.
class Desk {
public:
    static constexpr Extent kWindow{320, 180};

    explicit Desk(const std::vector<std::string>& more_words = {});
    ~Desk();
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    /// Sends words to xdotool; the window has the keyboard.
    void input(const std::string& words);
    void key(const std::string& name) { input("key " + name); }
    /// xdotool's words about the window: "windowsize" and "1 1" give `windowsize WINDOW 1 1`.
    void window(const std::string& verb, const std::string& words = "");
    void point_at(int x, int y); ///< pixels of the window, from its top left

    /// What the key P saves.
    Picture picture();
    /// Pictures until one fits; fails the test when none does in time.
    Picture picture_with(const std::function<bool(const Picture&)>& fits, const std::string& what);
    /// Pictures until two are the same.
    Picture picture_at_rest();

    /// Waits until the program has printed this on stderr `times` times.
    void wait_for_message(const std::string& text, int times = 1);
    /// Waits until stdout has a line that starts so, and returns the line.
    std::string wait_for_line(const std::string& start);
    std::string messages() const;
    bool is_running() const;
    /// Waits for the end; the exit code, -1 when a signal ended it.
    int wait_for_end();

    /// Replaces words in one of the copies: "passes/screen/night_vision.glsl", "night.graph.json", "scenes/night_lamp.scene.json".
    void edit(const std::string& file, const std::string& from, const std::string& to) const;
    void write(const std::string& file, const std::string& text) const;
    std::string read(const std::string& file) const;
    std::string path(const std::string& file) const { return folder_ + "/" + file; }

private:
    std::string folder_;
    std::string window_;
    mutable pid_t program_ = -1;
    mutable int exit_code_ = -1;
    mutable bool has_ended_ = false;
};

/// Mean of each channel.
std::vector<double> means(const Picture& picture);
/// Mean difference of all texels; 1 when the extents differ.
double difference(const Picture& a, const Picture& b);

} // namespace passgraph::test
