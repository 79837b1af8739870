// Keys and mouse, sent to the real window, and what the picture then shows.
#include <sstream>

#include <fmt/format.h>

#include "support/catch.hpp"
#include "view/desk.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Half of what any two pictures of this test that show different things were seen to differ by.
constexpr double kMoved = 0.004;

bool is_green(const Picture& picture)
{
    const std::vector<double> mean = means(picture);
    return mean[1] > 1.5 * mean[0] && mean[1] > 3.0 * mean[2]; // the tint is 0.40, 0.79, 0.11
}

/// Neighbours in cells of 9 texels are equal but at one edge in nine.
bool has_cells(const Picture& picture)
{
    int equal = 0;
    int all = 0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 1; x < picture.extent.width; ++x, ++all)
            equal += picture.at(x, y, 0) == picture.at(x - 1, y, 0) && picture.at(x, y, 1) == picture.at(x - 1, y, 1) &&
                     picture.at(x, y, 2) == picture.at(x - 1, y, 2);
    return equal * 9 >= all * 8;
}

} // namespace

TEST_CASE("keys fly the camera and it comes to rest, a drag turns it, a click does neither", "[view][window]")
{
    Desk desk;
    const Picture start = desk.picture_at_rest();
    for (const std::string held : {"w", "a", "e"}) {
        const Picture before = desk.picture_at_rest();
        desk.input("keydown " + held);
        desk.picture_with([&](const Picture& now) { return difference(now, before) > kMoved; }, "another view while " + held + " is held");
        desk.input("keyup " + held);
    }
    const Picture flown = desk.picture_at_rest();
    CHECK(difference(flown, start) > kMoved);

    desk.point_at(100, 90);
    desk.input("mousedown 1");
    for (int i = 0; i < 4; ++i)
        desk.input("mousemove_relative -- 10 4");
    const Picture turned = desk.picture_with([&](const Picture& now) { return difference(now, flown) > kMoved; }, "another view after a drag");
    desk.input("mouseup 1");
    desk.input("mousemove_relative -- 30 10"); // no longer held
    const Picture rest = desk.picture_at_rest();
    desk.input("click 1");
    desk.wait_for_line("shown ");
    CHECK(desk.picture_at_rest().texels == rest.texels);
}

TEST_CASE("a click tells every image's values at that pixel", "[view][window]")
{
    Desk desk;
    const Picture picture = desk.picture_at_rest();
    desk.point_at(120, 99);
    desk.input("click 1");
    std::istringstream line(desk.wait_for_line("shown "));
    std::string name;
    std::string place;
    double r = 0.0, g = 0.0, b = 0.0;
    line >> name >> place >> r >> g >> b;
    CHECK(place == "120,80"); // counted from the bottom: 180 - 1 - 99
    // The plan of all images stores what the window's plan keeps in registers, in binary16: a code may round to its neighbour.
    CHECK(r == Approx(static_cast<double>(picture.at(120, 80, 0))).margin(1.01 / 255.0));
    CHECK(g == Approx(static_cast<double>(picture.at(120, 80, 1))).margin(1.01 / 255.0));
    CHECK(b == Approx(static_cast<double>(picture.at(120, 80, 2))).margin(1.01 / 255.0));
    for (const char* image : {"surface.albedo", "surface.normal", "surface.depth", "lit.surface", "glow.horizontal", "film"})
        desk.wait_for_line(fmt::format("{} ", image));
}

TEST_CASE("Z X C switch the stack, and back gives the same picture", "[view][window]")
{
    Desk desk;
    const Picture bloom = desk.picture_at_rest();
    CHECK_FALSE(is_green(bloom));
    CHECK_FALSE(has_cells(bloom));
    desk.key("c");
    desk.picture_with(is_green, "a green picture");
    desk.key("x");
    desk.picture_with(has_cells, "square cells");
    desk.key("z");
    desk.picture_with([&](const Picture& now) { return now.texels == bloom.texels; }, "the first picture");
}

TEST_CASE("digits show the graph's images, and 0 the output again", "[view][window]")
{
    Desk desk;
    const Picture output = desk.picture_at_rest();
    desk.key("3");
    desk.wait_for_message("3: surface.normal");
    desk.picture_with([&](const Picture& now) { return difference(now, output) > 0.1; }, "normals");
    desk.key("5");
    desk.wait_for_message("5: surface.depth");
    desk.picture_with([](const Picture& now) { return now.at(160, 20, 0) == now.at(160, 20, 2) && now.at(160, 20, 0) > now.at(160, 110, 0); },
                      "grey that is lighter where it is near");
    desk.key("0");
    desk.picture_with([&](const Picture& now) { return now.texels == output.texels; }, "the output");
}

TEST_CASE("help and panel open over the picture and are not saved with it", "[view][window]")
{
    Desk desk;
    const Picture picture = desk.picture_at_rest();
    desk.key("h");
    desk.key("Tab");
    CHECK(desk.picture_at_rest().texels == picture.texels);
    desk.key("h");
    desk.key("Tab");
    desk.key("Escape");
    CHECK(desk.wait_for_end() == 0);
}

TEST_CASE("a preset's values are those of the window", "[view][window]")
{
    const std::string file = "/tmp/passgraph_window_preset.json";
    {
        Desk desk;
        desk.write("red.preset.json", R"({ "passgraph_preset": 1, "values": { "tint": [1, 0, 0], "rim.amount": 0 } })");
        std::rename(desk.path("red.preset.json").c_str(), file.c_str());
    }
    Desk desk({"--preset", file});
    desk.key("c");
    desk.picture_with(
        [](const Picture& now) {
            const std::vector<double> mean = means(now);
            return mean[0] > 0.01 && mean[1] == 0.0 && mean[2] == 0.0;
        },
        "a red picture");
    std::remove(file.c_str());
}
