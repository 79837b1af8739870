// The window in every size, full screen, minimised, and where there is no display.
#include <cstdlib>

#include <sys/wait.h>

#include "support/catch.hpp"
#include "view/desk.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

auto of_extent(Extent extent)
{
    return [extent](const Picture& picture) { return picture.extent == extent; };
}

} // namespace

TEST_CASE("the window may have any size", "[view][window]")
{
    Desk desk;
    const Picture before = desk.picture_at_rest();
    CHECK(before.extent == Desk::kWindow);
    desk.window("windowsize", "1 1");
    desk.picture_with(of_extent({1, 1}), "a picture of one texel");
    desk.window("windowsize", "37 211");
    desk.picture_with(of_extent({37, 211}), "a tall picture");
    desk.window("windowsize", "320 180");
    desk.picture_with([&](const Picture& now) { return now.texels == before.texels; }, "the first picture");
    CHECK(desk.messages().find("error[") == std::string::npos);
}

TEST_CASE("a minimised window rests and comes back", "[view][window]")
{
    Desk desk;
    const Picture before = desk.picture_at_rest();
    desk.window("windowminimize --sync");
    desk.edit("passes/common/hable.glsl", "return hable_curve(limited", "return 0.25 * hable_curve(limited"); // it changes meanwhile
    desk.window("windowmap --sync");
    desk.window("windowactivate --sync");
    const Picture darker = desk.picture_with([&](const Picture& now) { return means(now)[2] < 0.8 * means(before)[2]; }, "a darker picture");
    CHECK(darker.extent == Desk::kWindow);
    CHECK(desk.messages().find("error[") == std::string::npos);
}

TEST_CASE("F fills the screen and gives it back", "[view][window]")
{
    Desk desk;
    const Picture before = desk.picture_at_rest();
    desk.key("f");
    desk.picture_with(of_extent({800, 600}), "a picture of the screen's extent");
    desk.key("f");
    desk.picture_with([&](const Picture& now) { return now.texels == before.texels; }, "the first picture");
}

TEST_CASE("the scale draws fewer texels than the window has pixels", "[view][window]")
{
    Desk desk({"--render-scale", "0.5"});
    CHECK(desk.picture_at_rest().extent == Extent{160, 90});
}

TEST_CASE("without a display there is an error of the machine", "[view][window]")
{
    const std::string demo = std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/";
    const std::string command = std::string("env -u DISPLAY -u WAYLAND_DISPLAY ") + PASSGRAPH_PROGRAM + " view " + demo + "bloom.graph.json --scene " +
                                demo + "resources/scenes/night_lamp.scene.json 2>&1 | grep -q 'error\\[display_missing\\]'";
    CHECK(std::system(command.c_str()) == 0);
    const int status = std::system((std::string("env -u DISPLAY ") + PASSGRAPH_PROGRAM + " view " + demo + "bloom.graph.json --scene " + demo +
                                    "resources/scenes/night_lamp.scene.json 2>/dev/null")
                                       .c_str());
    CHECK(WEXITSTATUS(status) == 3);
}

TEST_CASE("mistakes of a start end it before there is a window", "[view][window]")
{
    const std::string demo = std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/";
    const auto code_of = [&](const std::string& words) {
        return WEXITSTATUS(std::system((std::string(PASSGRAPH_PROGRAM) + " view " + words + " 2>/dev/null").c_str()));
    };
    CHECK(code_of(demo + "bloom.graph.json") == 1); // no scene
    CHECK(code_of(demo + "none.graph.json --scene " + demo + "resources/scenes/night_lamp.scene.json") == 1);
    CHECK(code_of(demo + "bloom.graph.json --scene none.json") == 1);
    CHECK(code_of(demo + "bloom.graph.json --scene s.json --pictures /nowhere") == 1);
    CHECK(code_of("") == 2);
}
