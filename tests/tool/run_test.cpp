// `run`: one pass alone.
#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

const std::string kModels = std::string(PASSGRAPH_SOURCE_DIR) + "/tests/data/models/";

} // namespace

TEST_CASE("a pass by name runs over a picture, its parameters set", "[tool][run]")
{
    const Workplace place;
    place.write_picture("a.png", test::flat({5, 3}, {1.0f, 0.6f, 0.2f}));
    const auto outcome = place.run({"run", "night_vision", "--in", "image=a.png", "--param", "tint=1,0,0.5", "--out", "color=b.png"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    const Picture picture = place.read_picture("b.png");
    CHECK(picture.extent == Extent{5, 3});
    CHECK(picture.at(4, 2, 0) == 1.0f);
    CHECK(picture.at(4, 2, 1) == 0.0f);
    CHECK(picture.at(4, 2, 2) == Approx(0.1).margin(1.0 / 255.0));
}

TEST_CASE("a generic pass changes display as display, and values as radiance", "[tool][run]")
{
    const Workplace place;
    place.write_picture("a.png", test::flat({4, 4}, {0.8f, 0.4f, 0.2f}));
    place.write_picture("a.pfm", test::flat({4, 4}, {8.0f, 4.0f, 2.0f}));
    const std::vector<std::string> pass = {"run", "vignette", "--param", "amount=0"};
    const auto run = [&](const std::string& in, const std::string& out) {
        std::vector<std::string> words = pass;
        words.insert(words.end(), {"--in", "image=" + in, "--out", "color=" + out});
        return place.run(words);
    };
    REQUIRE(run("a.png", "b.png").code == 0);
    CHECK(place.read_picture("b.png").texels == place.read_picture("a.png").texels);
    REQUIRE(run("a.pfm", "b.pfm").code == 0);
    CHECK(place.read_picture("b.pfm").texels == place.read_picture("a.pfm").texels);
    const auto refused = run("a.pfm", "c.png");
    CHECK(refused.code == 1);
    CHECK_THAT(refused.err, Contains("error[radiance_to_png]"));
}

TEST_CASE("a pass by its file runs, wherever it lies", "[tool][run]")
{
    const Workplace place;
    place.write("twice.glsl", R"(/*{ "pass": "twice", "inputs": { "twice": "mask" }, "outputs": { "mask_out": "mask" } }*/
float twice_of(float x) { return 2.0 * x; }
float twice(vec2 uv) { return 0.5; }
)");
    const auto outcome = place.run({"run", "twice.glsl", "--in", "twice=a.pfm", "--out", "mask_out=b.pfm"});
    CHECK(outcome.code == 1); // an input named as the pass cannot be called
    place.write("twice.glsl", R"(/*{ "pass": "twice", "inputs": { "image": "mask" }, "outputs": { "value": "mask" } }*/
float twice(vec2 uv) { return 2.0 * image(uv); }
)");
    place.write_picture("a.pfm", test::flat({1, 7}, {0.2f}));
    const auto right = place.run({"run", "twice.glsl", "--in", "image=a.pfm", "--out", "value=b.pfm"});
    CHECK(right.err == "");
    REQUIRE(right.code == 0);
    CHECK(place.read_picture("b.pfm").at(0, 6) == Approx(102.0 / 255.0));
}

TEST_CASE("a geometry pass runs over a scene", "[tool][run]")
{
    const Workplace place;
    place.write("s.scene.json", "{ \"passgraph_scene\": 1, \"elements\": [ { \"model\": \"" + kModels + "box01.glb\" } ] }");
    const auto outcome =
        place.run({"run", "gbuffer", "--scene", "s.scene.json", "--size", "32x24", "--out", "depth=d.pfm", "--out", "albedo=a.png"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    const Picture depth = place.read_picture("d.pfm");
    CHECK(depth.extent == Extent{32, 24});
    CHECK(depth.at(16, 12) > 0.0f); // the scene is framed: the box is in the middle
    CHECK(depth.at(0, 0) == 0.0f);
    const auto refused = place.run({"run", "gbuffer", "--scene", "s.scene.json", "--size", "32x24", "--out", "normal=n.png"});
    CHECK(refused.code == 1);
    CHECK_THAT(refused.err, Contains("error[values_to_png]") && Contains(".exr"));
}

TEST_CASE("a wrong pass, port, input or parameter is named", "[tool][run]")
{
    const Workplace place;
    place.write_picture("a.png", test::flat({2, 2}, {1, 1, 1}));
    const auto errors = [&](const std::vector<std::string>& words) {
        const test::Outcome outcome = place.run(words);
        CHECK(outcome.code == 1);
        return outcome.err;
    };
    CHECK_THAT(errors({"run", "vignete", "--in", "image=a.png", "--out", "color=b.png"}), Contains("did you mean `vignette`?"));
    CHECK_THAT(errors({"run", "vignette", "--in", "image=a.png", "--out", "colour=b.png"}),
               Contains("error[unknown_output]") && Contains("did you mean `color`?"));
    CHECK_THAT(errors({"run", "vignette", "--in", "img=a.png", "--out", "color=b.png"}), Contains("error[unknown_input]"));
    CHECK_THAT(errors({"run", "vignette", "--out", "color=b.png"}), Contains("error[input_missing]"));
    CHECK_THAT(errors({"run", "vignette", "--in", "image=a.png", "--param", "amount=2", "--out", "color=b.png"}),
               Contains("--param amount=2: error[param_out_of_range]"));
    CHECK_THAT(errors({"run", "vignette", "--in", "image=a.png", "--param", "shape=oval", "--out", "color=b.png"}),
               Contains("error[unknown_item]"));
    CHECK_FALSE(place.has("b.png"));
}
