// A graph file with changed settings in it is its author's file otherwise.
#include "support/catch.hpp"
#include "tool/view/graph_edit.hpp"
#include "view/small_stack.hpp"

using namespace passgraph;
using namespace passgraph::tool::view;

namespace {

Result<std::string> edited(const Settings& settings)
{
    return with_settings(test::kSmallGraph, "small.graph.json", settings, *test::small_stack().description, test::library_with_knobs());
}

} // namespace

TEST_CASE("a value that is there is replaced, and nothing else changes", "[view][graph_edit]")
{
    const auto text = edited({{"shown.exposure", {"shown.exposure", {0.5}, "", {}}}});
    REQUIRE(text);
    std::string expected = test::kSmallGraph;
    const std::string old = "\"exposure\": 2 }";
    expected.replace(expected.find(old), old.size(), "\"exposure\": 0.5 }");
    CHECK(*text == expected);
}

TEST_CASE("settings that the file does not have are added where they belong", "[view][graph_edit]")
{
    const auto text = edited({{"shown.white", {"shown.white", {4.0}, "", {}}},
                              {"film.shape", {"film.shape", {}, "round", {}}},
                              {"film.taps", {"film.taps", {}, "9", {}}},
                              {"film.tint", {"film.tint", {1.0, 0.5, 0.25}, "", {}}},
                              {"film.flip", {"film.flip", {}, "true", {}}}});
    REQUIRE(text);
    CHECK(text->find("\"params\": { \"exposure\": 2, \"white\": 4 } }, // brighter") != std::string::npos);
    CHECK(text->find("\"choices\": { \"shape\": \"round\" }") != std::string::npos);
    CHECK(text->find("\"rungs\": { \"taps\": \"9\" }") != std::string::npos);
    CHECK(text->find("\"params\": { \"flip\": true, \"tint\": [1, 0.5, 0.25] }") != std::string::npos);
    // And it says the same as the settings did.
    const auto graph = read_graph_description(*text, "edited.graph.json");
    REQUIRE(graph);
    const PassLibrary library = test::library_with_knobs();
    const Graph built = build_graph(*graph, library);
    CHECK(built.errors().empty());
    const GraphNode& film = built.nodes()[static_cast<size_t>(built.find_node("film"))];
    CHECK(film.selections[static_cast<size_t>(film.pass->find_selection("shape"))] == 1);
    CHECK(film.selections[static_cast<size_t>(film.pass->find_selection("taps"))] == 1);
    CHECK(film.params[static_cast<size_t>(film.pass->find_param("tint"))] == Value(1.0, 0.5, 0.25));
    CHECK(film.params[static_cast<size_t>(film.pass->find_param("flip"))] == Value(1.0));
}

TEST_CASE("a setting of no pass of the file is told", "[view][graph_edit]")
{
    const auto text = edited({{"film.none", {"film.none", {1.0}, "", {}}}, {"lost.gain", {"lost.gain", {1.0}, "", {}}}});
    REQUIRE_FALSE(text);
    REQUIRE(text.error().size() == 2);
    CHECK(text.error()[0].code == "unknown_param");
    CHECK(text.error()[1].code == "unknown_image");
}
