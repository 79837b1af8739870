// A user's own pass works like a built-in one, without building anything again.
#include <filesystem>
#include <fstream>

#include <passgraph/shader/pass_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// A folder of its own for each test, removed afterwards.
struct Folder {
    Folder()
        : path(std::filesystem::temp_directory_path() /
               ("passgraph_user_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))))
    {
        std::filesystem::create_directories(path / "common");
    }
    ~Folder() { std::filesystem::remove_all(path); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }
    std::filesystem::path path;
};

} // namespace

TEST_CASE("a user's ten-line pass fuses with built-in ones and reads its own common file", "[graphs][user]")
{
    Folder folder;
    folder.write("common/mine.glsl", "/// A third.\nfloat third(float x) { return x / 3.0; }\n");
    folder.write("grey.glsl", R"(/*{ "pass": "grey", "summary": "The mean of the channels.", "source": "arithmetic",
  "inputs": { "image": "display" }, "outputs": { "color": "display" }, "params": { "share": 1.0 } }*/
#include "mine.glsl"
vec3 grey(vec2 uv)
{
    vec3 seen = image(uv);
    return mix(seen, vec3(third(seen.r + seen.g + seen.b)), share);
}
)");
    PassLibrary library = builtin_passes();
    if (const auto loaded = load_pass_folder(folder.path.string(), library); !loaded)
        FAIL(to_text(loaded.error()));
    const Graph graph = graph_of(R"({
      "passgraph": 1,
      "inputs": { "picture": "display" },
      "passes": {
        "mine": { "pass": "grey", "inputs": { "image": "picture" } },
        "rim":  { "pass": "vignette", "inputs": { "image": "mine" }, "params": { "amount": 0 }, "codecs": { "color": "rgba32f" } }
      },
      "outputs": { "color": "rim" }
    })",
                                 library);
    GraphRun run;
    run.options.extent = {4, 4};
    run.pictures = {{"picture", constant({4, 4}, {0.25f, 0.5f, 0.75f})}};
    CHECK(compile(graph, run.options)->steps.size() == 1);
    const Picture result = run_graph(graph, run).at("color");
    for (const float value : result.texels)
        CHECK(value == Approx(0.5f).margin(2e-7)); // two roundings: the quotient and the mix
}

TEST_CASE("a port may be called like a member of what the pass reads", "[graphs][user]")
{
    Folder folder;
    folder.write("shine.glsl",
                 R"(/*{ "pass": "shine", "summary": "The first lamp's color, seen from a place.", "source": "a test",
  "reads": ["lights"], "inputs": { "position": "position" }, "outputs": { "lit": "radiance" }, "params": { "color": 2.0 } }*/
struct Seen { vec3 position; vec3 color; };
vec3 shine(vec2 uv)
{
    Seen seen = Seen(position(uv), light(0).color);
    return seen.color * color + seen.position + light(0).position * 0.0;
}
)");
    PassLibrary library = builtin_passes();
    if (const auto loaded = load_pass_folder(folder.path.string(), library); !loaded)
        FAIL(to_text(loaded.error()));
    const Graph graph = graph_of(R"({
      "passgraph": 1,
      "inputs": { "places": "position" },
      "passes": { "lit": { "pass": "shine", "inputs": { "position": "places" }, "codecs": { "lit": "rgba32f" } } },
      "outputs": { "lit": "lit" }
    })",
                                 library);
    Scene scene;
    scene.lights.push_back({});
    scene.lights.back().color = {0.5f, 1.0f, 2.0f};
    GraphRun run;
    run.options.extent = {2, 2};
    run.pictures = {{"places", constant({2, 2}, {1.0f, 2.0f, 3.0f})}};
    run.scene = &scene;
    const Picture result = run_graph(graph, run).at("lit");
    CHECK(result.at(1, 1, 0) == 2.0f);
    CHECK(result.at(1, 1, 1) == 4.0f);
    CHECK(result.at(1, 1, 2) == 7.0f);
}
