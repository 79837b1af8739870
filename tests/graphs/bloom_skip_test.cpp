// Bloom where nothing is bright: the device leaves its chain out, and no bit changes.
#include <cmath>
#include <random>

#include <passgraph/shader/pass_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// As the photo stack, with every image an output, or the last one alone.
Graph stack(bool shows_all, const std::string& threshold = "0.8", const std::string& knee = "0.5")
{
    return graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
        "graded": { "pass": "bloom_combine", "inputs": { "scene": "photo", "bloom": "photo" } },
        "bright": { "pass": "bright", "inputs": { "image": "graded" }, "params": { "threshold": )" + threshold + R"(, "knee": )" + knee + R"( },
                    "codecs": { "color": "rgba32f" } },
        "half":   { "pass": "downsample", "inputs": { "image": "bright" } },
        "glow":   { "pass": "gaussian_blur", "inputs": { "image": "half" } },
        "film":   { "pass": "bloom_combine", "inputs": { "scene": "graded", "bloom": "glow" } },
        "shown":  { "pass": "tone_map", "inputs": { "image": "film" } } },
      "outputs": { )" + std::string(shows_all ? R"("bright": "bright", "half": "half", "glow": "glow", "film": "film", )" : "") +
                    R"("color": "shown" } })");
}

Picture flat(Extent extent, float value)
{
    Picture picture;
    picture.extent = extent;
    picture.channels = 3;
    picture.texels.assign(static_cast<size_t>(extent.width) * static_cast<size_t>(extent.height) * 3, value);
    return picture;
}

/// What is looked for is loaded where the device does that, as the plans of `passgraph` do, or sampled; what is not left out is sampled.
Renderer renderer_of(const Graph& graph, Extent extent, Skipping skipping, bool loads = true)
{
    CompileOptions options{.extent = extent, .picture_extents = {{"photo", extent}}, .skipping = skipping};
    if (loads && skipping == Skipping::as_needed)
        options.device.max_loaded_images = query_device(test_context().loader())->max_loaded_images;
    auto plan = compile(graph, options);
    REQUIRE(plan);
    auto renderer = Renderer::create(std::move(*plan), {.loader = test_context().loader(), .is_timed = true, .is_poisoned = true});
    REQUIRE(renderer);
    return std::move(*renderer);
}

int left_out(Renderer& renderer)
{
    int count = 0;
    for (const StepTime& time : renderer.step_times())
        count += time.was_skipped;
    return count;
}

/// Draws the picture with skipping, by loads and by samples, and without, compares every output's bits, and returns how many steps
/// the device left out.
int compare(const Graph& graph, const Picture& photo)
{
    Renderer loading = renderer_of(graph, photo.extent, Skipping::as_needed);
    Renderer sampling = renderer_of(graph, photo.extent, Skipping::as_needed, false);
    Renderer eager = renderer_of(graph, photo.extent, Skipping::never);
    for (Renderer* renderer : {&loading, &sampling, &eager}) {
        REQUIRE(renderer->import_picture("photo", photo));
        REQUIRE(renderer->render());
        REQUIRE(renderer->render({.redraws = true})); // as the frame before was
    }
    for (const Plan::Output& output : eager.plan().outputs) {
        INFO(output.name);
        const auto expected = eager.read(output.name);
        REQUIRE(expected);
        for (Renderer* lazy : {&loading, &sampling}) {
            const auto found = lazy->read(output.name);
            REQUIRE(found);
            CHECK(found->texels == expected->texels);
        }
    }
    CHECK(left_out(eager) == 0);
    CHECK(left_out(sampling) == left_out(loading));
    return left_out(loading);
}

/// A gray of a radiance that, doubled by `graded`, has the luminance that `bright` sees.
float half_of(float luminance) { return 0.5f * luminance; }

} // namespace

TEST_CASE("where nothing is bright bloom's chain is left out, where one pixel is it is drawn; no bit changes", "[graphs][skipping][bloom]")
{
    for (const bool shows_all : {false, true})
        for (const Extent extent : {Extent{160, 90}, Extent{17, 13}, Extent{9, 1}, Extent{1, 1}}) {
            CAPTURE(shows_all, extent.width, extent.height);
            const Graph graph = stack(shows_all);
            // The half, two blurs, and film without them; of one texel, all but the half and the first blur are one draw.
            CHECK(compare(graph, flat(extent, 0.1f)) == (extent == Extent{1, 1} ? 3 : 4));
            for (const auto& [x, y] : {std::pair{0, 0}, {extent.width - 1, extent.height - 1}, {extent.width / 2, extent.height / 3}}) {
                Picture photo = flat(extent, 0.1f);
                for (int c = 0; c < 3; ++c)
                    photo.at(x, y, c) = 4.0f;
                CHECK(compare(graph, photo) == 0);
            }
        }
}

// The predicate is threshold - knee, to the last bit: between two neighbouring numbers black ends, and skipping with it.
TEST_CASE("a pixel at threshold minus knee is black, one ulp above it is not", "[graphs][skipping][bloom]")
{
    const Extent extent{8, 8};
    for (const auto& [threshold, knee] : {std::pair{"1", "0.5"}, {"0.8", "0.25"}, {"2", "0"}, {"0.5", "0.9"}}) {
        const Graph graph = stack(true, threshold, knee);
        Renderer eager = renderer_of(graph, extent, Skipping::never);
        const auto is_black = [&](float luminance) {
            REQUIRE(eager.import_picture("photo", flat(extent, half_of(luminance))));
            REQUIRE(eager.render());
            const auto bright = eager.read("bright"); // in binary32: not even the smallest light is rounded away
            REQUIRE(bright);
            return std::all_of(bright->texels.begin(), bright->texels.end(), [](float x) { return x == 0.0f; });
        };
        // A gray's luminance is the gray within the two roundings of its sum: black ends within eight numbers of the border.
        float luminance = std::stof(threshold) * (1.0f - std::stof(knee));
        for (int i = 0; i < 8; ++i)
            luminance = std::nextafter(luminance, 0.0f);
        std::vector<bool> were_black;
        for (int i = 0; i < 16; ++i, luminance = std::nextafter(luminance, 9.0f)) {
            CAPTURE(threshold, knee, luminance, i);
            were_black.push_back(is_black(luminance));
            CHECK((compare(graph, flat(extent, half_of(luminance))) > 0) == were_black.back());
            CHECK((i == 0 || were_black.back() <= were_black[were_black.size() - 2]));
        }
        CAPTURE(threshold, knee);
        CHECK(were_black.front());
        CHECK_FALSE(were_black.back());
    }
}

// What a draw reads is what was stored: a light that a half rounds away is black there, and eight times as much is not.
TEST_CASE("each draw goes by what it reads, not by the pass alone", "[graphs][skipping][bloom]")
{
    const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
        "graded": { "pass": "bloom_combine", "inputs": { "scene": "photo", "bloom": "photo" } },
        "bright": { "pass": "bright", "inputs": { "image": "graded" }, "params": { "threshold": 1, "knee": 0.5 } },
        "glow":   { "pass": "gaussian_blur", "inputs": { "image": "bright" } },
        "more":   { "pass": "bloom_combine", "inputs": { "scene": "bright", "bloom": "bright" }, "params": { "strength": 8 } },
        "flare":  { "pass": "gaussian_blur", "inputs": { "image": "more" } } },
      "outputs": { "graded": "graded", "glow": "glow", "flare": "flare" } })");
    const Picture photo = flat({16, 16}, half_of(0.5002f)); // rise^2 / (4 reach) = 2e-8, of which a half keeps nothing
    CHECK(compare(graph, photo) == 2); // the glow's two
    Renderer eager = renderer_of(graph, photo.extent, Skipping::never);
    REQUIRE(eager.import_picture("photo", photo));
    REQUIRE(eager.render());
    CHECK(eager.read("glow")->at(8, 8) == 0.0f);
    CHECK(eager.read("flare")->at(8, 8) > 0.0f);
    CHECK(compare(graph, flat({16, 16}, 0.1f)) == 4);
}

TEST_CASE("a scout misses no texel, however many fall to one of its pixels", "[graphs][skipping][bloom]")
{
    const Extent extent{45, 37};
    for (const bool loads : {false, true})
        for (const bool shows_bright : {false, true})
            for (const char* scale : {"[1, 2]", "[1, 5]", "[1, 16]", "[1, 64]", "[1, 1]"}) {
                const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
                    "graded": { "pass": "bloom_combine", "inputs": { "scene": "photo", "bloom": "photo" } },
                    "bright": { "pass": "bright", "inputs": { "image": "graded" } },
                    "small":  { "pass": "downsample", "inputs": { "image": "bright" }, "scale": )" + std::string(scale) + R"( },
                    "glow":   { "pass": "gaussian_blur", "inputs": { "image": "small" } } },
                  "outputs": { "graded": "graded", "color": "glow")" + (shows_bright ? R"(, "bright": "bright")" : "") + " } }");
                Renderer lazy = renderer_of(graph, extent, Skipping::as_needed, loads);
                Renderer eager = renderer_of(graph, extent, Skipping::never);
                Picture dark = flat(extent, 0.1f);
                for (const auto& [x, y] : {std::pair{0, 0}, {44, 36}, {44, 0}, {0, 36}, {31, 32}, {8, 7}, {7, 8}, {22, 18}}) {
                    CAPTURE(loads, shows_bright, scale, x, y);
                    Picture photo = dark;
                    photo.at(x, y, 1) = 400.0f; // of a thousand others in the mean
                    for (const Picture* picture : {&dark, &dark, &photo, &photo, &dark}) {
                        for (Renderer* renderer : {&lazy, &eager}) {
                            REQUIRE(renderer->import_picture("photo", *picture));
                            REQUIRE(renderer->render());
                        }
                        CHECK(lazy.read("color")->texels == eager.read("color")->texels);
                    }
                    CHECK(left_out(lazy) > 0);
                }
            }
}

TEST_CASE("a called pass that filters finds the texel, one that has levels is sampled", "[graphs][skipping][bloom]")
{
    for (const char* port : {R"("filter": "linear")", R"("levels": true)"}) {
        CAPTURE(port);
        const auto glint = read_pass(R"(/*{ "pass": "glint", "summary": "What is above a half.", "source": "arithmetic",
  "inputs": { "image": { "signal": "radiance", )" + std::string(port) + R"( } }, "outputs": { "color": "radiance" },
  "skip": { "when": "image(uv).r <= 0.5", "value": 0 } }*/
vec3 glint(vec2 uv) { return max(image(uv) - 0.5, vec3(0.0)); }
)",
                                     "glint.glsl", "mine", {});
        REQUIRE(glint);
        PassLibrary library = builtin_passes();
        library.add(*glint);
        const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
            "graded": { "pass": "bloom_combine", "inputs": { "scene": "photo", "bloom": "photo" } },
            "glint": { "pass": "glint", "inputs": { "image": "graded" } },
            "half": { "pass": "downsample", "inputs": { "image": "glint" } },
            "glow": { "pass": "gaussian_blur", "inputs": { "image": "half" } } },
          "outputs": { "graded": "graded", "color": "glow" } })",
                                     library);
        Picture photo = flat({37, 23}, half_of(0.5f)); // a weight that is not quite 1 would find its neighbour's light
        CHECK(compare(graph, photo) >= 2);
        photo.at(18, 11, 0) = 60000.0f;
        CHECK(compare(graph, photo) == 0);
    }
}

// A pass may be black where it is bright: texels that a last block has not got are 0, and no reason to draw.
TEST_CASE("no texel beyond the picture is looked at", "[graphs][skipping][bloom]")
{
    const auto dark = read_pass(R"(/*{ "pass": "dark", "summary": "What is left of a half.", "source": "arithmetic",
  "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "skip": { "when": "image(uv).r >= 0.5", "value": 0 } }*/
vec3 dark(vec2 uv) { return vec3(max(0.5 - image(uv).r, 0.0)); }
)",
                                "dark.glsl", "mine", {});
    REQUIRE(dark);
    PassLibrary library = builtin_passes();
    library.add(*dark);
    const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
        "graded": { "pass": "bloom_combine", "inputs": { "scene": "photo", "bloom": "photo" } },
        "dark": { "pass": "dark", "inputs": { "image": "graded" } },
        "half": { "pass": "downsample", "inputs": { "image": "dark" } },
        "glow": { "pass": "gaussian_blur", "inputs": { "image": "half" } } },
      "outputs": { "graded": "graded", "color": "glow" } })",
                                 library);
    CHECK(compare(graph, flat({17, 13}, half_of(0.75f))) == 3);
    CHECK(compare(graph, flat({17, 13}, half_of(0.25f))) == 0);
}

// Just above threshold - knee and far below the threshold: a predicate that forgot the knee would call it black.
TEST_CASE("inside the knee bloom glows: the predicate is not the threshold", "[graphs][skipping][bloom]")
{
    const Graph graph = stack(true, "1", "0.5");
    Renderer lazy = renderer_of(graph, {8, 8}, Skipping::as_needed);
    REQUIRE(lazy.import_picture("photo", flat({8, 8}, half_of(0.75f))));
    REQUIRE(lazy.render());
    CHECK(left_out(lazy) == 0);
    // rise = 0.25 of a reach of 0.5: 0.25^2 / (4 * 0.5) of light; three stores of 11 bits.
    CHECK(lazy.read("glow")->at(2, 2, 0) == Approx(0.03125 * 1.0).epsilon(4.0 / 2048.0));
    CHECK(compare(graph, flat({8, 8}, half_of(0.75f))) == 0);
}

TEST_CASE("a frame that gets dark, and bright again, is decided anew; a change behind the chain is not", "[graphs][skipping][bloom]")
{
    const Extent extent{32, 18};
    const Graph graph = stack(false);
    Renderer lazy = renderer_of(graph, extent, Skipping::as_needed);
    Renderer eager = renderer_of(graph, extent, Skipping::never);
    std::mt19937 random(11);
    for (int round = 0; round < 40; ++round) {
        if (round == 0 || random() % 3 != 0) {
            Picture photo = flat(extent, 0.1f);
            if (random() % 2 == 0)
                photo.at(static_cast<int>(random() % 32), static_cast<int>(random() % 18), 1) = 5.0f;
            for (Renderer* renderer : {&lazy, &eager})
                REQUIRE(renderer->import_picture("photo", photo));
        }
        const Value exposure(0.5 + 0.001 * static_cast<double>(random() % 1000));
        const Value threshold(0.2 + 0.001 * static_cast<double>(random() % 1000));
        for (Renderer* renderer : {&lazy, &eager}) {
            if (round > 0)
                REQUIRE(renderer->set("shown.exposure", exposure));
            if (round % 4 == 1)
                REQUIRE(renderer->set("bright.threshold", threshold));
            REQUIRE(renderer->render());
        }
        CAPTURE(round);
        CHECK(lazy.read("color")->texels == eager.read("color")->texels);
    }
}

TEST_CASE("a plan handed over with its images knows what was counted", "[graphs][skipping][bloom]")
{
    const Extent extent{32, 18};
    for (const float light : {0.1f, 2.0f}) {
        Renderer renderer = renderer_of(stack(false), extent, Skipping::as_needed);
        REQUIRE(renderer.import_picture("photo", flat(extent, light)));
        REQUIRE(renderer.render());
        Graph other = stack(false);
        REQUIRE(other.set("shown.curve", {"", {}, "table", {}}));
        auto plan = compile(other, {.extent = extent, .picture_extents = {{"photo", extent}}});
        REQUIRE(plan);
        REQUIRE(renderer.replace(std::move(*plan)));
        REQUIRE(renderer.render());
        Renderer fresh = renderer_of(other, extent, Skipping::never);
        REQUIRE(fresh.import_picture("photo", flat(extent, light)));
        REQUIRE(fresh.render());
        CHECK(renderer.read("color")->texels == fresh.read("color")->texels);
    }
}

TEST_CASE("what the host looks at is black in a plan that comes after a dark frame, though nothing was drawn there yet", "[graphs][skipping][bloom]")
{
    const Extent extent{32, 18};
    Renderer renderer = renderer_of(stack(true), extent, Skipping::as_needed);
    for (const float light : {0.1f, 0.2f}) {
        REQUIRE(renderer.import_picture("photo", flat(extent, light)));
        REQUIRE(renderer.render());
    }
    Graph other = stack(true);
    REQUIRE(other.set_codec("glow.blurred", "rgba32f"));
    REQUIRE(other.set_codec("half.color", "rgba32f"));
    auto plan = compile(other, {.extent = extent, .picture_extents = {{"photo", extent}}});
    REQUIRE(plan);
    REQUIRE(renderer.replace(std::move(*plan)));
    REQUIRE(renderer.render());
    for (const char* image : {"bright", "half", "glow"}) {
        INFO(image);
        const auto shown = renderer.read(image);
        REQUIRE(shown);
        CHECK(std::all_of(shown->texels.begin(), shown->texels.end(), [](float x) { return x == 0.0f; }));
    }
}

TEST_CASE("taken to be black, bloom is gone: its chain is no part of the plan", "[graphs][skipping][bloom]")
{
    const Renderer off = renderer_of(stack(false), {8, 8}, Skipping::always);
    CHECK(off.plan().steps.size() == 1);
    const Renderer on = renderer_of(stack(false), {8, 8}, Skipping::never);
    CHECK(on.plan().steps.size() > 4);
    for (const Plan::Step& step : on.plan().steps)
        CHECK(step.skipped_by == -1);
}
