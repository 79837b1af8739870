// Output files: sequences, refusals before anything is drawn, and files left alone.
#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

void write_graph(const Workplace& place)
{
    place.write("g.graph.json", test::tone_map_graph());
    place.write_picture("a.pfm", test::flat({3, 2}, {1, 1, 1}));
}

test::Outcome render(const Workplace& place, const std::vector<std::string>& outs, const std::vector<std::string>& more = {})
{
    std::vector<std::string> words = {"render", "g.graph.json", "--in", "image=a.pfm"};
    for (const std::string& out : outs)
        words.insert(words.end(), {"--out", out});
    words.insert(words.end(), more.begin(), more.end());
    return place.run(words);
}

} // namespace

TEST_CASE("radiance is not written to display files, and the hint says what to do", "[tool][outputs]")
{
    const Workplace place;
    write_graph(place);
    for (const char* file : {"o.png", "o.jpg", "o.JPEG"}) {
        const test::Outcome outcome = render(place, {std::string("bright_part=") + file});
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Contains("error[radiance_to_png]") && Contains("tone_map") && Contains(".exr"));
        CHECK_FALSE(place.has(file));
    }
    CHECK(render(place, {"bright_part=o.exr", "color=o.png"}).code == 0);
    CHECK(place.has("o.exr"));
    CHECK(place.has("o.png"));
}

TEST_CASE("one refused output keeps all from being written", "[tool][outputs]")
{
    const Workplace place;
    write_graph(place);
    const auto files = place.files();
    const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
        {{"color=o.png", "bright_part=o2.png"}, "radiance_to_png"},
        {{"color=o.png", "color=o.bmp"}, "picture_format"},
        {{"color=o.png", "shown=./o.png"}, "duplicate_file"},
        {{"color=o.png", "bright_part=no_such_folder/o.exr"}, "file_unwritable"},
        {{"color=o.png", "colour=o2.png"}, "unknown_output"},
        {{"color=o.png", "shown.colour=o2.png"}, "unknown_output"},
    };
    for (const auto& [outs, code] : refused) {
        INFO(outs[1]);
        const test::Outcome outcome = render(place, outs);
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Contains("error[" + code + "]") && Contains("--out " + outs[1]));
    }
    CHECK_THAT(render(place, {"colr=o.png"}).err, Contains("did you mean `color`?"));
    CHECK(place.files() == files);
}

TEST_CASE("a number in the file's name writes every frame", "[tool][outputs]")
{
    const Workplace place;
    // Each frame shows its own number.
    place.write("own/counted.glsl", R"(/*{ "pass": "counted", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "reads": ["frame"] }*/
vec3 counted(vec2 uv) { return image(uv) * float(frame_index()); }
)");
    place.write("g.graph.json", R"({ "passgraph": 1, "inputs": { "image": "radiance" },
  "passes": { "n": { "pass": "counted", "inputs": { "image": "image" } } }, "outputs": { "color": "n" } })");
    place.write_picture("a.pfm", test::flat({3, 2}, {1, 1, 1}));
    const test::Outcome outcome = render(place, {"color=f_%04d.pfm", "n=last.pfm", "n.color=%d.pfm"}, {"--frames", "3", "--passes", "own"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    for (const char* file : {"f_0000.pfm", "f_0001.pfm", "f_0002.pfm", "0.pfm", "1.pfm", "2.pfm", "last.pfm"})
        REQUIRE(place.has(file));
    CHECK_FALSE(place.has("f_0003.pfm"));
    CHECK(place.read_picture("f_0000.pfm").at(0, 0) == 0.0f);
    CHECK(place.read_picture("f_0001.pfm").at(0, 0) == 1.0f);
    CHECK(place.read_picture("f_0002.pfm").at(0, 0) == 2.0f);
    CHECK(place.read_picture("last.pfm").at(0, 0) == 2.0f);
}

TEST_CASE("equal runs write equal files, and nothing but files", "[tool][outputs]")
{
    const Workplace place;
    write_graph(place);
    const test::Outcome outcome = render(place, {"color=one.png"});
    CHECK(outcome.code == 0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty()); // no progress where no terminal is
    REQUIRE(render(place, {"color=two.png"}).code == 0);
    CHECK(place.read("one.png") == place.read("two.png"));
}
