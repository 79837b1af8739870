// `plan`: every form of it, the same bytes each time.
#include "program.hpp"
#include "schema.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

TEST_CASE("a plan is the same byte for byte, in every format", "[tool][plan]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    for (const char* format : {"text", "json", "dot"}) {
        const std::vector<std::string> words = {"plan", "g.graph.json", "--format", format, "--glsl", "--size", "17x13"};
        const test::Outcome first = place.run(words);
        CHECK(first.err == "");
        CHECK(first.code == 0);
        CHECK_FALSE(first.out.empty());
        CHECK(place.run(words).out == first.out);
    }
    CHECK_THAT(place.run({"plan", "g.graph.json", "--format", "dot"}).out, Contains("digraph"));
}

TEST_CASE("a plan's JSON keeps its schema, with and without GLSL", "[tool][plan]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const Json schema = test::read_schema("lib/core/plan.schema.json");
    const std::string plain = place.run({"plan", "g.graph.json", "--format", "json"}).out;
    const std::string full = place.run({"plan", "g.graph.json", "--format", "json", "--glsl", "--off", "fuse"}).out;
    CHECK(test::find_schema_violations(test::json_of(plain), schema) == std::vector<std::string>{});
    CHECK(test::find_schema_violations(test::json_of(full), schema) == std::vector<std::string>{});
    CHECK_THAT(plain, !Contains("#version"));
    CHECK_THAT(full, Contains("#version"));
}

TEST_CASE("--off fuse draws passes one by one", "[tool][plan]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const auto steps = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"plan", "g.graph.json", "--format", "json"};
        words.insert(words.end(), more.begin(), more.end());
        return test::json_of(place.run(words).out).find("steps")->array.size();
    };
    CHECK(steps({}) == 1);
    CHECK(steps({"--off", "fuse,specialise"}) == 2);
    CHECK(steps({"--off", "fuse"}) == 1); // a threshold of 0 leaves its pass out
    CHECK(steps({"--off", "specialise,unify,order"}) == 1);
}

TEST_CASE("pictures decide a plan's extents", "[tool][plan]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    place.write_picture("a.pfm", test::flat({31, 7}, {1, 1, 1}));
    CHECK_THAT(place.run({"plan", "g.graph.json"}).out, Contains("1280x720"));
    CHECK_THAT(place.run({"plan", "g.graph.json", "--in", "image=a.pfm"}).out, Contains("31x7") && !Contains("1280x720"));
}
