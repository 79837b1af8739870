// Defects 5, 8 and 9 of the original: the blur that brightens, pixelation, night vision.
#include <algorithm>
#include <cmath>

#include "defects/defect_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// One bright texel in the middle of black.
Picture spark(Extent extent)
{
    Picture picture = constant(extent, {0, 0, 0});
    for (int c = 0; c < 3; ++c)
        picture.at(extent.width / 2, extent.height / 2, c) = 1.0f;
    return picture;
}

double sum_of(const Picture& picture)
{
    double sum = 0.0;
    for (const float value : picture.texels)
        sum += static_cast<double>(value);
    return sum / picture.channels;
}

/// Blurred in one direction: by us with a rung, or by the original.
Picture blurred(const std::string& pass, const Picture& image, const std::string& taps)
{
    PassRun run{.pass = pass, .inputs = {{"image", image}}, .folders = {original_folder()}};
    if (pass == "blur_direction")
        run.settings = {{"taps", taps}};
    return run_for_output(run);
}

/// Squares of 8 texels, black and white.
Picture checkered(Extent extent)
{
    Picture picture(extent, 3);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            for (int c = 0; c < 3; ++c)
                picture.at(x, y, c) = static_cast<float>((x / 8 + y / 8) % 2);
    return picture;
}

/// Each cell's texels differ from both neighbours': how wide and high is the cell at the picture's middle?
Extent cell_at_middle(const Picture& picture)
{
    const auto [width, height] = picture.extent;
    const float here = picture.at(width / 2, height / 2);
    const auto run = [&](int dx, int dy) {
        int length = 1;
        for (const int sign : {-1, 1})
            for (int i = 1; picture.at(width / 2 + sign * i * dx, height / 2 + sign * i * dy) == here; ++i)
                ++length;
        return length;
    };
    return {run(1, 0), run(0, 1)};
}

} // namespace

TEST_CASE("defect 5: a blur keeps a constant and the light of a spark", "[defects]")
{
    const Picture even = constant({33, 5}, {0.5f, 0.5f, 0.5f});
    const Picture point = spark({33, 33});
    for (const char* taps : {"5", "9", "13", "25", "learnopengl5"}) {
        INFO(taps);
        // 25 products, sums and one quotient, each rounded once.
        CHECK(blurred("blur_direction", even, taps).at(16, 2) == Approx(0.5).epsilon(28 * 0x1p-24));
        CHECK(sum_of(blurred("blur_direction", point, taps)) == Approx(1.0).epsilon(28 * 0x1p-24));
    }
    // The original's weights with the center twice: 2 * 0.227027 + 2 * (0.1945946 + 0.1216216 + 0.054054 + 0.016216).
    CHECK(blurred("original_blur", even, "").at(16, 2) == Approx(0.5 * 1.2270264).epsilon(1e-5));
    CHECK(sum_of(blurred("original_blur", point, "")) == Approx(1.2270264).epsilon(1e-5));
}

TEST_CASE("defect 8: cells are square whatever the picture's shape", "[defects]")
{
    for (const Extent extent : {Extent{256, 64}, Extent{64, 256}, Extent{128, 72}}) {
        INFO(extent.width << " x " << extent.height);
        const Picture noisy = noise(extent, 3, 0.0f, 1.0f, 5);
        const PassRun ours{.pass = "pixelate", .inputs = {{"image", noisy}}, .settings = {{"cell", "8"}}};
        CHECK(cell_at_middle(run_for_output(ours)) == Extent{8, 8});
    }
    const PassRun theirs{.pass = "original_pixelate", .inputs = {{"image", noise({800, 200}, 3, 0.0f, 1.0f, 5)}},
                         .folders = {original_folder()}};
    CHECK(cell_at_middle(run_for_output(theirs)) == Extent{8, 2});
}

TEST_CASE("defect 8: a cell has the color of its own middle, not one mixed with its neighbours'", "[defects]")
{
    const Picture squares = checkered({800, 800});
    const auto mixed = [](const Picture& p) {
        return std::count_if(p.texels.begin(), p.texels.end(), [](float v) { return v != 0.0f && v != 1.0f; });
    };
    const Picture ours = run_for_output({.pass = "pixelate", .inputs = {{"image", squares}}, .settings = {{"cell", "8"}}});
    CHECK(largest_difference(ours, squares) == 0.0f);
    const Picture theirs =
        run_for_output({.pass = "original_pixelate", .inputs = {{"image", squares}}, .folders = {original_folder()}});
    CHECK(mixed(theirs) > 400000); // read at the corners of its 8 x 8 cells, where four squares meet
}

TEST_CASE("defect 9: night vision and its rim take light away, never more than there is, and keep the hue", "[defects]")
{
    const Picture grey = constant({64, 36}, {0.5f, 0.5f, 0.5f});
    const Picture green = run_for_output({.pass = "night_vision", .inputs = {{"image", grey}}});
    const Picture ours = run_for_output({.pass = "vignette", .inputs = {{"image", green}}, .generic = Signal::display});
    const Picture theirs =
        run_for_output({.pass = "original_night_vision", .inputs = {{"image", grey}}, .folders = {original_folder()}});
    // The tint's ratio of red to green holds wherever anything is left; a difference does not keep it.
    const auto keeps_hue = [](const Picture& p) {
        for (size_t i = 0; i < p.texels.size(); i += 3)
            if (std::abs(p.texels[i] * 0.79f - p.texels[i + 1] * 0.40f) > 4 * 0x1p-24f)
                return false;
        return true;
    };
    CHECK(keeps_hue(green));
    CHECK(keeps_hue(ours));
    CHECK_FALSE(keeps_hue(theirs));
    for (const float value : ours.texels)
        CHECK(value >= 0.0f);
    // Near the corner, at radius 0.82 of 0.5 to 0.9, a tenth of the light is left of ours; of the original's nothing.
    CHECK(ours.at(60, 31, 1) > 0.0f);
    CHECK(theirs.at(60, 31, 1) == 0.0f);
}

TEST_CASE("defect 9: alpha is no color and stays as it is", "[defects]")
{
    const Graph graph = graph_of(R"({
      "passgraph": 1, "inputs": { "picture": "display_alpha" },
      "passes": { "rim": { "pass": "vignette", "inputs": { "image": "picture" }, "codecs": { "color": "rgba32f" } } },
      "outputs": { "color": "rim" } })", with_original());
    GraphRun run;
    run.options.extent = {9, 5};
    run.pictures = {{"picture", constant({9, 5}, {0.25f, 0.25f, 0.25f, 0.5f})}};
    const Picture rim = run_graph(graph, run).at("color");
    CHECK(rim.at(0, 0, 0) < 0.1f * 0.25f);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 9; ++x)
            CHECK(rim.at(x, y, 3) == 0.5f);
}
