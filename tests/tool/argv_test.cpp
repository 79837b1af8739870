// What the program does with arguments that it cannot parse, and with those that say what it is.
#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

TEST_CASE("arguments that cannot be parsed exit 2 and say so on stderr only", "[tool][argv]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const std::vector<std::vector<std::string>> unparsed = {
        {},
        {"no_such_command"},
        {"plan"},
        {"plan", "g.graph.json", "--no-such-option"},
        {"plan", "g.graph.json", "--size", "1280"},
        {"plan", "g.graph.json", "--size", "12x34x56"},
        {"plan", "g.graph.json", "--size", "-4x4"},
        {"plan", "g.graph.json", "--size", "4x4px"},
        {"plan", "g.graph.json", "--format", "yaml"},
        {"plan", "g.graph.json", "--off", "fuse,frobnicate"},
        {"plan", "g.graph.json", "--set", "shown.exposure"},
        {"plan", "g.graph.json", "--set", "=2"},
        {"render", "g.graph.json", "--in", "image=a.png"}, // no --out
        {"render", "g.graph.json", "--in", "image", "--out", "color=a.png"},
        {"render", "g.graph.json", "--out", "a.png"},
        {"render", "g.graph.json", "--out", "color=a.png", "--frames", "0"},
        {"render", "g.graph.json", "--out", "color=a.png", "--frames", "many"},
        {"render", "g.graph.json", "--out", "color=a.png", "--context", "vulkan"},
        {"eval", "x"}, // no --csv
    };
    for (const auto& words : unparsed) {
        std::string line;
        for (const std::string& word : words)
            line += word + " ";
        INFO(line);
        const test::Outcome outcome = place.run(words);
        CHECK(outcome.code == 2);
        CHECK(outcome.out.empty());
        CHECK_FALSE(outcome.err.empty());
    }
    CHECK(place.files() == std::vector<std::string>{"g.graph.json"});
}

TEST_CASE("help and version are data, not mistakes", "[tool][argv]")
{
    const Workplace place;
    const test::Outcome help = place.run({"--help"});
    CHECK(help.code == 0);
    for (const char* command : {"passes", "describe", "check", "plan", "run", "render", "bench", "eval"})
        CHECK_THAT(help.out, Contains(command));
    const test::Outcome version = place.run({"--version"});
    CHECK(version.code == 0);
    CHECK_THAT(version.out, Contains("passgraph 0."));
    CHECK_THAT(place.run({"render", "--help"}).out, Contains("--frames") && Contains("%04d"));
}

TEST_CASE("a flag takes several pairs and leaves the words behind them alone", "[tool][argv]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const auto outcome = place.run({"plan", "--set", "brightness=2", "bright_part.knee=0", "g.graph.json", "--format", "json"});
    CHECK(outcome.err == "");
    CHECK(outcome.code == 0);
    // Both settings arrived: the unknown one is reported.
    const auto refused = place.run({"plan", "--set", "brightness=2", "bright_part.nee=0", "g.graph.json"});
    CHECK(refused.code == 1);
    CHECK_THAT(refused.err, Contains("`bright_part.nee`"));
}

TEST_CASE("a machine without any context is named, with exit code 3", "[tool][device]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    place.write_picture("a.pfm", test::flat({2, 2}, {1, 1, 1}));
    const auto outcome = place.run({"render", "g.graph.json", "--in", "image=a.pfm", "--out", "color=a.png", "--context", "osmesa"},
                                   "PASSGRAPH_OSMESA=/no/such/library.so");
    CHECK(outcome.code == 3);
    CHECK_THAT(outcome.err, Contains("error[context_missing]") && Contains("hint: "));
    CHECK_FALSE(place.has("a.png"));
    // Looking at plans and passes needs no context.
    CHECK(place.run({"plan", "g.graph.json"}, "PASSGRAPH_OSMESA=/no/such/library.so").code == 0);
}
