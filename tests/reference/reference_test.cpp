// The references in double against tables of 50 digits, which share no code with them.
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/pass_runner.hpp"
#include "tool/accuracy/reference/reference.hpp"

using namespace passgraph;
using test::read_table;

namespace {

// The tables round their inputs to binary32 and their results to double; a double's own formula magnifies its rounding by
// the condition, 1e6 at most (roughness 0.045): 1e6 * 2^-53 * some tens.
constexpr double kDensity = 1e-8;

} // namespace

TEST_CASE("the density of GGX is the table's, from direction pairs", "[reference]")
{
    const test::Table table = read_table("brdf_vectors.csv");
    const auto column = [&](size_t row, const char* name) { return table.rows[row][table.column(name)]; };
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const double alpha = column(i, "roughness") * column(i, "roughness");
        if (alpha == 0.0)
            continue;
        // The table's directions have length 1 to 2^-24 and are normalised first there too.
        const double v = std::hypot(column(i, "Vx"), column(i, "Vy"), column(i, "Vz"));
        const double l = std::hypot(column(i, "Lx"), column(i, "Ly"), column(i, "Lz"));
        const reference::Vector half{column(i, "Vx") / v + column(i, "Lx") / l, column(i, "Vy") / v + column(i, "Ly") / l,
                                     column(i, "Vz") / v + column(i, "Lz") / l};
        const double expected = column(i, "D_ggx");
        const double got = reference::ggx_density({0.0, 0.0, 1.0}, half, alpha);
        CAPTURE(i, alpha, got, expected);
        CHECK(std::abs(got - expected) <= kDensity * expected);
    }
}

TEST_CASE("the Fresnel edge is the table's", "[reference]")
{
    const test::Table table = read_table("brdf_terms.csv");
    for (const std::vector<double>& row : table.rows) {
        const double f0 = row[table.column("f0")];
        const double expected = row[table.column("F_schlick")];
        const double got = f0 + (1.0 - f0) * reference::schlick_weight(row[table.column("VoH")]);
        if (std::isfinite(expected) && row[table.column("VoH")] <= 1.0)
            CHECK(std::abs(got - expected) <= 1e-14);
    }
    CHECK(reference::schlick_weight(1.0 + 1e-7) == 0.0);
}

TEST_CASE("the filmic curve is the table's, for the constants of Hable's talk", "[reference]")
{
    const test::Table table = read_table("curves.csv");
    int compared = 0;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const double x = table.rows[i][table.column("x")];
        const double expected = table.rows[i][table.column("y")];
        if (table.text[i][table.column("curve")] != "hable_w11.2_exp2" || !(std::abs(x) < 1e30))
            continue;
        // Near black the published form subtracts E / F from as much: 2^-53 of 0.067, over the curve's value at white, 0.49.
        CHECK(std::abs(reference::filmic(2.0 * x, 11.2, {0.15, 0.50, 0.10, 0.20, 0.02, 0.30}) - expected) <= 1e-15);
        ++compared;
    }
    CHECK(compared > 20);
}

TEST_CASE("the sRGB encoding is the table's", "[reference]")
{
    const test::Table table = read_table("curves.csv");
    int compared = 0;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        if (table.text[i][table.column("curve")] != "srgb_encode_clamped")
            continue;
        CHECK(std::abs(reference::srgb_encode(table.rows[i][table.column("x")]) - table.rows[i][table.column("y")]) <= 4e-16);
        ++compared;
    }
    CHECK(compared > 20);
}

TEST_CASE("an angle is exact where acos of a dot product has no digits left", "[reference]")
{
    const double tiny = 1e-9;
    CHECK(reference::angle_degrees({0.0, 0.0, 2.0}, {std::sin(tiny), 0.0, std::cos(tiny)}) == Approx(tiny * 180.0 / std::numbers::pi).epsilon(1e-12));
    CHECK(reference::angle_degrees({1.0, 0.0, 0.0}, {0.0, 3.0, 0.0}) == Approx(90.0).epsilon(1e-15));
    CHECK(reference::angle_degrees({1.0, 0.0, 0.0}, {-5.0, 0.0, 0.0}) == Approx(180.0).epsilon(1e-15));
    CHECK(reference::angle_degrees({0.3, 0.4, 0.5}, {0.6, 0.8, 1.0}) == 0.0);
}

TEST_CASE("a pixel's place lies on its ray, at its distance", "[reference]")
{
    const double right_angle = std::numbers::pi / 2.0; // the picture is twice as high as the distance
    const reference::Vector corner = reference::place_at_distance(-0.5, 7.5, 16, 8, right_angle, 10.0);
    CHECK(corner[0] == Approx(-20.0).epsilon(1e-15));
    CHECK(corner[1] == Approx(10.0).epsilon(1e-15));
    CHECK(corner[2] == -10.0);
    const reference::Vector middle = reference::place_at_distance(7.5, 3.5, 16, 8, right_angle, 3.0);
    CHECK(middle == reference::Vector{0.0, 0.0, -3.0});
}

TEST_CASE("the share of Beckmann's facets that is seen is the table's", "[reference]")
{
    const test::Table table = read_table("brdf_terms.csv");
    int compared = 0;
    for (const std::vector<double>& row : table.rows) {
        const auto value = [&](const char* name) { return row[table.column(name)]; };
        const double alpha = value("roughness") * value("roughness");
        if (!(alpha > 0.0) || !(value("NoL") > 0.0) || !(value("NoV") > 0.0) || !(value("NoL") <= 1.0) || !(value("NoV") <= 1.0))
            continue;
        // erfc and the exponential cancel: 2^-53 of terms of up to 1 / cosine stays.
        const double both = reference::beckmann_seen(value("NoL"), alpha) * reference::beckmann_seen(value("NoV"), alpha);
        CHECK(both == Approx(value("G_smith_sep_beck")).epsilon(1e-10).margin(1e-14));
        ++compared;
    }
    CHECK(compared > 50);
}
