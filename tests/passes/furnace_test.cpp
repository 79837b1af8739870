// White furnace: under light of 1 from everywhere, no surface sends back more than 1.
#include <cmath>
#include <numbers>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

namespace {

struct Matter {
    float specular = 0.5f;
    float roughness = 0.5f;
    float metallic = 0.0f;
    float albedo = 1.0f;
};

/// The share of uniform light that a surface sends towards a viewer at `n_dot_v`.
///
/// Midpoint sums over the polar angle, and over half the azimuths, the other half being their mirror image. In double.
double albedo_of(const Matter& matter, double n_dot_v)
{
    constexpr int kRings = 96;
    constexpr int kSectors = 160;
    const float vx = static_cast<float>(std::sqrt(1.0 - n_dot_v * n_dot_v));
    std::vector<std::vector<float>> rows;
    for (int ring = 0; ring < kRings; ++ring) {
        const double theta = 0.5 * std::numbers::pi * (ring + 0.5) / kRings;
        const double z = std::cos(theta);
        const double r = std::sin(theta);
        for (int sector = 0; sector < kSectors; ++sector) {
            const double phi = std::numbers::pi * (sector + 0.5) / kSectors;
            rows.push_back({vx, static_cast<float>(n_dot_v), static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)),
                            static_cast<float>(z), matter.specular, matter.roughness, matter.metallic, matter.albedo});
        }
    }
    const auto got = evaluate("reflected(make_surface(vec3(albedo), vec3(specular, roughness, metallic), vz), vec3(0.0, 0.0, 1.0), "
                              "vec3(vx, 0.0, vz), vec3(lx, ly, lz)).x",
                              {"brdf.glsl"}, {"vx", "vz", "lx", "ly", "lz", "specular", "roughness", "metallic", "albedo"}, rows);
    double sum = 0.0;
    for (size_t i = 0; i < rows.size(); ++i)
        sum += got[i][0] * std::hypot(rows[i][2], rows[i][3]); // sin theta
    return sum * std::numbers::pi * std::numbers::pi / (kRings * kSectors);
}

} // namespace

TEST_CASE("a white metal sends back what the quadrature table says, and never more than all", "[passes][brdf]")
{
    const Table table = read_table("furnace_albedo.csv");
    int compared = 0;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const double roughness = table.rows[i][table.column("roughness")];
        const double n_dot_v = table.rows[i][table.column("NoV")];
        // Beyond these the lobe is narrower than our rings and sectors, and the sum is no longer an integral.
        if (table.text[i][table.column("D")] != "ggx" || roughness < 0.35 || n_dot_v < 0.1)
            continue;
        const double got = albedo_of({.roughness = static_cast<float>(roughness), .metallic = 1.0f}, n_dot_v);
        CAPTURE(roughness, n_dot_v);
        CHECK(got <= 1.001);
        // Midpoint error of the sum; 1e-3 is what the table itself allows for sampling.
        CHECK(got == Approx(table.rows[i][table.column("E_smith_corr")]).margin(1e-3));
        ++compared;
    }
    CHECK(compared >= 10);
}

TEST_CASE("diffuse and specular light together are never more than what arrives", "[passes][brdf]")
{
    for (const float roughness : {0.3f, 0.6f, 1.0f}) {
        for (const double n_dot_v : {0.02, 0.1, 0.3, 0.6, 1.0}) {
            for (const float specular : {0.0f, 0.5f, 1.0f}) {
                for (const float metallic : {0.0f, 0.5f}) {
                    const double got = albedo_of({.specular = specular, .roughness = roughness, .metallic = metallic}, n_dot_v);
                    CAPTURE(roughness, n_dot_v, specular, metallic, got);
                    CHECK(got <= 1.001);
                    CHECK(got > 0.0);
                }
            }
        }
    }
}

TEST_CASE("a black dielectric that reflects nothing at normal incidence is nearly black", "[passes][brdf]")
{
    // What is left is Schlick's edge, 1/21 of a cosine-weighted hemisphere at most.
    CHECK(albedo_of({.specular = 0.0f, .roughness = 1.0f, .albedo = 0.0f}, 1.0) < 1.0 / 21.0);
}
