// Scenes that cannot be drawn: each mistake at its place in the scene file, all of them at once, no picture touched.
#include "program.hpp"
#include "support/catch.hpp"
#include "support/png_file.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

constexpr const char* kGraph = R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } },
  "passes": { "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } } },
  "outputs": { "normal": "surface.normal" } })";

/// What `render` says of a scene it must refuse.
std::string refusal(const Workplace& place, const std::string& scene)
{
    place.write("g.graph.json", kGraph);
    place.write("s.scene.json", scene);
    place.write("old.exr", "untouched");
    const auto files = place.files();
    const test::Outcome outcome =
        place.run({"render", "g.graph.json", "--scene", "s.scene.json", "--size", "16x16", "--out", "normal=old.exr"});
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    CHECK(place.files() == files);
    CHECK(place.read("old.exr") == "untouched");
    return outcome.err;
}

std::string with_camera(const std::string& fields)
{
    return "{ \"passgraph_scene\": 1,\n  \"camera\": { \"position\": [0,0,4], \"direction\": [0,0,-1],\n    " + fields + " } }\n";
}

/// Six faces, each of its own size; a width of 0 leaves the face out.
void write_cube(const Workplace& place, const std::vector<Extent>& extents)
{
    constexpr const char* kFaces[] = {"px", "nx", "py", "ny", "pz", "nz"};
    for (size_t i = 0; i < 6; ++i)
        if (extents[i].width > 0)
            place.write(std::string("sky/") + kFaces[i] + ".png",
                        test::png_bytes({extents[i].width, extents[i].height, test::PngKind::rgb, 8, {1, 2, 3}}));
}

size_t count_of(const std::string& text, const std::string& part)
{
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

constexpr const char* kWithSky = "{ \"passgraph_scene\": 1,\n  \"sky\": { \"faces\": \"sky\" } }\n";
constexpr const char* kSkyPlace = "s.scene.json:2:21: error[";

} // namespace

TEST_CASE("a camera that sees nothing is refused at its field", "[tool][scene]")
{
    const Workplace place;
    const auto says = [&](const std::string& fields, const std::string& where, const std::string& what) {
        const std::string text = refusal(place, with_camera(fields));
        CHECK_THAT(text, Contains("s.scene.json:3:" + where + ": error[value_out_of_range]") && Contains(what));
        CHECK(count_of(text, "error[") == 1);
    };
    says("\"near\": 5, \"far\": 5", "13", "not before its \"far\" plane");
    says("\"far\": 0.01", "12", "not before its \"far\" plane");
    says("\"near\": 0", "13", "\"near\" is 0");
    says("\"near\": 1e-38", "13", "at least 1e-15");
    says("\"near\": 1e-14, \"far\": 1e17", "13", "1e+30 times");
    says("\"far\": -3", "12", "\"far\" is -3");
    says("\"vertical_fov_degrees\": 0", "29", "above 0 and below 180");
    says("\"vertical_fov_degrees\": 180", "29", "above 0 and below 180");
    says("\"vertical_fov_degrees\": 179.9999999999", "29", "above 0 and below 180"); // 180 as a float
    says("\"vertical_fov_degrees\": -5", "29", "above 0 and below 180");
}

TEST_CASE("a cube map lacks a face, has faces of two sizes, or faces that are not square", "[tool][scene]")
{
    const Extent usual{8, 8};
    const auto of = [&](std::vector<Extent> extents) {
        const Workplace place;
        write_cube(place, extents);
        const std::string text = refusal(place, kWithSky);
        CHECK(count_of(text, kSkyPlace) == count_of(text, "error[")); // each at the scene's "faces"
        return text;
    };
    const std::string five = of({usual, usual, usual, {}, usual, usual});
    CHECK_THAT(five, Contains("error[file_missing]") && Contains("no face `ny`") && Contains("hint: "));
    CHECK(count_of(five, "error[") == 1);
    const std::string odd_first = of({{4, 4}, usual, usual, usual, usual, usual});
    CHECK_THAT(odd_first, Contains("error[cube_face_size]") && Contains("`px`") && Contains("4 x 4") && Contains("8 x 8"));
    CHECK(count_of(odd_first, "error[") == 1); // the face that differs is to blame, not the five others
    CHECK(count_of(of({{8, 4}, {8, 4}, {8, 4}, {8, 4}, {8, 4}, {8, 4}}), "error[cube_face_not_square]") == 6);
    const std::string all = of({usual, {4, 4}, {8, 3}, usual, usual, {}});
    CHECK_THAT(all, Contains("error[cube_face_size]") && Contains("error[cube_face_not_square]") && Contains("error[file_missing]"));
    CHECK(count_of(all, "error[") == 3);
}

TEST_CASE("faces that are broken are told with their file, beside those that are missing", "[tool][scene]")
{
    const Workplace place;
    write_cube(place, {{2, 2}, {2, 2}, {}, {2, 2}, {2, 2}, {2, 2}});
    place.write("sky/nx.png", "");
    place.write("sky/pz.png", test::png_bytes({2, 2, test::PngKind::rgb, 8, {1, 2, 3}}).substr(0, 50));
    const std::string text = refusal(place, kWithSky);
    CHECK_THAT(text, Contains("nx.png") && Contains("it is empty") && Contains("no face `py`") && Contains("pz.png"));
    CHECK(count_of(text, kSkyPlace) == 3);
}

TEST_CASE("the mistakes of camera, lamps, models and sky come in one go", "[tool][scene]")
{
    const Workplace place;
    const std::string text = refusal(place, R"({ "passgraph_scene": 1,
  "camera": { "position": [0,0,4], "direction": [0,0,-1], "near": 5, "far": 1, "vertical_fov_degrees": 180 },
  "lights": [ { "kind": "point", "color": [1,1,1], "position": [0,0,0], "radius": 0 } ],
  "elements": [ { "model": "nowhere.glb" } ],
  "sky": { "faces": "nosky" } }
)");
    for (const char* where : {":2:67: ", ":2:104: ", ":3:83: ", ":4:28: ", ":5:21: "})
        CHECK_THAT(text, Contains("s.scene.json" + std::string(where) + "error["));
    CHECK(count_of(text, "error[") == 5);
}

TEST_CASE("a picture of any kind and shape can be an input", "[tool][scene]")
{
    using enum test::PngKind;
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const std::vector<std::pair<test::FlatPng, std::vector<float>>> kinds = {
        {{1, 1, rgb, 8, {255, 0, 255}}, {1, 0, 1}},   {{1, 4096, rgb, 8, {255, 0, 255}}, {1, 0, 1}},
        {{7, 3, grey, 16, {65535}}, {1, 1, 1}},       {{7, 3, grey_alpha, 8, {255, 0}}, {1, 1, 1}},
        {{7, 3, rgba, 16, {0, 65535, 0, 9}}, {0, 1, 0}}, {{9, 2, grey, 1, {1}}, {1, 1, 1}},
        {{4, 4, palette, 8, {1}, {{0, 0, 0}, {255, 255, 0}}}, {1, 1, 0}},
    };
    for (const auto& [png, value] : kinds) {
        INFO(png.width << " x " << png.height << ", " << png.bits << " bit, kind " << static_cast<int>(png.kind));
        place.write("in.png", test::png_bytes(png));
        const test::Outcome outcome =
            place.run({"render", "g.graph.json", "--in", "image=in.png", "--out", "bright_part=out.pfm"});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        const Picture out = place.read_picture("out.pfm");
        CHECK(out.extent == Extent{png.width, png.height});
        for (int c = 0; c < 3; ++c)
            CHECK(out.at(0, out.extent.height - 1, c) == value[static_cast<size_t>(c)]);
    }
}
