// Graphs of passes that are black where another is, for the tests of what is left out.
#pragma once

#include <optional>

#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

namespace passgraph::test {

inline Graph demo()
{
    auto graph = load_graph(std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/bloom.graph.json", builtin_passes());
    REQUIRE(graph);
    return *graph;
}

/// Names of the steps that are left out without a pixel.
inline std::vector<std::string> conditional(const Plan& plan)
{
    std::vector<std::string> names;
    for (const Plan::Step& candidate : plan.steps)
        if (candidate.skipped_by >= 0 && candidate.when_skipped.empty())
            names.push_back(candidate.name);
    return names;
}

inline constexpr Access kPointwise = {AccessClass::pointwise, 0};
inline constexpr Access kGather = {AccessClass::gather, 2};

/// `key` says where it is black; `glow` and `smear` hand black on, `lift` does not; `both` is black when both inputs are.
inline PassLibrary library_of(Signal signal = Signal::radiance)
{
    PassLibrary library;
    PassMaker key("key");
    key.input("image", kPointwise, signal).output("color", signal).body("vec3 key(vec2 uv) { return image(uv); }\n");
    key.pass.skip_when = "image(uv).r <= 0.5";
    library.add(key.done());
    for (const auto& [name, access, is_black] : {std::tuple{"glow", kGather, true}, {"smear", kGather, true}, {"lift", kGather, false}}) {
        PassMaker pass(name);
        pass.input("image", access, signal).output("color", signal);
        if (is_black)
            pass.pass.black = {{0}};
        library.add(pass.done());
    }
    PassMaker both("both");
    both.input("image", kPointwise, signal).input("glow", kGather, signal).output("color", signal);
    both.pass.black = {{0, 1}};
    library.add(both.done());
    return library;
}

class Chain {
public:
    explicit Chain(const PassLibrary& library) : graph_(library) {}
    AnyImage photo() { return graph_.picture<Radiance>("photo"); }
    AnyImage add(const std::string& pass, AnyImage image) { return add(pass, {{"image", image}}); }
    AnyImage add(const std::string& pass, std::vector<std::pair<std::string, AnyImage>> inputs, std::optional<Ratio> scale = {})
    {
        PassArguments arguments;
        arguments.scale = scale;
        for (const auto& [port, image] : inputs)
            arguments.inputs.push_back({port, image});
        return graph_.add(pass, arguments)[""];
    }
    Plan plan(AnyImage shown, CompileOptions options = {})
    {
        graph_.output("color", shown);
        options.extent = {64, 64};
        options.picture_extents = {{"photo", {64, 64}}};
        return planned(graph_, options);
    }
    Graph& graph() { return graph_; }

private:
    Graph graph_;
};

} // namespace passgraph::test
