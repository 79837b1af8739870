// Wrong graphs: every mistake in one go, with its place, the fix, exit code 1, and nothing written.
#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

/// A graph of these passes over two inputs, all in one line each, so that places are easy to count.
std::string graph_of(const std::string& passes, const std::string& outputs = R"("color": "shown")")
{
    return "{ \"passgraph\": 1,\n  \"inputs\": { \"image\": \"radiance\", \"seen\": \"display\" },\n  \"passes\": {\n" + passes +
           "\n  },\n  \"outputs\": { " + outputs + " } }\n";
}

const std::string kShown = R"("shown": { "pass": "tone_map", "inputs": { "image": "image" } })";

/// The errors of `check`; `plan` and `render` must say the same and write nothing.
std::string errors_of(const std::string& text)
{
    const Workplace place;
    place.write("g.graph.json", text);
    place.write_picture("a.pfm", test::flat({2, 2}, {1, 1, 1}));
    const auto files = place.files();
    const test::Outcome checked = place.run({"check", "g.graph.json"});
    CHECK(checked.code == 1);
    CHECK(checked.out.empty());
    const test::Outcome planned = place.run({"plan", "g.graph.json"});
    CHECK(planned.code == 1);
    CHECK(planned.err == checked.err);
    const test::Outcome rendered = place.run({"render", "g.graph.json", "--in", "image=a.pfm", "--out", "color=a.png"});
    CHECK(rendered.code == 1);
    CHECK_THAT(rendered.err, Contains(checked.err.substr(0, checked.err.find('\n'))));
    CHECK(place.files() == files);
    return checked.err;
}

} // namespace

TEST_CASE("a right graph checks ok", "[tool][check]")
{
    const Workplace place;
    place.write("g.graph.json", graph_of(kShown));
    const test::Outcome outcome = place.run({"check", "g.graph.json"});
    CHECK(outcome.err.empty());
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.out, Contains("ok: 1 pass, 2 inputs, 1 output; 1 step"));
}

TEST_CASE("a composite checks ok, and its mistakes are found", "[tool][check]")
{
    const Workplace place;
    const auto composite = [](const std::string& pass) {
        return R"({ "passgraph": 1, "pass": "softened", "inputs": { "image": "radiance" },
  "passes": { "low": { "pass": ")" + pass + R"(", "inputs": { "image": "image" } } },
  "outputs": { "color": "low" } })";
    };
    place.write("softened.graph.json", composite("bright"));
    const test::Outcome right = place.run({"check", "softened.graph.json"});
    CHECK(right.err.empty());
    CHECK(right.code == 0);
    CHECK_THAT(right.out, Contains("composite `softened`"));
    place.write("softened.graph.json", composite("brigt"));
    const test::Outcome wrong = place.run({"check", "softened.graph.json"});
    CHECK(wrong.code == 1);
    CHECK_THAT(wrong.err, Contains("softened.graph.json:2:") && Contains("unknown_pass") && Contains("did you mean `bright`?"));
}

TEST_CASE("two wires of different signals name both ends, the place and the fix", "[tool][check]")
{
    const std::string errors = errors_of(graph_of(R"(    "shown": { "pass": "tone_map", "inputs": { "image": "seen" } })"));
    CHECK_THAT(errors, Contains("g.graph.json:4:57: error[signal_mismatch]") && Contains("shown.image") && Contains("radiance") &&
                           Contains("display") && Contains("seen") && Contains("\n  hint: "));
}

TEST_CASE("every mistake of a graph is reported in one go", "[tool][check]")
{
    const std::string errors = errors_of(graph_of(
        R"(    "shown": { "pass": "tone_map", "inputs": { "image": "seen" }, "params": { "exposure": 1000 } },
    "soft": { "pass": "vignete", "inputs": { "image": "shown" } },
    "dark": { "pass": "vignette", "inputs": { "image": "shown" }, "params": { "amout": 1, "inner": "wide" } },
    "lost": { "pass": "vignette", "inputs": { "image": "nothing" } })"));
    CHECK_THAT(errors, Contains("signal_mismatch") && Contains("param_out_of_range") && Contains("unknown_pass") &&
                           Contains("did you mean `vignette`?") && Contains("unknown_param") && Contains("did you mean `amount`?") &&
                           Contains("wrong_type") && Contains("unknown_image"));
}

TEST_CASE("passes that wait for each other are a cycle", "[tool][check]")
{
    const std::string errors = errors_of(graph_of(R"(    "a": { "pass": "vignette", "inputs": { "image": "b" } },
    "b": { "pass": "vignette", "inputs": { "image": "a" } }, )" + kShown));
    CHECK_THAT(errors, Contains("error[cycle]") && Contains("a -> b") && Contains("\n  hint: "));
}

TEST_CASE("a key that stands twice is a mistake", "[tool][check]")
{
    CHECK_THAT(errors_of(graph_of("    " + kShown + ",\n    " + kShown)), Contains("g.graph.json:5:5: error[json_duplicate_key]"));
    CHECK_THAT(errors_of(graph_of("    \"image\": { \"pass\": \"vignette\", \"inputs\": { \"image\": \"image\" } }, " + kShown)),
               Contains("error[duplicate_name]"));
}

TEST_CASE("a truncated or malformed graph says where it breaks off", "[tool][check]")
{
    const std::string whole = graph_of("    " + kShown);
    CHECK_THAT(errors_of(whole.substr(0, whole.size() / 2)), Contains("g.graph.json:4:") && Contains("error[json_syntax]"));
    CHECK_THAT(errors_of(""), Contains("g.graph.json:1:1: error[json_syntax]"));
    CHECK_THAT(errors_of("[1, 2]"), Contains("g.graph.json:1:1: error[wrong_type]"));
    CHECK_THAT(errors_of(R"({ "passgraph": 2, "passes": {}, "outputs": {} })"), Contains("error[version_unknown]"));
    CHECK_THAT(errors_of(R"({ "passgraph": 1, "passess": {}, "passes": {}, "outputs": {} })"),
               Contains("g.graph.json:1:19: error[unknown_field]") && Contains("did you mean `passes`?"));
}

TEST_CASE("settings of the command line are checked like the file's", "[tool][set]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const auto errors = [&](const std::vector<std::string>& settings) {
        std::vector<std::string> words = {"plan", "g.graph.json"};
        for (const std::string& setting : settings)
            words.insert(words.end(), {"--set", setting});
        const test::Outcome outcome = place.run(words);
        CHECK(outcome.code == 1);
        return outcome.err;
    };
    CHECK_THAT(errors({"shown.exposer=2"}), Contains("--set shown.exposer=2: error[unknown_param]") && Contains("did you mean `shown.exposure`?"));
    CHECK_THAT(errors({"shwn.exposure=2"}), Contains("error[unknown_param]") && Contains("did you mean `shown.exposure`?"));
    CHECK_THAT(errors({"shown.exposure=bright"}), Contains("error[wrong_type]") && Contains("a number"));
    CHECK_THAT(errors({"shown.exposure=1,2,3"}), Contains("error[wrong_type]"));
    CHECK_THAT(errors({"shown.exposure=1e9"}), Contains("error[param_out_of_range]"));
    CHECK_THAT(errors({"shown.exposure=nan"}), Contains("error[param_out_of_range]"));
    CHECK_THAT(errors({"brightness=-1", "bright_part.knee=7"}), Contains("--set brightness=-1") && Contains("--set bright_part.knee=7"));
}

TEST_CASE("a preset's mistakes have their place in it", "[tool][set]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    place.write("p.json", "{ \"passgraph_preset\": 1, \"values\": {\n  \"brightness\": 2,\n  \"shown.white\": { },\n  \"shown.exposre\": 2 } }");
    const test::Outcome form = place.run({"plan", "g.graph.json", "--preset", "p.json"});
    CHECK(form.code == 1);
    CHECK_THAT(form.err, Contains("p.json:3:18: error[wrong_type]"));
    place.write("p.json", "{ \"passgraph_preset\": 1, \"values\": {\n  \"shown.exposre\": 2 } }");
    const test::Outcome name = place.run({"plan", "g.graph.json", "--preset", "p.json"});
    CHECK(name.code == 1);
    CHECK_THAT(name.err, Contains("p.json:2:20: error[unknown_param]"));
    CHECK(place.run({"plan", "g.graph.json", "--preset", "none.json"}).code == 1);
}
