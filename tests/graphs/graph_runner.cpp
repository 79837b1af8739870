// Renders whole graphs for tests: a graph's text in, its pictures out.
#include "graphs/graph_runner.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/test_context.hpp"

namespace passgraph::test {
namespace {

template <class T>
T expect(Result<T> result)
{
    if (!result)
        FAIL(to_text(result.error()));
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

} // namespace

Graph graph_of(const std::string& text, const PassLibrary& library)
{
    return build_graph(expect(read_graph_description(text, "test.graph.json")), library);
}

Graph sample_graph(const std::string& path_below_samples)
{
    return expect(load_graph(std::string(PASSGRAPH_SOURCE_DIR) + "/samples/" + path_below_samples, builtin_passes()));
}

std::map<std::string, Picture> run_graph(const Graph& graph, GraphRun run, std::vector<Renderer::Counters>* counters)
{
    Context& context = test_context();
    for (const auto& [name, picture] : run.pictures)
        run.options.picture_extents[name] = picture.extent;
    RendererOptions options;
    options.loader = context.loader();
    Renderer renderer = expect(Renderer::create(expect(compile(graph, run.options)), options));
    for (const auto& [name, picture] : run.pictures)
        expect(renderer.import_picture(name, picture));
    if (run.scene)
        expect(renderer.set_scene(*run.scene));
    for (int frame = 0; frame < run.frames; ++frame) {
        Frame now;
        now.index = frame;
        expect(renderer.render(now));
        if (counters)
            counters->push_back(renderer.counters());
    }
    std::map<std::string, Picture> outputs;
    for (const GraphOutput& output : graph.outputs())
        outputs[output.name] = expect(renderer.read(output.name));
    return outputs;
}

float largest_difference(const Picture& a, const Picture& b)
{
    REQUIRE(a.extent == b.extent);
    REQUIRE(a.channels == b.channels);
    float largest = 0.0f;
    for (size_t i = 0; i < a.texels.size(); ++i)
        largest = std::max(largest, std::abs(a.texels[i] - b.texels[i]));
    return largest;
}

} // namespace passgraph::test
