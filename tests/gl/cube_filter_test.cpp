// Prefiltering of skies: constants stay, energy stays, edges do not show, and irradiance is the cosine's convolution.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gl/cube_filter.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::gl;

namespace {

constexpr double kPi = 3.14159265358979324;

CubeFaces constant_cube(int size, glm::vec3 value)
{
    Picture face({size, size}, 4);
    for (size_t i = 0; i < face.texels.size(); ++i)
        face.texels[i] = i % 4 == 3 ? 1.0f : value[static_cast<int>(i % 4)];
    CubeFaces faces;
    faces.fill(face);
    return faces;
}

/// A face's direction at a texel's center; +X -X +Y -Y +Z -Z as the OpenGL specification has them.
glm::dvec3 direction(int face, int x, int y, int size)
{
    const double s = (2.0 * x + 1.0) / size - 1.0;
    const double t = (2.0 * y + 1.0) / size - 1.0;
    const glm::dvec3 all[] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return glm::normalize(all[face]);
}

template <class Radiance>
CubeFaces cube_of(int size, const Radiance& radiance)
{
    CubeFaces faces = constant_cube(size, glm::vec3(0.0f));
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (int c = 0; c < 3; ++c)
                    faces[static_cast<size_t>(face)].at(x, y, c) = static_cast<float>(radiance(direction(face, x, y, size)));
    return faces;
}

/// What the generated GLSL does with the coefficients.
glm::dvec3 irradiance(const Harmonics& c, glm::dvec3 d)
{
    const double basis[] = {1.0, d.y, d.z, d.x, d.x * d.y, d.y * d.z, d.z * d.z, d.x * d.z, d.x * d.x - d.y * d.y};
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < c.size(); ++i)
        sum += glm::dvec3(c[i]) * basis[i];
    return sum;
}

/// The cosine's convolution, by brute force over a cube's texels.
double convolved(const CubeFaces& faces, glm::dvec3 n)
{
    const int size = faces[0].extent.width;
    double sum = 0.0, total = 0.0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 d = direction(face, x, y, size);
                const double nearest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
                const double angle = nearest * nearest * nearest;
                sum += angle * std::max(glm::dot(n, d), 0.0) * faces[static_cast<size_t>(face)].at(x, y, 0);
                total += angle;
            }
    return sum * 4.0 * kPi / total;
}

const glm::dvec3 kNormals[] = {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0.57735, 0.57735, 0.57735}, {-0.6, 0.8, 0}, {0.36, -0.48, -0.8}};

} // namespace

TEST_CASE("a sky of one color is that color at every level of roughness", "[gl][sky]")
{
    for (const int size : {1, 2, 3, 4, 7, 16, 32, 100}) {
        const CubeFaces faces = constant_cube(size, {0.1f, 1.0f, 60000.0f});
        const auto levels = prefiltered(faces);
        CHECK(static_cast<int>(levels.size()) == prefiltered_levels(size) - 1);
        for (const CubeFaces& level : levels)
            for (const Picture& face : level)
                for (int y = 0; y < face.extent.height; ++y)
                    for (int x = 0; x < face.extent.width; ++x)
                        for (int c = 0; c < 3; ++c) // 192 samples' shares sum to 1 within as many roundings
                            REQUIRE(std::abs(face.at(x, y, c) - faces[0].at(0, 0, c)) <= 200.0 / 16777216.0 * faces[0].at(0, 0, c));
    }
}

TEST_CASE("a prefiltered sky has a level per roughness, down to faces of 4 texels", "[gl][sky]")
{
    CHECK(prefiltered_levels(1) == 1);
    CHECK(prefiltered_levels(2) == 2);
    CHECK(prefiltered_levels(4) == 3);
    CHECK(prefiltered_levels(8) == 4);
    CHECK(prefiltered_levels(32) == 4);
    CHECK(prefiltered_levels(512) == 8);
    CHECK(prefiltered_levels(1000) == 8);
    const auto levels = prefiltered(constant_cube(64, glm::vec3(1.0f)));
    REQUIRE(levels.size() == 4);
    CHECK(levels.front()[0].extent == Extent{32, 32});
    CHECK(levels.back()[5].extent == Extent{4, 4});
}

TEST_CASE("rougher levels are smoother, and never leave the range of the sky", "[gl][sky]")
{
    const CubeFaces faces = cube_of(64, [](glm::dvec3 d) { return d.z > 0.95 ? 100.0 : 1.0; });
    float last_peak = 101.0f;
    for (const CubeFaces& level : prefiltered(faces)) {
        float peak = 0.0f;
        for (const Picture& face : level)
            for (size_t i = 0; i < face.texels.size(); i += 4) {
                CHECK(face.texels[i] >= 1.0f - 2e-5f);
                peak = std::max(peak, face.texels[i]);
            }
        CHECK(peak < last_peak);
        last_peak = peak;
    }
    CHECK(last_peak > 1.5f); // the lamp still shows at roughness 1
}

TEST_CASE("the brightest place of a filtered sky is where the lamp is", "[gl][sky]")
{
    for (const glm::dvec3 lamp : kNormals) {
        const CubeFaces faces = cube_of(32, [&](glm::dvec3 d) { return std::exp(20.0 * (glm::dot(d, lamp) - 1.0)); });
        for (const CubeFaces& level : prefiltered(faces)) {
            const int size = level[0].extent.width;
            double brightest = -1.0, cosine = -1.0;
            for (int face = 0; face < 6; ++face)
                for (int y = 0; y < size; ++y)
                    for (int x = 0; x < size; ++x)
                        if (const double value = level[static_cast<size_t>(face)].at(x, y, 0); value > brightest) {
                            brightest = value;
                            cosine = glm::dot(direction(face, x, y, size), lamp);
                        }
            // Within a texel and a half of the lamp: 90 degrees a face, and the corner's diagonal.
            CHECK(std::acos(std::min(cosine, 1.0)) < 1.5 * 0.5 * kPi / size * 1.42);
        }
    }
}

TEST_CASE("a lobe that reads a sky linear in direction keeps it, times its own mean cosine", "[gl][sky]")
{
    const CubeFaces faces = cube_of(64, [](glm::dvec3 d) { return 2.0 + d.x; });
    const auto levels = prefiltered(faces);
    for (const CubeFaces& level : levels) {
        const int size = level[0].extent.width;
        const double contrast = (level[0].at(size / 2, size / 2, 0) - level[1].at(size / 2, size / 2, 0)) / 2.0;
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double along = direction(face, x, y, size).x / direction(0, size / 2, size / 2, size).x;
                    // The spiral's samples are not quite even around, 1 % of the lobe's width; reads are bilinear.
                    CHECK(level[static_cast<size_t>(face)].at(x, y, 0) == Approx(2.0 + contrast * along).margin(0.02));
                }
    }
}

TEST_CASE("under a sky of one color irradiance is pi times it, whatever the faces' size", "[gl][sky]")
{
    for (const int size : {1, 2, 5, 16, 64, 130}) {
        const Harmonics c = irradiance_harmonics(constant_cube(size, {0.25f, 1.0f, 1000.0f}));
        for (const glm::dvec3 n : kNormals) {
            const glm::dvec3 e = irradiance(c, n) / kPi;
            // Sums in double, stored in binary32; the box that reduces large faces adds 16 roundings.
            CHECK(e.x == Approx(0.25).epsilon(20.0 / 16777216.0));
            CHECK(e.y == Approx(1.0).epsilon(20.0 / 16777216.0));
            CHECK(e.z == Approx(1000.0).epsilon(20.0 / 16777216.0));
        }
    }
}

TEST_CASE("irradiance is the cosine's convolution, exactly for skies of degree 2", "[gl][sky]")
{
    const auto sky = [](glm::dvec3 d) { return 3.0 + d.x - 0.5 * d.y + 1.5 * d.z + d.x * d.y - 0.7 * d.y * d.z + 0.4 * d.x * d.z + d.z * d.z - 0.5 * d.x * d.x; };
    const CubeFaces faces = cube_of(64, sky);
    const Harmonics c = irradiance_harmonics(faces);
    for (const glm::dvec3 n : kNormals) // both sum over 64 texels a face, whose midpoints are 1e-3 off the integral
        CHECK(irradiance(c, n).x == Approx(convolved(faces, n)).epsilon(1e-3));
}

TEST_CASE("irradiance of a narrow lamp is within 0.094 of it, and of a broad sky within 1 % of its brightest", "[gl][sky]")
{
    const CubeFaces narrow = cube_of(64, [](glm::dvec3 d) { return d.z > 0.99 ? 100.0 : 0.0; });
    const CubeFaces broad = cube_of(64, [](glm::dvec3 d) { return d.y > 0.0 ? 1.0 + 2.0 * d.y : 0.3; });
    // max(cos, 0) = 1/4 + cos / 2 + 5/32 (3 cos^2 - 1) + ...: where the lamp sets the first three are 1/4 - 5/32.
    const double narrow_lamp = convolved(narrow, {0, 0, 1});
    const double brightest = convolved(broad, {0, 1, 0});
    for (const glm::dvec3 n : kNormals) {
        CHECK(irradiance(irradiance_harmonics(narrow), n).x == Approx(convolved(narrow, n)).margin(0.094 * narrow_lamp));
        CHECK(irradiance(irradiance_harmonics(broad), n).x == Approx(convolved(broad, n)).margin(0.01 * brightest));
    }
}

TEST_CASE("values are rounded to the nearest half, ties to even", "[gl][sky]")
{
    CubeFaces faces = constant_cube(1, glm::vec3(0.0f));
    const std::vector<std::pair<float, float>> cases = {
        {1.0f, 1.0f}, {1.0f + 0x1p-11f, 1.0f}, {1.0f + 0x1.8p-10f, 1.0f + 0x1p-9f}, {1.0f + 0x1.8p-11f, 1.0f + 0x1p-10f},
        {0.99999994f, 1.0f}, {65504.0f, 65504.0f}, {0x1p-24f, 0x1p-24f}, {0x1p-26f, 0.0f}, {0x1.8p-24f, 0x1p-23f}, {0.0f, 0.0f}};
    for (const auto& [given, expected] : cases) {
        faces[0].texels[0] = given;
        CHECK(rounded_to_half(faces)[0].texels[0] == expected);
        faces[0].texels[0] = -given;
        CHECK(rounded_to_half(faces)[0].texels[0] == -expected);
    }
}
