// A graph of a tone map and a pass with every kind of setting.
#pragma once

#include <memory>
#include <string>

#include <passgraph/shader/pass_file.hpp>

#include "support/catch.hpp"
#include "tool/view/stack.hpp"

namespace passgraph::test {

inline PassLibrary library_with_knobs()
{
    const Result<PassPtr> pass = read_pass(R"(/*{
  "pass": "knobs",
  "summary": "Has every kind of setting.",
  "inputs": { "image": "display" },
  "outputs": { "color": "display" },
  "params": { "gain": { "type": "float", "default": 1, "range": [0, 4], "unit": "stops", "group": "light", "label": "Brightness" },
              "tint": { "type": "color", "default": [1, 1, 1], "range": [0, 1] },
              "steps": { "type": "int", "default": 4, "range": [1, 16], "visible_if": "gain > 0 && shape == shape_round" },
              "fine": { "type": "float", "default": 0, "range": [0, 1], "step": 0.25 },
              "flip": { "type": "bool", "default": false } },
  "choices": { "shape": { "items": ["square", "round"], "default": "square" } },
  "ladders": { "taps": { "items": ["5", "9"], "default": "5" } },
  "source": "own"
}*/
vec3 knobs(vec2 uv)
{
#if shape == shape_round
    return image(uv) * gain * tint + float(steps) * fine;
#else
    return image(uv) * gain * tint + fine + (flip ? 1.0 : 0.0) + float(taps);
#endif
}
)",
                                                "knobs.glsl", "test", {});
    if (!pass)
        FAIL(to_text(pass.error()));
    PassLibrary library = builtin_passes();
    library.add(*pass);
    return library;
}

inline const std::string kSmallGraph = R"({
  "passgraph": 1,
  "inputs": { "photo": "radiance" },
  "passes": {
    "shown": { "pass": "tone_map", "inputs": { "image": "photo" }, "params": { "exposure": 2 } }, // brighter
    "film": { "pass": "knobs", "inputs": { "image": "shown" } }
  },
  "params": { "light": "shown.exposure", "knob": ["film.gain", "light"] },
  "outputs": { "color": "film" }
}
)";

inline tool::view::Stack small_stack()
{
    Result<GraphDescription> graph = read_graph_description(kSmallGraph, "small.graph.json");
    REQUIRE(graph);
    return {.file = "small.graph.json", .name = "small", .description = std::make_shared<const GraphDescription>(std::move(*graph))};
}

} // namespace passgraph::test
