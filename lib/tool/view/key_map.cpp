// Keys and their orders.
#include "tool/view/key_map.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace passgraph::tool::view {
namespace {

constexpr std::string_view kStackKeys = "ZXC";

struct Row {
    int key;
    Command command;
};
constexpr Row kRows[] = {
    {'T', Command::reload_passes}, {'R', Command::reload_scene}, {'F', Command::full_screen}, {'P', Command::save_picture},
    {'H', Command::help},          {WindowEvent::tab, Command::panel}, {WindowEvent::escape, Command::quit},
};

struct Push {
    int key;
    glm::dvec3 way; ///< right, up, back
};
const std::array<Push, 6> kPushes = {{{'W', {0, 0, -1}},
                                      {'S', {0, 0, 1}},
                                      {'A', {-1, 0, 0}},
                                      {'D', {1, 0, 0}},
                                      {'Q', {0, -1, 0}},
                                      {'E', {0, 1, 0}}}};

} // namespace

std::optional<Order> order_of(const WindowEvent& event)
{
    if (event.kind != WindowEvent::Kind::key_down)
        return std::nullopt;
    if (event.key >= '0' && event.key <= '9')
        return Order{Command::show_image, event.key == '0' ? 0 : event.key - '0' + (event.with_shift ? 9 : 0)};
    if (event.key < 128)
        if (const size_t stack = kStackKeys.find(static_cast<char>(event.key)); stack != std::string_view::npos)
            return Order{Command::pick_stack, static_cast<int>(stack)};
    for (const Row& row : kRows)
        if (row.key == event.key)
            return Order{row.command};
    return std::nullopt;
}

void HeldKeys::take(const WindowEvent& event)
{
    if (event.kind == WindowEvent::Kind::key_down) {
        held_.insert(event.key);
        tapped_.insert(event.key);
    } else if (event.kind == WindowEvent::Kind::key_up) {
        held_.erase(event.key);
    } else if (event.kind == WindowEvent::Kind::focus_lost) {
        held_.clear();
    }
}

glm::dvec3 HeldKeys::take_wish()
{
    glm::dvec3 wish(0.0);
    for (const Push& push : kPushes)
        if (held_.contains(push.key) || tapped_.contains(push.key))
            wish += push.way;
    tapped_.clear();
    return wish;
}

bool HeldKeys::is_any_held() const
{
    return std::any_of(kPushes.begin(), kPushes.end(),
                       [&](const Push& push) { return held_.contains(push.key) || tapped_.contains(push.key); });
}

std::vector<HelpLine> help_lines(const std::vector<std::string>& stacks)
{
    std::vector<HelpLine> lines = {{"w a s d", "fly forwards, left, back, right"},
                                   {"q e", "fly down, up; with Shift faster"},
                                   {"drag", "look around, with the left button on the picture"},
                                   {"click", "the values of every image at that pixel"}};
    for (size_t i = 0; i < std::min(stacks.size(), kStackKeys.size()); ++i)
        lines.push_back({std::string(1, kStackKeys[i]), fmt::format("the stack `{}`", stacks[i])});
    const std::vector<HelpLine> rest = {{"1 … 9", "an image of the graph, with Shift 10 … 18; 0 the output"},
                                        {"T", "read passes and graphs again"},
                                        {"R", "read the scene again"},
                                        {"P", "save the picture as a PNG file"},
                                        {"F", "full screen"},
                                        {"Tab", "the panel"},
                                        {"H", "this help"},
                                        {"Esc", "quit"}};
    lines.insert(lines.end(), rest.begin(), rest.end());
    return lines;
}

} // namespace passgraph::tool::view
