// White furnace: under light of 1 from everywhere, no surface sends back more than 1, whichever models light it.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

namespace {

/// A surface of a material, seen from an angle.
struct Seen {
    double n_dot_v = 1.0;
    float specular = 0.5f;
    float roughness = 0.5f;
    float metallic = 0.0f;
    float albedo = 1.0f;
};

struct Directions {
    int rings = 0;
    int sectors = 0;
};

/// The share of uniform light that each surface sends towards its viewer.
///
/// Midpoint sums over the polar angle, and over half the azimuths, the other half being their mirror image. In double.
std::vector<double> albedos_of(const std::vector<Seen>& surfaces, const std::string& terms, Directions grid)
{
    std::vector<std::vector<float>> rows;
    for (const Seen& seen : surfaces) {
        const float vx = static_cast<float>(std::sqrt(1.0 - seen.n_dot_v * seen.n_dot_v));
        for (int ring = 0; ring < grid.rings; ++ring) {
            const double theta = 0.5 * std::numbers::pi * (ring + 0.5) / grid.rings;
            for (int sector = 0; sector < grid.sectors; ++sector) {
                const double phi = std::numbers::pi * (sector + 0.5) / grid.sectors;
                rows.push_back({vx, static_cast<float>(seen.n_dot_v), static_cast<float>(std::sin(theta) * std::cos(phi)),
                                static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)), seen.specular,
                                seen.roughness, seen.metallic, seen.albedo});
            }
        }
    }
    const auto got = evaluate("reflected(make_surface(vec3(albedo), vec3(specular, roughness, metallic), vz, " + terms +
                                  "), vec3(0.0, 0.0, 1.0), vec3(vx, 0.0, vz), vec3(lx, ly, lz), " + terms + ").x",
                              {"brdf.glsl"}, {"vx", "vz", "lx", "ly", "lz", "specular", "roughness", "metallic", "albedo"}, rows);
    const size_t directions = static_cast<size_t>(grid.rings) * static_cast<size_t>(grid.sectors);
    std::vector<double> sums(surfaces.size());
    size_t bad = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        bad += !std::isfinite(got[i][0]) || got[i][0] < 0.0f;
        sums[i / directions] += got[i][0] * std::hypot(rows[i][2], rows[i][3]); // sin theta
    }
    CHECK(bad == 0);
    for (double& sum : sums)
        sum *= std::numbers::pi * std::numbers::pi / static_cast<double>(directions);
    return sums;
}

std::string terms_of(int distribution, int fresnel, int geometry)
{
    return fmt::format("Terms({}, {}, {}, 2, 1, 1)", distribution, fresnel, geometry);
}

constexpr const char* kColumns[] = {"E_smith_corr", "E_smith_sep", "E_cooktorrance", "E_neumann", "E_implicit"};

} // namespace

TEST_CASE("a white metal sends back what the quadrature table says, and never more than all", "[passes][brdf][furnace]")
{
    const Table table = read_table("furnace_albedo.csv");
    for (int distribution = 0; distribution < 2; ++distribution) {
        std::vector<Seen> surfaces;
        std::vector<size_t> rows;
        for (size_t i = 0; i < table.rows.size(); ++i) {
            const double roughness = table.rows[i][table.column("roughness")];
            const double n_dot_v = table.rows[i][table.column("NoV")];
            // Beyond these the lobe is narrower than our rings and sectors, and the sum is no longer an integral.
            if ((table.text[i][table.column("D")] == "ggx") != (distribution == 0) || roughness < 0.39 || n_dot_v < 0.1)
                continue;
            surfaces.push_back({.n_dot_v = n_dot_v, .roughness = static_cast<float>(roughness), .metallic = 1.0f});
            rows.push_back(i);
        }
        REQUIRE(surfaces.size() >= 10);
        for (int geometry = 0; geometry < 5; ++geometry) {
            const auto got = albedos_of(surfaces, terms_of(distribution, 0, geometry), {128, 192});
            for (size_t i = 0; i < got.size(); ++i) {
                CAPTURE(distribution, kColumns[geometry], surfaces[i].roughness, surfaces[i].n_dot_v);
                CHECK(got[i] <= 1.001);
                // Midpoint error of the sum; 1e-3 is what the table itself allows for sampling.
                CHECK(got[i] == Approx(table.rows[rows[i]][table.column(kColumns[geometry])]).margin(1e-3));
            }
        }
    }
}

TEST_CASE("diffuse and specular light together are never more than what arrives, for any models", "[passes][brdf][furnace]")
{
    std::vector<Seen> surfaces;
    for (const float roughness : {0.4f, 0.6f, 1.0f}) // a smoother lobe is narrower than the sum's directions
        for (const double n_dot_v : {0.02, 0.2, 0.6, 1.0})
            for (const float specular : {0.0f, 0.5f, 1.0f})
                for (const float metallic : {0.0f, 0.5f})
                    surfaces.push_back({.n_dot_v = n_dot_v, .specular = specular, .roughness = roughness, .metallic = metallic});
    for (int distribution = 0; distribution < 2; ++distribution)
        for (int fresnel = 0; fresnel < 2; ++fresnel)
            for (int geometry = 0; geometry < 5; ++geometry) {
                const auto got = albedos_of(surfaces, terms_of(distribution, fresnel, geometry), {64, 64});
                for (size_t i = 0; i < got.size(); ++i) {
                    const Seen& seen = surfaces[i];
                    CAPTURE(distribution, fresnel, geometry, seen.roughness, seen.n_dot_v, seen.specular, seen.metallic, got[i]);
                    CHECK(got[i] <= 1.001);
                    CHECK(got[i] > 0.0);
                }
            }
}

TEST_CASE("a black dielectric that reflects nothing at normal incidence is nearly black", "[passes][brdf][furnace]")
{
    // What is left is Schlick's edge, 1/21 of a cosine-weighted hemisphere at most.
    const Seen black = {.specular = 0.0f, .roughness = 1.0f, .albedo = 0.0f};
    CHECK(albedos_of({black}, terms_of(0, 0, 0), {48, 64})[0] < 1.0 / 21.0);
    // An index of 1 is no boundary at all.
    CHECK(albedos_of({black}, terms_of(0, 1, 0), {48, 64})[0] == 0.0);
}
