// Hard values on their way through the bloom chain: one bad texel, the largest of all, odd sizes, many stores.
#include <cmath>
#include <cstring>
#include <limits>

#include <passgraph/shader/pass_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

const char* const kBloom = R"({ "passgraph": 1, "inputs": { "scene": "radiance" }, "passes": {
  "bright": { "pass": "bright", "inputs": { "image": "scene" } },
  "half": { "pass": "downsample", "inputs": { "image": "bright" } },
  "glow": { "pass": "gaussian_blur", "inputs": { "image": "half" } },
  "film": { "pass": "bloom_combine", "inputs": { "scene": "scene", "bloom": "glow" } },
  "shown": { "pass": "tone_map", "inputs": { "image": "film" } } },
  "outputs": { "color": "shown", "film": "film" } })";

std::map<std::string, Picture> bloomed(const Picture& scene)
{
    static const Graph graph = graph_of(kBloom);
    return run_graph(graph, {.pictures = {{"scene", scene}}});
}

bool is_equal(const Picture& a, const Picture& b)
{
    return a.extent == b.extent && std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

double sum(const Picture& picture, int channel)
{
    double total = 0.0;
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x)
            total += static_cast<double>(picture.at(x, y, channel));
    return total;
}

/// The codes of the errors when a graph of one pass has this setting.
std::string refusal(const std::string& pass, const std::string& param, double value)
{
    Graph graph;
    PassArguments arguments;
    arguments.inputs = {{"image", graph.picture<Radiance>("image")}};
    PassArguments::Setting setting;
    setting.name = param;
    setting.numbers = {value};
    arguments.settings = {setting};
    graph.output("out", graph.add(pass, std::move(arguments))[""]);
    const auto plan = compile(graph);
    return plan ? "taken" : plan.error().front().code;
}

} // namespace

TEST_CASE("one bad texel before bloom is as good as its replacement, bit for bit", "[catalogue][hdr]")
{
    struct Row {
        float bad;
        float replacement;
    };
    const float infinity = std::numeric_limits<float>::infinity();
    const Row rows[] = {{std::numeric_limits<float>::quiet_NaN(), 0.0f}, {infinity, 65504.0f}, {-infinity, 0.0f}, {-1000.0f, 0.0f}, {65520.0f, 65504.0f}};
    for (const Row& row : rows) {
        Picture bad = noise({33, 21}, 3, 0.0f, 2.0f, 11);
        Picture replaced = bad;
        for (int c = 0; c < 3; ++c) {
            bad.at(16, 10, c) = row.bad;
            replaced.at(16, 10, c) = row.replacement;
        }
        INFO("a texel of " << row.bad);
        const auto got = bloomed(bad);
        const auto expected = bloomed(replaced);
        CHECK(is_equal(got.at("film"), expected.at("film")));
        CHECK(is_equal(got.at("color"), expected.at("color")));
        for (const float value : got.at("film").texels)
            CHECK((value >= 0.0f && value <= 65504.0f));
    }
}

TEST_CASE("four of the largest half have that mean, and a picture of it stays that bright", "[catalogue][hdr]")
{
    for (const Extent extent : {Extent{2, 2}, Extent{9, 7}}) {
        const Picture picture = constant(extent, {65504.0f, 65504.0f, 65504.0f});
        for (const float value : run_for_output({.pass = "downsample", .inputs = {{"image", picture}}}).texels)
            CHECK(value == 65504.0f);
        for (const float value : run_for_output({.pass = "gaussian_blur", .inputs = {{"image", picture}}}).texels)
            CHECK(value == Approx(65504.0f).epsilon(2e-6)); // two sums of 13 products
    }
}

TEST_CASE("the bloom chain draws pictures of one row, one column and one texel", "[catalogue][hdr]")
{
    for (const Extent extent : {Extent{1, 1}, Extent{1, 9}, Extent{9, 1}, Extent{17, 13}}) {
        INFO(extent.width << " x " << extent.height);
        const auto film = bloomed(constant(extent, {2.0f, 2.0f, 2.0f})).at("film");
        CHECK(film.extent == extent);
        // A constant picture blooms by what is above the threshold of 0.8 with a knee of 0.4: 2 + (2 - 0.8), on halves.
        for (const float value : film.texels)
            CHECK(value == Approx(3.2f).epsilon(4.0 / 1024.0)); // four stores, each within 2^-10 where halves are cut off
    }
}

TEST_CASE("a sigma of 1000 and an exposure that is 0, infinite or 2^127 are refused", "[catalogue][hdr]")
{
    CHECK(refusal("gaussian_blur", "sigma", 1000.0) == "param_out_of_range");
    CHECK(refusal("tone_map", "exposure", 0.0) == "param_out_of_range");
    CHECK(refusal("tone_map", "exposure", std::numeric_limits<double>::infinity()) == "param_out_of_range");
    CHECK(refusal("tone_map", "exposure", std::ldexp(1.0, 127)) == "param_out_of_range");
    CHECK(refusal("tone_map", "exposure", 1.0) == "taken");
}

TEST_CASE("ten stores darken by no more than each one's rounding, and binary32 not at all", "[catalogue][hdr]")
{
    // Loss per store: below one unit in the last place where a device cuts off, 2^-10 of a half, 2^-6 of the 5-bit mantissa
    // of blue in r11f_g11f_b10f, 2^-6 of the 6-bit ones of red and green doubled by values just above a power of two.
    struct Row {
        const char* codec;
        double loss;
    };
    const Picture start = noise({32, 32}, 3, 0.1f, 4.0f, 80);
    for (const Row& row : {Row{"rgba32f", 1e-6}, Row{"rgba16f", std::ldexp(1.0, -10)}, Row{"r11f_g11f_b10f", std::ldexp(1.0, -5)}}) {
        INFO(row.codec);
        std::string passes;
        for (int i = 0; i < 10; ++i)
            passes += std::string(i > 0 ? ", " : "") + "\"b" + std::to_string(i) + "\": { \"pass\": \"vignette\", \"inputs\": { \"image\": \"" +
                      (i > 0 ? "b" + std::to_string(i - 1) : std::string("scene")) + "\" }, \"params\": { \"amount\": 1e-7 }, \"codecs\": { \"color\": \"" + row.codec +
                      "\" } }";
        GraphRun run{.pictures = {{"scene", start}}};
        run.options.fuse = false;
        const Picture out = run_graph(graph_of("{ \"passgraph\": 1, \"inputs\": { \"scene\": \"radiance\" }, \"passes\": { " + passes +
                                               " }, \"outputs\": { \"color\": \"b9\" } }"),
                                      run)
                                .at("color");
        for (int c = 0; c < 3; ++c) {
            const double share = sum(out, c) / sum(start, c);
            CHECK(share <= 1.0 + 10.0 * row.loss);
            CHECK(share >= 1.0 - 10.0 * row.loss);
        }
    }
}

TEST_CASE("linear grey of one half is code 188, encoded once", "[catalogue][hdr]")
{
    // IEC 61966-2-1: 255 (1.055 * 0.5^(1 / 2.4) - 0.055) = 187.5
    const std::string header = R"(/*{ "pass": "encode", "summary": "", "source": "", "inputs": { "image": "radiance" },
  "outputs": { "color": "display" } }*/
#include "srgb.glsl"
vec3 encode(vec2 uv) { return srgb_encode(image(uv)); }
)";
    PassLibrary library = builtin_passes();
    const auto pass = read_pass(header, "encode.glsl", "test", {std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common"});
    REQUIRE(pass);
    library.add(*pass);
    const Picture out = run_graph(graph_of(R"({ "passgraph": 1, "inputs": { "image": "radiance" },
  "passes": { "shown": { "pass": "encode", "inputs": { "image": "image" }, "codecs": { "color": "rgba8" } } },
  "outputs": { "color": "shown" } })",
                                           library),
                                  {.pictures = {{"image", constant({1, 1}, {0.5f, 0.5f, 0.5f})}}})
                            .at("color");
    const float code = out.at(0, 0, 0) * 255.0f;
    CHECK(code == Approx(188.0f).margin(0.51f));
}
