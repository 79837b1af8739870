// Night vision: a tint, by an amount, that never leaves the display's range.
#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture seen(const Picture& image, const std::string& amount, const std::string& tint = "0.40,0.79,0.11")
{
    return run_for_output({.pass = "night_vision", .inputs = {{"image", image}}, .settings = {{"amount", amount}, {"tint", tint}}});
}

} // namespace

TEST_CASE("night vision multiplies by its tint, as far as its amount", "[passes][night_vision]")
{
    constexpr double kTint[] = {0.40, 0.79, 0.11};
    unsigned seed = 90;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 1.0f, seed++);
        for (const double amount : {1.0, 0.3}) {
            const auto expected = [&](int x, int y, int c) { return image.at(x, y, c) * (1.0 - amount * (1.0 - kTint[c])); };
            // The tint's and amount's own roundings, three products and a sum of values up to 1.
            require_texels(seen(image, amount == 1.0 ? "1" : "0.3"), expected, 6.0 * kRounding);
        }
    }
}

TEST_CASE("night vision of amount 0 is its input", "[passes][night_vision][identity]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 1.0f, 95);
    require_same(seen(image, "0"), image);
}

TEST_CASE("night vision with a white tint is its input", "[passes][night_vision][identity]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 1.0f, 96);
    require_same(seen(image, "1", "1,1,1"), image);
}

TEST_CASE("the darkest picture stays in range, where the original subtracts below 0", "[passes][night_vision][defect 9]")
{
    const Picture black = constant({17, 13}, {0.0f, 0.0f, 0.0f});
    require_same(seen(black, "1"), black);
    const Picture got = seen(noise({17, 13}, 3, 0.0f, 0.01f, 97), "1");
    require_texels(got, [](int, int, int) { return 0.005; }, 0.005);
}
