// Scenes at the edge of what may be drawn: odd textures, models, lamps and cameras give right pictures, never NaN.
#include <cmath>

#include "graphs/graph_runner.hpp"
#include "graphs/scene_show.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"
#include "support/png_file.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

double linear(unsigned code)
{
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

float center(const Picture& picture, int channel = 0)
{
    return picture.at(kShownExtent.width / 2, kShownExtent.height / 2, channel);
}

double mean(const Picture& picture)
{
    double sum = 0.0;
    for (const float value : picture.texels)
        sum += static_cast<double>(value);
    return sum / static_cast<double>(picture.texels.size());
}

/// The square has side 2 at the distance 4: 1 / (4 tan 22.5°) = 0.6036 of the picture's side, 38.63 texels. Each side
/// lies between two texel centers, so 38 or 39 of a row are covered.
void check_square_is_seen(const Shown& shown)
{
    CHECK(shown.covered() >= 38 * 38);
    CHECK(shown.covered() <= 39 * 39);
    CHECK(center(shown.depth) > 0.0f);
    CHECK(shown.depth.at(0, 0) == 0.0f);
    // Head-on, the whole square is lit alike but for the angle to the viewer: a Lambert ground keeps within its weight
    // (1 - F(n.v)), n.v from 1 to 4 / sqrt(18), that is within 1e-4, and the lobe of roughness 1 adds at most 2 %.
    const double share = shown.covered() / (64.0 * 64.0);
    CHECK(mean(shown.radiance) == Approx((center(shown.radiance, 0) + center(shown.radiance, 1) + center(shown.radiance, 2)) / 3.0 *
                                         share).epsilon(0.02));
    CHECK(center(shown.radiance) > 0.0f);
}

struct Kind {
    const char* what;
    FlatPng png;
    std::array<unsigned, 3> code; ///< what an 8-bit reader has to see
};

const std::vector<Kind>& kinds()
{
    using enum PngKind;
    static const std::vector<Kind> all = {
        {"one texel", {1, 1, rgb, 8, {200, 100, 50}}, {200, 100, 50}},
        {"1 x 4096", {1, 4096, rgb, 8, {200, 100, 50}}, {200, 100, 50}},
        {"4096 x 1", {4096, 1, rgb, 8, {200, 100, 50}}, {200, 100, 50}},
        {"3 x 7", {3, 7, rgb, 8, {200, 100, 50}}, {200, 100, 50}},
        {"alpha of 0, which an opaque material ignores", {5, 5, rgba, 8, {200, 100, 50, 0}}, {200, 100, 50}},
        {"16 bit: 257 times the code", {4, 4, rgb, 16, {51400, 25700, 12850}}, {200, 100, 50}},
        {"16 bit with alpha", {4, 4, rgba, 16, {51400, 25700, 12850, 7}}, {200, 100, 50}},
        {"grey", {4, 4, grey, 8, {128}}, {128, 128, 128}},
        {"grey, 16 bit, nearer to 128 than to 127", {4, 4, grey, 16, {32800}}, {128, 128, 128}},
        {"grey, one bit", {9, 3, grey, 1, {1}}, {255, 255, 255}},
        {"grey, two bits", {9, 3, grey, 2, {2}}, {170, 170, 170}},
        {"grey, four bits", {9, 3, grey, 4, {5}}, {85, 85, 85}},
        {"grey with alpha", {4, 4, grey_alpha, 8, {128, 0}}, {128, 128, 128}},
        {"grey with alpha, 16 bit", {4, 4, grey_alpha, 16, {32896, 0}}, {128, 128, 128}},
        {"a palette", {4, 4, palette, 8, {1}, {{0, 0, 0}, {200, 100, 50}}}, {200, 100, 50}},
    };
    return all;
}

} // namespace

TEST_CASE("a texture of any kind and shape gives the albedo its codes stand for", "[graphs][hard]")
{
    for (const Kind& kind : kinds()) {
        INFO(kind.what);
        const Folder folder;
        folder.write("t.png", png_bytes(kind.png));
        write_square(folder, "t.png");
        const Shown shown = show(load(folder, {}));
        check_square_is_seen(shown);
        for (size_t c = 0; c < 3; ++c) {
            // Decoded by the sampler and encoded by the store: one code of rounding, at the curve's steepest there.
            const double step = linear(kind.code[c]) - linear(kind.code[c] - 1);
            CHECK(center(shown.albedo, static_cast<int>(c)) == Approx(linear(kind.code[c])).margin(1.01 * step));
        }
    }
}

TEST_CASE("a model without textures, normals, uv or indices is drawn", "[graphs][hard]")
{
    const Folder folder;
    const std::vector<float> corners = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0};
    ModelBuilder model;
    model.add_floats(corners, 3);
    model.write(folder, one_mesh(R"("attributes":{"POSITION":0},"material":0)",
                                 R"(,"materials":[{"pbrMetallicRoughness":{"metallicFactor":0}}])"));
    const Shown bare = show(load(folder, {}));
    check_square_is_seen(bare);
    write_square(folder);
    CHECK(largest_difference(bare.radiance, show(load(folder, {})).radiance) == 0.0f); // flat normals are its own
    folder.write("t.png", png_bytes({4, 4, PngKind::grey, 8, {128}}));
    model.write(folder, one_mesh(R"("attributes":{"POSITION":0},"material":0)",
                                 R"(,"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}}],
                                    "images":[{"uri":"t.png"}],"textures":[{"source":0}])"));
    check_square_is_seen(show(load(folder, {}))); // a texture but no uv
}

TEST_CASE("a model without a triangle leaves the picture to the others", "[graphs][hard]")
{
    const Folder folder;
    ModelBuilder model;
    model.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0}, 3);
    model.add_floats({0, 0, 0, 0, 0, 0, 0, 0, 0}, 3);
    for (const char* rest : {R"("nodes":[],"meshes":[])", R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[]}])",
                             R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0}]}])",
                             R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{}}]}])"}) {
        INFO(rest);
        model.write(folder, rest);
        const Shown shown = show(load(folder, {}));
        CHECK(shown.covered() == 0);
        CHECK(mean(shown.radiance) == 0.0);
    }
    // Triangles without area cover nothing either, and their normal is no NaN.
    model.write(folder, one_mesh(R"("attributes":{"POSITION":1})"));
    CHECK(show(load(folder, {})).covered() == 0);
}

TEST_CASE("no lamp at all is dark, and a sky still lights", "[graphs][hard]")
{
    const Folder folder;
    write_square(folder);
    const Shown dark = show(load(folder, {.lights = ""}));
    CHECK(dark.covered() >= 38 * 38);
    CHECK(mean(dark.radiance) == 0.0);
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        folder.write(std::string("sky/") + face + ".png", png_bytes({1, 1, PngKind::grey, 8, {128}}));
    const Shown lit = show(load(folder, {.lights = "", .more = R"(, "sky": {"faces": "sky"})"}));
    CHECK(lit.radiance.at(0, 0) == Approx(linear(128)).epsilon(0x1p-10)); // the sky itself, stored in binary16
    CHECK(center(lit.radiance) > 0.5f * lit.radiance.at(0, 0));           // white ground under an even sky
    CHECK(center(lit.radiance) <= lit.radiance.at(0, 0) * 1.001f); // no more than arrives: the furnace's bound
}

TEST_CASE("a thousand lamps add up to one of a thousand times the color", "[graphs][hard]")
{
    const Folder folder;
    write_square(folder);
    const std::string lamp = R"({"kind": "point", "color": [COLOR,COLOR,COLOR], "position": [0.3,0.2,1.5], "radius": 10})";
    const auto lamps = [&](int count, const std::string& color) {
        std::string text = lamp;
        for (size_t at = text.find("COLOR"); at != std::string::npos; at = text.find("COLOR"))
            text.replace(at, 5, color);
        std::string all;
        for (int i = 0; i < count; ++i)
            all += (i ? "," : "") + text;
        return show(load(folder, {.lights = all})).radiance;
    };
    const Picture one = lamps(1, "4");
    const Picture thousand = lamps(1000, "0.00390625"); // 4 / 1024, exact
    // Each sum's rounding is at most half an ulp of the sum so far: n / 2 ulp for n lamps of equal color.
    for (size_t i = 0; i < one.texels.size(); ++i)
        CHECK(thousand.texels[i] == Approx(static_cast<double>(one.texels[i]) * 1000.0 / 1024.0).epsilon(1000 * 0x1p-24).margin(1e-30));
    CHECK(center(one) > 0.1f);
}

TEST_CASE("a lamp inside a surface, or on it, makes no NaN and no light from nowhere", "[graphs][hard]")
{
    const Folder folder;
    write_square(folder);
    const auto lamp = [&](const std::string& place, const std::string& color) {
        return show(load(folder, {.lights = R"({"kind": "point", "color": [)" + color + "], \"position\": [" + place +
                                            "], \"radius\": 100}"}));
    };
    // In the plane of the square every direction to the lamp is along the surface, so that n.l = 0.
    CHECK(mean(lamp("0,0,0", "1,1,1").radiance) == 0.0);
    CHECK(mean(lamp("0.37,-0.21,0", "65504,65504,65504").radiance) == 0.0);
    // A hair above it the spot is bright, and beside it darkness; the domain's end holds (checked by `show`).
    const Shown above = lamp("0.015625,0.015625,0.001", "65504,65504,65504");
    CHECK(center(above.radiance) > 1000.0f);
    CHECK(center(above.radiance) > 1000.0f * above.radiance.at(14, 14));
    // Behind the square, and behind the viewer.
    CHECK(mean(lamp("0,0,-0.001", "9,9,9").radiance) == 0.0);
    CHECK(center(lamp("0,0,4", "9,9,9").radiance) > 0.0f); // the lamp is the viewer
}

TEST_CASE("a lamp of the least or the greatest radius lights what is within it", "[graphs][hard]")
{
    const Folder folder;
    write_square(folder);
    const auto with_radius = [&](const std::string& radius) {
        return show(load(folder, {.lights = R"({"kind": "point", "color": [1,1,1], "position": [0,0,1], "radius": )" +
                                            radius + "}"}));
    };
    CHECK(mean(with_radius("1e-38").radiance) == 0.0);
    CHECK(center(with_radius("1e38").radiance) > 0.1f);
    CHECK(mean(with_radius("0.99").radiance) == 0.0); // the square is 1 m away
}

TEST_CASE("a camera a million metres from the origin sees the same picture bit for bit", "[graphs][hard]")
{
    // Places are doubles up to view space: the differences that are drawn are the same numbers, if the sums are exact.
    const Folder folder;
    write_square(folder);
    const auto seen = [&](const std::string& x, const std::string& z, const std::string& lamp_z) {
        const std::string rest = ",\"radius\": 20}";
        return show(load(folder, {.camera = fmt::format(R"("position": [{},0,{}], "direction": [0.25,0,-1])", x, z),
                                  .lights = fmt::format(R"({{"kind": "point", "color": [3,2,1], "position": [{},1,{}]{})", x,
                                                        lamp_z, rest),
                                  .placed = fmt::format(R"("position": [{},0.125,{}])", x, x)}));
    };
    const Shown near = seen("0", "4.0009765625", "2.25");
    const Shown far = seen("1000000", "1000004.0009765625", "1000002.25");
    CHECK(near.covered() > 500);
    CHECK(largest_difference(near.radiance, far.radiance) == 0.0f);
    CHECK(largest_difference(near.depth, far.depth) == 0.0f);
}

TEST_CASE("the demo moved by a million metres looks the same", "[graphs][hard]")
{
    const std::string file =
        std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/resources/scenes/night_lamp.scene.json";
    auto scene = load_scene(file);
    REQUIRE(scene);
    GraphRun run;
    run.options.extent = {160, 90};
    run.scene = &*scene;
    const Graph graph = sample_graph("deferred_demo/bloom.graph.json");
    const Picture near = run_graph(graph, run).at("color");
    const glm::dvec3 away(1e6, -1e6, 1e6);
    scene->camera.position += away;
    for (Element& element : scene->elements)
        element.world_from_model[3] += glm::dvec4(away, 0.0);
    for (Light& light : scene->lights)
        light.position += away;
    const Picture far = run_graph(graph, run).at("color");
    // A double of 1e6 m has steps of 1.2e-10 m. At 100 m, where a float's step is 7.6e-6 m, one place in 60 000 rounds to
    // the other side: 20 000 corners might differ by a float's last bit and move an edge over a texel's center.
    int differing = 0;
    for (size_t i = 0; i < near.texels.size(); ++i)
        differing += std::abs(near.texels[i] - far.texels[i]) > 1.01f / 255.0f;
    CHECK(differing <= 3);
}

TEST_CASE("a camera looks right at the ends of what a scene file may say", "[graphs][hard]")
{
    const Folder folder;
    write_square(folder);
    const auto seen = [&](const std::string& more, const std::string& place = "0,0,4") {
        return show(load(folder, {.camera = "\"position\": [" + place + "], \"direction\": [0,0,-1]" + more}));
    };
    check_square_is_seen(seen(R"(, "near": 3.9999, "far": 4.0001)"));
    check_square_is_seen(seen(R"(, "near": 1e-15, "far": 1e15)"));
    check_square_is_seen(seen(R"(, "near": 1, "far": 9e29)"));
    CHECK(seen(R"(, "near": 1, "far": 3.99)").covered() == 0);
    CHECK(seen(R"(, "near": 4.01)").covered() == 0);
    CHECK(seen(R"(, "vertical_fov_degrees": 1e-30)").covered() == 64 * 64);    // the square's middle fills the view
    CHECK(seen(R"(, "vertical_fov_degrees": 179.9999)").covered() == 0);       // the square is less than a texel
    CHECK(seen("", "0,0,0").covered() == 0);                                   // inside the surface
    CHECK(seen("", "0,0,1e6").covered() == 0);                                 // behind the far plane
    CHECK(seen(R"(, "far": 3e6, "vertical_fov_degrees": 1e-4)", "0,0,1e6").covered() == 64 * 64); // 1.7 m wide there
    CHECK(seen("", "3e38,-3e38,3e38").covered() == 0);
}
