// The split-sum table against the integral it stands for, as lighting reads it, and the level of the sky it is read from.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr double kTexels = 64.0;

/// The table, stored in binary32, and read between texels as the lighting pass reads it.
struct SplitSum {
    Picture table;

    double at(double n_dot_v, double roughness, int channel) const
    {
        return bilinear(table, std::sqrt(n_dot_v) * (kTexels - 1.0) + 0.5, roughness * (kTexels - 1.0) + 0.5, channel);
    }
};

SplitSum split_sum(const std::vector<std::pair<std::string, std::string>>& settings = {})
{
    return {run_for_output({.pass = "split_sum", .settings = settings, .extent = {8, 8}})};
}

constexpr std::array<std::pair<const char*, const char*>, 5> kGeometries = {{{"smith_correlated", "E_smith_corr"},
                                                                             {"smith_separable", "E_smith_sep"},
                                                                             {"cook_torrance", "E_cooktorrance"},
                                                                             {"neumann", "E_neumann"},
                                                                             {"implicit", "E_implicit"}}};

} // namespace

TEST_CASE("the split-sum table is the quadrature's, read between its texels", "[passes][environment]")
{
    const Table table = read_table("dfg_ggx_corr.csv");
    const SplitSum got = split_sum();
    CHECK(got.table.extent == Extent{64, 64});
    for (const auto& row : table.rows) {
        const double roughness = row[table.column("roughness")];
        const double n_dot_v = row[table.column("NoV")];
        // The sum's own error is 3e-4; between texels the table is straight, which below n.v 0.04 is up to 7e-3 off.
        const double allowed = n_dot_v >= 0.04 ? 1e-3 : 4e-3;
        CAPTURE(roughness, n_dot_v);
        CHECK(got.at(n_dot_v, roughness, 0) == Approx(row[table.column("scale_A")]).margin(allowed));
        CHECK(got.at(n_dot_v, roughness, 1) == Approx(row[table.column("bias_B")]).margin(allowed));
    }
}

TEST_CASE("the split-sum table sums to the white furnace's albedo, for every distribution and geometry", "[passes][environment]")
{
    const Table table = read_table("furnace_albedo.csv");
    for (const char* distribution : {"ggx", "beckmann"}) {
        for (const auto& [geometry, column] : kGeometries) {
            const SplitSum got = split_sum({{"distribution", distribution}, {"geometry", geometry}});
            // Cook and Torrance's minimum has kinks, of which 16 azimuths see too little where the lobe is widest.
            const double sum_error = std::string(geometry) == "cook_torrance" ? 4e-3 : 1e-3;
            for (size_t i = 0; i < table.rows.size(); ++i) {
                const double n_dot_v = table.rows[i][table.column("NoV")];
                const double roughness = table.rows[i][table.column("roughness")];
                if (table.text[i][0] != distribution)
                    continue;
                const double albedo = got.at(n_dot_v, roughness, 0) + got.at(n_dot_v, roughness, 1);
                CAPTURE(distribution, geometry, roughness, n_dot_v);
                CHECK(albedo <= 1.001);
                CHECK(albedo == Approx(table.rows[i][table.column(column)]).margin(n_dot_v >= 0.04 ? sum_error : 6e-3));
            }
        }
    }
}

TEST_CASE("no texel of the split-sum table is negative or gives more than there is", "[passes][environment]")
{
    for (const auto& [geometry, column] : kGeometries) {
        const Picture table = split_sum({{"geometry", geometry}}).table;
        for (int y = 0; y < table.extent.height; ++y)
            for (int x = 0; x < table.extent.width; ++x) {
                CHECK(table.at(x, y, 0) >= 0.0f);
                CHECK(table.at(x, y, 1) >= 0.0f);
                CHECK(table.at(x, y, 0) + table.at(x, y, 1) <= 1.001f);
            }
    }
}

TEST_CASE("a place of the table is the surface whose place it is", "[passes][environment]")
{
    std::vector<std::vector<float>> rows;
    for (int v = 1; v <= 20; ++v)
        for (int r = 1; r <= 20; ++r)
            rows.push_back({static_cast<float>(v) / 20.0f, static_cast<float>(r) / 20.0f});
    const auto got = evaluate("reflectance_surface(reflectance_place(n_dot_v, roughness, vec2(64.0)), vec2(64.0))", {"environment.glsl"},
                              {"n_dot_v", "roughness"}, rows);
    for (size_t i = 0; i < rows.size(); ++i)
        for (size_t c = 0; c < 2; ++c) // uv near 1 is rounded to 2^-24, which 64 texels do not magnify; n.v is squared
            CHECK(got[i][c] == Approx(rows[i][c]).margin(8.0 * kRounding));
}

TEST_CASE("a rougher surface reads a rougher level of the sky, from the first to the last", "[passes][environment]")
{
    std::vector<std::vector<float>> rows;
    for (int i = 0; i <= 100; ++i)
        rows.push_back({static_cast<float>(i) / 100.0f, 7.0f});
    const auto got = evaluate("environment_lod(roughness, top)", {"environment.glsl"}, {"roughness", "top"}, rows);
    int between = 0;
    for (size_t i = 1; i < got.size(); ++i) {
        CHECK(got[i][0] >= got[i - 1][0]);
        CHECK(got[i][0] - got[i - 1][0] <= 6.01f * 0.07f); // no jump: six times as steep as the roughness
        CHECK(std::abs(got[i][0] - 7.0f * rows[i][0]) <= 0.42f);
        between += got[i][0] != std::floor(got[i][0]);
    }
    CHECK(between < 25); // most read one level
    CHECK(got.front()[0] == 0.0f);
    CHECK(got.back()[0] == 7.0f);
    CHECK(evaluate("environment_lod(roughness, top)", {"environment.glsl"}, {"roughness", "top"}, {{1.0f, 0.0f}, {NAN, 7.0f}}) ==
          std::vector<std::vector<float>>{{0.0f}, {0.0f}});
}
