// The lobe against other people's code: Mitsuba 3.9's `roughconductor`, F = 1, separable Smith.
#include <cmath>
#include <string>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

TEST_CASE("a perfect mirror's rough lobe is Mitsuba's, GGX and Beckmann", "[passes][brdf][terms]")
{
    const Table table = read_table("mitsuba_roughconductor.csv");
    const std::vector<std::string> columns = {"roughness", "Vx", "Vy", "Vz", "Lx", "Ly", "Lz"};
    for (const bool is_beckmann : {false, true}) {
        std::vector<std::vector<float>> rows;
        std::vector<double> expected;
        for (size_t i = 0; i < table.rows.size(); ++i) {
            if ((table.text[i][0] == "beckmann") != is_beckmann)
                continue;
            rows.emplace_back();
            for (const std::string& column : columns)
                rows.back().push_back(static_cast<float>(table.rows[i][table.column(column)]));
            expected.push_back(table.rows[i][table.column("f_times_NoL")]);
        }
        REQUIRE(rows.size() > 20);
        const std::string terms = is_beckmann ? "Terms(1, 0, 1, 2, 1, 0)" : "Terms(0, 0, 1, 2, 1, 1)";
        const auto got = evaluate("reflected(make_surface(vec3(1.0), vec3(0.0, roughness, 1.0), Vz, " + terms + "), "
                                  "vec3(0.0, 0.0, 1.0), vec3(Vx, Vy, Vz), vec3(Lx, Ly, Lz), " + terms + ").x",
                                  {"brdf.glsl"}, columns, rows);
        for (size_t i = 0; i < got.size(); ++i) {
            CAPTURE(is_beckmann, i, rows[i][0], got[i][0], expected[i]);
            // 2e-5 is the table's, whose own arithmetic is binary32. Exponents of up to 46 magnify their 16 roundings; below 1e-20
            // Mitsuba calls D 0.
            CHECK(std::abs(got[i][0] - expected[i]) <= (is_beckmann ? 2e-5 + 46.0 * 16.0 * kRounding : 2e-5) * expected[i] + 1e-19);
        }
    }
}
