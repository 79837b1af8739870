// Damaged scene, graph and pass files: read, or refused with errors that have places; never a crash.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <passgraph/core/baked_passes.hpp>
#include <passgraph/core/compile.hpp>
#include <passgraph/core/graph_file.hpp>
#include <passgraph/scene/scene_file.hpp>
#include <passgraph/shader/pass_file.hpp>

#include "damage/mutate.hpp"
#include "scene/files.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

const std::string kRoot = PASSGRAPH_SOURCE_DIR;

std::string text_of(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    REQUIRE(stream);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Up to three damages, one on another.
std::string damaged(const std::string& text, Random& random)
{
    std::string worse = damaged_text(text, random);
    for (auto more = random() % 3; more > 0; --more)
        worse = damaged_text(std::move(worse), random);
    return worse;
}

} // namespace

TEST_CASE("damaged graph files are compiled or refused", "[damage][graph]")
{
    Random random(11);
    int compiled = 0;
    for (const char* sample : {"deferred_demo/bloom", "deferred_demo/night", "photo_stack/photo_stack"}) {
        const std::string text = text_of(kRoot + "/samples/" + sample + ".graph.json");
        for (int i = 0; i < 1500; ++i) {
            const std::string worse = damaged(text, random);
            INFO(worse);
            const auto description = read_graph_description(worse, "g.json");
            if (!description) {
                check_errors(description.error(), worse, "g.json");
                continue;
            }
            CompileOptions options;
            options.extent = {64, 36};
            const auto plan = compile(build_graph(*description, builtin_passes()), options);
            if (!plan)
                check_errors(plan.error(), worse, "g.json");
            compiled += plan.has_value();
        }
    }
    CHECK(compiled > 100); // the damage is not so great that only the JSON reader is tried
    CHECK(compiled < 4000);
}

TEST_CASE("damaged scene files are loaded or refused", "[damage][scene]")
{
    const Folder folder;
    const std::string text = R"({
  "passgraph_scene": 1, "name": "n",
  "camera": { "position": [0, 1, 4], "direction": [0, -1, -2], "up": [0, 1, 0], "vertical_fov_degrees": 45, "near": 1, "far": 2001 },
  "elements": [
    { "name": "box", "model": "box01.glb", "position": [0, 0, 0], "rotation_degrees": [0, 168, 0], "scale": [1, -2, 0.5] },
    { "name": "more", "model": "box01.glb", "scale": 0.9 }
  ],
  "lights": [
    { "name": "moon", "kind": "directional", "color": [0.6, 0.95, 2.4], "direction": [0.75, -0.75, -0.75] },
    { "name": "lamp", "kind": "point", "color": [7500, 3300, 600], "position": [42, 44, 22], "radius": 220 }
  ]
})";
    std::filesystem::copy(data_file("models/box01.glb"), folder.path("box01.glb"));
    Random random(12);
    int loaded = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string worse = damaged(text, random);
        INFO(worse);
        const std::string path = folder.write("s.json", worse);
        const auto scene = load_scene(path);
        if (!scene) {
            check_errors(scene.error(), worse, path);
            continue;
        }
        ++loaded;
        const Camera& camera = scene->camera;
        if (!(camera.near_plane > 0.0f && camera.near_plane < camera.far_plane && camera.vertical_fov > 0.0f &&
              camera.vertical_fov < 3.14159274f))
            FAIL("a camera that cannot be used");
    }
    CHECK(loaded > 100);
    CHECK(loaded < 1800);
}

TEST_CASE("damaged pass files are read or refused", "[damage][pass]")
{
    Random random(13);
    int whole = 0;
    for (const char* pass : {"bloom/bright", "blur/blur_direction", "lighting/pbr_surface", "geometry/gbuffer", "screen/vignette"}) {
        const std::string text = text_of(kRoot + "/passes/" + pass + ".glsl");
        for (int i = 0; i < 150; ++i) {
            const std::string worse = damaged(text, random);
            INFO(worse);
            const auto read = read_pass(worse, "p.glsl", "family", {kRoot + "/passes/common"});
            if (!read)
                check_errors(read.error(), worse, "p.glsl");
            whole += read.has_value();
        }
    }
    CHECK(whole > 20);
    CHECK(whole < 700);
}
