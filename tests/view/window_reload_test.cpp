// Files that change under the window: passes, what they include, graphs and the scene, right and wrong.
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "support/catch.hpp"
#include "view/desk.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

bool is_red(const Picture& picture)
{
    const std::vector<double> mean = means(picture);
    return mean[0] > 0.01 && mean[1] == 0.0 && mean[2] == 0.0;
}

bool is_blue(const Picture& picture)
{
    const std::vector<double> mean = means(picture);
    return mean[2] > 0.01 && mean[0] == 0.0 && mean[1] == 0.0;
}

const std::string kNight = "passes/screen/night_vision.glsl";

} // namespace

TEST_CASE("a saved pass is seen without a key", "[view][window]")
{
    Desk desk;
    desk.key("c");
    desk.picture_with([](const Picture& now) { return means(now)[1] > 2.0 * means(now)[2]; }, "a green picture");
    desk.edit(kNight, "seen * tint", "seen * vec3(1, 0, 0)");
    desk.picture_with(is_red, "a red picture");
    desk.wait_for_message("night_vision.glsl: seen");
    for (const char* color : {"vec3(0, 0, 1)", "vec3(1, 0, 0)", "vec3(0, 0, 0.9)"}) {
        const std::string text = desk.read(kNight);
        const size_t at = text.find("seen * vec3(");
        desk.edit(kNight, text.substr(at, text.find(')', at) + 1 - at), fmt::format("seen * {}", color));
        desk.picture_with(std::string(color).starts_with("vec3(1") ? is_red : is_blue, color);
    }
    desk.wait_for_message("night_vision.glsl: seen", 4);
    WARN("saving a changed pass to seeing it, on this machine now:\n" << desk.messages());
}

TEST_CASE("a saved common file reaches the passes that include it", "[view][window]")
{
    Desk desk;
    const Picture before = desk.picture_at_rest();
    desk.edit("passes/common/hable.glsl", "return hable_curve(limited", "return 0.25 * hable_curve(limited");
    desk.picture_with([&](const Picture& now) { return means(now)[2] < 0.8 * means(before)[2]; }, "a darker picture");
}

TEST_CASE("a broken pass leaves the last good one running and tells its line", "[view][window]")
{
    Desk desk;
    desk.key("c");
    desk.picture_with([](const Picture& now) { return means(now)[1] > 2.0 * means(now)[2]; }, "a green picture");
    const Picture good = desk.picture_at_rest();
    desk.edit(kNight, "vec3 seen = image(uv);", "vec3 seen = image(uv) * tin;");
    desk.wait_for_message("passes/screen/night_vision.glsl:15");
    desk.wait_for_message("error[glsl_error]");
    CHECK(desk.picture_at_rest().texels == good.texels);
    desk.key("z"); // it still listens
    desk.picture_with([](const Picture& now) { return means(now)[2] > means(now)[1]; }, "the bluish bloom stack");
    desk.key("c");
    desk.edit(kNight, "image(uv) * tin;", "image(uv) * vec3(0, 0, 1);");
    desk.edit(kNight, "seen * tint", "seen");
    desk.picture_with(is_blue, "the mended pass");
}

TEST_CASE("a half-written pass is waited for and not complained about", "[view][window]")
{
    Desk desk;
    desk.key("c");
    desk.picture_with([](const Picture& now) { return means(now)[1] > 2.0 * means(now)[2]; }, "a green picture");
    std::string text = desk.read(kNight);
    text.replace(text.find("seen * tint"), 11, "seen * vec3(1, 0, 0)");
    for (size_t length = 0; length < text.size(); length += text.size() / 12 + 1) {
        desk.write(kNight, text.substr(0, length));
        std::this_thread::sleep_for(std::chrono::milliseconds(8));
    }
    desk.write(kNight, text);
    desk.picture_with(is_red, "a red picture");
    CHECK_THAT(desk.messages(), !Catch::Contains("error["));
}

TEST_CASE("T and R read everything again", "[view][window]")
{
    Desk desk;
    const Picture before = desk.picture_at_rest();
    desk.key("t");
    desk.wait_for_message("reading passes and graphs again");
    desk.key("r");
    desk.wait_for_message("reading the scene again");
    CHECK(desk.picture_at_rest().texels == before.texels);
}

TEST_CASE("a saved graph is seen, a broken one is not", "[view][window]")
{
    Desk desk;
    const Picture before = desk.picture_at_rest();
    desk.edit("bloom.graph.json", R"("shown":  { "pass": "tone_map", "inputs": { "image": "film" })", R"("shown":  { "pass": "tone_map", "params": { "exposure": 0.2 }, "inputs": { "image": "film" })");
    const Picture darker = desk.picture_with([&](const Picture& now) { return means(now)[2] < 0.8 * means(before)[2]; }, "a darker picture");
    desk.edit("bloom.graph.json", R"("image": "film")", R"("image": "flim")");
    desk.wait_for_message("bloom.graph.json:");
    desk.wait_for_message("error[unknown_image]");
    CHECK(desk.picture_at_rest().texels == darker.texels);
}

TEST_CASE("a saved scene is seen, a broken one is not", "[view][window]")
{
    Desk desk;
    const std::string scene = "scenes/night_lamp.scene.json";
    const Picture before = desk.picture_at_rest();
    desk.edit(scene, "[7500, 3300, 600]", "[0, 60000, 0]");
    const Picture lit = desk.picture_with([&](const Picture& now) { return means(now)[1] > 1.5 * means(before)[1]; }, "green lamp light");
    desk.edit(scene, "[0, 60000, 0]", "[0, 60000, \"much\"]");
    desk.wait_for_message("night_lamp.scene.json:");
    desk.wait_for_message("error[");
    CHECK(desk.picture_at_rest().texels == lit.texels);
    desk.edit(scene, "[0, 60000, \"much\"]", "[7500, 3300, 600]");
    desk.picture_with([&](const Picture& now) { return now.texels == before.texels; }, "the first picture");
    // Another camera in the file is the window's.
    desk.edit(scene, "[0, 100, 140]", "[0, 140, 200]");
    desk.picture_with([&](const Picture& now) { return difference(now, before) > 0.01; }, "the other camera's view");
}
