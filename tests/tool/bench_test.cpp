// `bench`: its table, its JSON, and two plans compared.
#include "program.hpp"
#include "schema.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

TEST_CASE("bench times the frame and each step, and its JSON keeps its schema", "[tool][bench]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    place.write_picture("a.pfm", test::flat({32, 16}, {1, 1, 1}));
    const Json schema = test::read_schema("lib/tool/schemas/bench.schema.json");
    const std::vector<std::string> words = {"bench", "g.graph.json", "--in", "image=a.pfm", "--frames", "4"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), words.begin(), words.end());
        const test::Outcome outcome = place.run(more);
        CHECK(outcome.err == "");
        CHECK(outcome.code == 0);
        return outcome.out;
    };
    const Json plain = test::json_of(with({"--json", "--off", "fuse,specialise"}));
    CHECK(test::find_schema_violations(plain, schema) == std::vector<std::string>{});
    CHECK(plain.find("steps")->array.size() == 2);
    CHECK(plain.find("frames")->number == 4);
    CHECK(plain.find("size")->array[0].number == 32);
    CHECK(plain.find("frame_ms")->find("median")->number >= plain.find("frame_ms")->find("lowest")->number);
    CHECK(plain.find("frame_ms")->find("lowest")->number > 0.0);
    const Json compared = test::json_of(with({"--json", "--compare-off", "fuse"}));
    CHECK(test::find_schema_violations(compared, schema) == std::vector<std::string>{});
    CHECK(compared.find("steps")->array.size() == 1);
    CHECK(compared.find("compared")->find("ratio")->number > 0.0);
    CHECK_THAT(with({}), Contains("32x16") && Contains("ms  the frame") && Contains("MB"));
}

TEST_CASE("bench names what is missing like render does", "[tool][bench]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const test::Outcome outcome = place.run({"bench", "g.graph.json"});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Contains("error[input_missing]"));
}
