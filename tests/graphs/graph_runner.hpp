// Renders whole graphs for tests: a graph's text in, its pictures out.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <passgraph/core/compile.hpp>
#include <passgraph/core/graph_file.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph::test {

struct GraphRun {
    CompileOptions options{};
    std::map<std::string, Picture> pictures{};
    const Scene* scene = nullptr;
    int frames = 1;
};

/// The graph of a JSON text or of a sample file; failures fail the test.
Graph graph_of(const std::string& text, const PassLibrary& library = builtin_passes());
Graph sample_graph(const std::string& path_below_samples);

/// Compiles, renders and reads every output. `counters` receives the renderer's, when given.
std::map<std::string, Picture> run_graph(const Graph& graph, GraphRun run,
                                         std::vector<Renderer::Counters>* counters = nullptr);

/// The largest absolute difference between two pictures of equal shape.
float largest_difference(const Picture& a, const Picture& b);

} // namespace passgraph::test
