// Draws small scenes and checks what any picture must hold.
#include "graphs/scene_show.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

namespace passgraph::test {
namespace {

constexpr const char* kGraph = R"({
  "passgraph": 1, "inputs": { "scene": { "kind": "scene" } },
  "passes": {
    "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } },
    "lit": { "pass": "pbr", "inputs": { "albedo": "surface.albedo", "material": "surface.material",
      "normal": "surface.normal", "position": "surface.position", "emissive": "surface.emissive", "sky": "scene.sky" } },
    "view": { "pass": "sky", "inputs": { "image": "lit", "depth": "surface.depth", "sky": "scene.sky" },
              "codecs": { "color": "rgba32f" } },
    "shown": { "pass": "tone_map", "inputs": { "image": "view" }, "codecs": { "color": "rgba32f" } }
  },
  "outputs": { "albedo": "surface.albedo", "depth": "surface.depth", "radiance": "view", "display": "shown" } })";

Renderer make_renderer()
{
    CompileOptions options;
    options.extent = kShownExtent;
    const Result<Plan> plan = compile(graph_of(kGraph), options);
    if (!plan)
        FAIL(to_text(plan.error()));
    Result<Renderer> renderer = Renderer::create(*plan, {.loader = test_context().loader()});
    if (!renderer)
        FAIL(to_text(renderer.error()));
    return std::move(*renderer);
}

Picture read(Renderer& renderer, const std::string& output, float largest)
{
    const Result<Picture> picture = renderer.read(output);
    if (!picture)
        FAIL(to_text(picture.error()));
    for (const float value : picture->texels)
        if (!(value >= 0.0f && value <= largest)) // false for NaN
            FAIL(output << " holds " << value);
    return *picture;
}

} // namespace

int Shown::covered() const
{
    return static_cast<int>(std::count_if(depth.texels.begin(), depth.texels.end(), [](float d) { return d > 0.0f; }));
}

Shown show(const Scene& scene)
{
    // Never destroyed: its context goes before it would.
    static Renderer& renderer = *new Renderer(make_renderer());
    test_context();
    if (const auto done = renderer.set_scene(scene); !done)
        FAIL(to_text(done.error()));
    if (const auto done = renderer.render(); !done)
        FAIL(to_text(done.error()));
    Shown shown{read(renderer, "albedo", 1.0f), read(renderer, "depth", 1.0f), read(renderer, "radiance", 65504.0f),
                read(renderer, "display", 1.0f)};
    // The scene goes with its test; what the renderer keeps until the next call is this one.
    static const Scene none;
    if (const auto done = renderer.set_scene(none); !done)
        FAIL(to_text(done.error()));
    return shown;
}

std::string write_square(const Folder& folder, const std::string& textured)
{
    ModelBuilder model;
    model.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3);
    model.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    model.add_floats({0, 1, 1, 1, 1, 0, 0, 0}, 2);
    model.add(bytes_of(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}), 5123, 6, "SCALAR");
    const std::string texture =
        textured.empty() ? "" : fmt::format(R"(,"images":[{{"uri":"{}"}}],"textures":[{{"source":0}}])", textured);
    const std::string base = textured.empty() ? "" : R"("baseColorTexture":{"index":0},)";
    return model.write(folder, one_mesh(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":0)",
                                        fmt::format(R"(,"materials":[{{"pbrMetallicRoughness":{{{}"metallicFactor":0}}}}]{})",
                                                    base, texture)));
}

std::string SceneText::text() const
{
    const std::string element =
        model.empty() ? "" : fmt::format(R"({{"model": "{}"{}}})", model, placed.empty() ? "" : ", " + placed);
    return fmt::format("{{\"passgraph_scene\": 1, \"camera\": {{{}}},\n\"lights\": [{}],\n\"elements\": [{}]{}}}", camera,
                       lights, element, more);
}

Scene load(const Folder& folder, const SceneText& text)
{
    auto scene = load_scene(folder.write("s.scene.json", text.text()));
    if (!scene)
        FAIL(to_text(scene.error()));
    return std::move(*scene);
}

} // namespace passgraph::test
