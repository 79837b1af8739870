// Which key asks for what.
#include <algorithm>

#include "support/catch.hpp"
#include "tool/view/key_map.hpp"

using namespace passgraph;
using namespace passgraph::tool::view;

namespace {

WindowEvent down(int key, bool with_shift = false) { return {.kind = WindowEvent::Kind::key_down, .key = key, .with_shift = with_shift}; }
WindowEvent up(int key) { return {.kind = WindowEvent::Kind::key_up, .key = key}; }

} // namespace

TEST_CASE("every key of the help does something, and letters that move do nothing else", "[view][keys]")
{
    for (const int key : std::vector<int>{'Z', 'X', 'C', 'T', 'R', 'F', 'P', 'H', '0', '1', '9', WindowEvent::tab, WindowEvent::escape})
        CHECK(order_of(down(key)));
    for (const int key : std::vector<int>{'W', 'A', 'S', 'D', 'Q', 'E', WindowEvent::shift})
        CHECK_FALSE(order_of(down(key)));
    CHECK_FALSE(order_of(up('T')));
    CHECK(order_of(down('X'))->index == 1);
    CHECK(order_of(down('4'))->index == 4);
    CHECK(order_of(down('4', true))->index == 13);
    CHECK(order_of(down('0', true))->index == 0);
}

TEST_CASE("opposite keys cancel and a tap counts once", "[view][keys]")
{
    HeldKeys keys;
    keys.take(down('W'));
    keys.take(down('D'));
    CHECK(keys.take_wish() == glm::dvec3(1, 0, -1));
    keys.take(down('A'));
    CHECK(keys.take_wish() == glm::dvec3(0, 0, -1));
    keys.take(up('A'));
    keys.take(up('D'));
    keys.take(up('W'));
    CHECK_FALSE(keys.is_any_held());
    keys.take(down('E'));
    keys.take(up('E'));
    CHECK(keys.take_wish() == glm::dvec3(0, 1, 0));
    CHECK(keys.take_wish() == glm::dvec3(0));
}

TEST_CASE("keys are let go with the keyboard's focus", "[view][keys]")
{
    HeldKeys keys;
    keys.take(down('S'));
    keys.take_wish();
    keys.take({.kind = WindowEvent::Kind::focus_lost});
    CHECK(keys.take_wish() == glm::dvec3(0));
}

TEST_CASE("the help names the stacks with their keys", "[view][keys]")
{
    const std::vector<HelpLine> lines = help_lines({"bloom", "night"});
    const auto has = [&](const std::string& key, const std::string& word) {
        return std::any_of(lines.begin(), lines.end(), [&](const HelpLine& line) { return line.keys == key && line.text.find(word) != std::string::npos; });
    };
    CHECK(has("Z", "bloom"));
    CHECK(has("X", "night"));
    CHECK_FALSE(has("C", ""));
}
