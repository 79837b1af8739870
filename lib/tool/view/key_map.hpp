// Which key does what.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <passgraph/context/window.hpp>

namespace passgraph::tool::view {

enum class Command { pick_stack, reload_passes, reload_scene, full_screen, save_picture, show_image, help, panel, quit };

struct Order {
    Command command = Command::help;
    int index = 0; ///< of a stack from 0; of an image from 1, 0 being the output
};

/// What pressing a key asks for: nothing for a key that is held to move.
std::optional<Order> order_of(const WindowEvent& event);

/// The keys that are held down, and those that were tapped so shortly that they are up again.
class HeldKeys {
public:
    void take(const WindowEvent& event);
    /// The wish for `CameraController::advance`: of the keys held, and of those tapped since the last call.
    glm::dvec3 take_wish();
    bool is_any_held() const;
    bool is_fast() const { return held_.contains(WindowEvent::shift); }

private:
    std::set<int> held_;
    std::set<int> tapped_;
};

struct HelpLine {
    std::string keys;
    std::string text;
};
std::vector<HelpLine> help_lines(const std::vector<std::string>& stacks);

} // namespace passgraph::tool::view
