// What the window shows and what its panel changes: plain data between the session and the user interface.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <passgraph/core/error.hpp>

#include "tool/view/controls.hpp"
#include "tool/view/key_map.hpp"
#include "tool/view/stack.hpp"

namespace passgraph::tool::view {

/// Mistakes by where they come from; each is replaced as a whole when its source is tried again.
struct Mistakes {
    Errors passes; ///< of pass and graph files
    Errors scene;
    Errors plan;   ///< of compiling, in the compiler or the driver
    Errors frame;
    Errors saving;

    Errors all() const;
};

struct ViewState {
    std::vector<Stack> stacks;
    size_t current = 0;
    std::shared_ptr<const PassLibrary> library;
    Mistakes mistakes;

    bool shows_help = false;
    bool shows_panel = true;
    bool shows_thumbnails = false; ///< their section is open
    std::string notice;            ///< a line that fades
    double notice_until = 0.0;     ///< seconds of the window's clock
    std::optional<std::array<double, 2>> probed; ///< where the last click was, in the picture
    std::array<float, 2> answer_size{};          ///< of the values' window, pixels

    std::vector<PassControls> controls;  ///< of the current stack
    std::vector<std::string> images;     ///< of the current stack
    std::string preset_file;             ///< what the text fields hold
    std::string graph_file;

    Stack& stack() { return stacks[current]; }
    const Stack& stack() const { return stacks[current]; }
};

/// What a person did in the panel in one frame.
struct PanelOrders {
    std::vector<Order> orders;
    bool settings_changed = false;
    bool resets_camera = false;
    bool saves_preset = false;
    bool saves_graph = false;
    bool closes_answer = false;
};

} // namespace passgraph::tool::view
