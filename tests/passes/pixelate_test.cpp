// Pixelation: square cells of one color, partial ones at the top and the right.
#include <cmath>
#include <string>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture in_cells(const Picture& image, const std::string& cell)
{
    return run_for_output({.pass = "pixelate", .inputs = {{"image", image}}, .settings = {{"cell", cell}}});
}

/// x + 1000 y, over 8: below radiance's largest value, and exact in binary32 with its means of two and four.
Picture slope(Extent extent)
{
    Picture image(extent, 3);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            image.at(x, y, 0) = static_cast<float>(x + 1000 * y) / 8.0f;
    return image;
}

/// The middle of the cell that a texel lies in, in texels.
double middle(int texel, double cell, int size)
{
    const double low = std::floor((texel + 0.5) / cell) * cell;
    return 0.5 * (low + std::min(low + cell, double(size)));
}

} // namespace

TEST_CASE("the last, partial cell shows its own mean", "[passes][pixelate]")
{
    const Table table = read_table("pixelate_cells.csv");
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const auto value = [&](const char* column) { return table.rows[i][table.column(column)]; };
        const Extent extent{static_cast<int>(value("w")), static_cast<int>(value("h"))};
        if (value("cell") > 512.0)
            continue; // beyond the parameter's range
        const Picture got = in_cells(slope(extent), table.text[i][table.column("cell")]);
        CAPTURE(extent.width, extent.height, value("cell"));
        // Four exact values, their sum exact, a quarter of it exact: no rounding anywhere.
        CHECK(got.at(extent.width - 1, extent.height - 1, 0) == value("last_cell_mean_of_x_plus_1000y") / 8.0);
    }
}

TEST_CASE("cells are square, of one color, and show the picture at their middle", "[passes][pixelate][defect 8]")
{
    unsigned seed = 80;
    for (const Extent extent : {Extent{1, 1}, Extent{1, 9}, Extent{9, 1}, Extent{17, 13}, Extent{100, 75}}) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
        for (const int cell : {2, 3, 8, 64}) {
            CAPTURE(extent.width, extent.height, cell);
            const Picture got = in_cells(image, std::to_string(cell));
            const auto expected = [&](int x, int y, int c) {
                return bilinear(image, middle(x, cell, extent.width), middle(y, cell, extent.height), c);
            };
            require_texels(got, expected, 3.0 * kRounding * 4.0); // three sums of values up to 4
            require_texels(got, [&](int x, int y, int c) { return got.at(x - x % cell, y - y % cell, c); }, 0.0);
        }
    }
}

TEST_CASE("cells of a fractional size are of one color too", "[passes][pixelate]")
{
    const Picture got = in_cells(noise({17, 13}, 3, 0.0f, 4.0f, 85), "2.5");
    const auto first = [](int texel) { return static_cast<int>(std::ceil(std::floor((texel + 0.5) / 2.5) * 2.5 - 0.5)); };
    require_texels(got, [&](int x, int y, int c) { return got.at(first(x), first(y), c); }, 0.0);
}

TEST_CASE("cells of one texel change no bit", "[passes][pixelate][identity]")
{
    for (const Extent extent : {Extent{1, 1}, Extent{17, 13}, Extent{641, 359}}) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, 86);
        require_same(in_cells(image, "1"), image);
        // One more unit in the last place: the pass runs, as it does when a live parameter arrives at 1.
        require_same(in_cells(image, "1.0000001"), image);
    }
}

TEST_CASE("a constant picture has no cells", "[passes][pixelate][identity]")
{
    const Picture grey = constant({17, 13}, {0.75f, 1.5f, 3.0f});
    require_same(in_cells(grey, "5"), grey);
}
