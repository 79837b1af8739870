// Lighting by lamps, as a picture, against the same formulas in double: directional, point, several.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

#include <passgraph/scene/scene.hpp>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;
using glm::dvec3;

namespace {

constexpr double kPi = 3.14159265358979324;

struct Surfaces {
    Picture albedo, material, normal, position;
};

/// Random surfaces that face the viewer at the origin: n.v above 0.3, roughness above 0.3.
Surfaces surfaces(Extent extent, unsigned seed)
{
    Surfaces s = {noise(extent, 3, 0.05f, 0.95f, seed), noise(extent, 3, 0.3f, 1.0f, seed + 1), noise(extent, 3, -0.6f, 0.6f, seed + 2),
                  noise(extent, 3, -0.5f, 0.5f, seed + 3)};
    for (int y = 0; y < extent.height; ++y) {
        for (int x = 0; x < extent.width; ++x) {
            s.normal.at(x, y, 2) = 1.0f;
            s.position.at(x, y, 2) -= 2.0f;
        }
    }
    return s;
}

dvec3 at(const Picture& picture, int x, int y)
{
    return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

double weight(double cosine) { return std::pow(1.0 - cosine, 5.0); }

/// Radiance towards the viewer from one lamp, in double, as published: Walter 2007, Heitz 2014, Schlick 1994.
dvec3 lit(const Surfaces& s, int x, int y, const Light& lamp)
{
    const dvec3 place = at(s.position, x, y);
    const dvec3 n = glm::normalize(at(s.normal, x, y));
    const dvec3 v = glm::normalize(-place);
    const dvec3 way = lamp.kind == Light::Kind::point ? dvec3(lamp.position) - place : -dvec3(lamp.direction);
    const double d = glm::length(way);
    const dvec3 l = way / d;
    const double window = 1.0 - std::pow(d / lamp.radius, 4.0);
    const double strength = lamp.kind != Light::Kind::point ? 1.0 : d < lamp.radius ? window * window / std::max(d * d, 1e-4) : 0.0;
    const double nl = glm::dot(n, l);
    const double nv = glm::dot(n, v);
    if (nl <= 0.0)
        return dvec3(0.0);
    const dvec3 h = glm::normalize(v + l);
    const dvec3 base = at(s.albedo, x, y);
    const dvec3 matter = at(s.material, x, y);
    const double a2 = std::pow(matter.y, 4.0);
    const double nh = glm::dot(n, h);
    const double distribution = a2 / (kPi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
    const double visibility = 0.5 / (nl * std::sqrt(a2 + (1.0 - a2) * nv * nv) + nv * std::sqrt(a2 + (1.0 - a2) * nl * nl));
    const double dielectric = 0.08 * matter.x;
    const dvec3 f0 = glm::mix(dvec3(dielectric), base, matter.z);
    const dvec3 fresnel = f0 + (1.0 - f0) * weight(glm::dot(v, h));
    const double entering = (1.0 - dielectric) * (1.0 - dielectric) * (1.0 - weight(nv)) * (1.0 - weight(nl));
    const dvec3 diffuse = base * ((1.0 - matter.z) * entering / kPi);
    return (fresnel * (distribution * visibility) + diffuse) * (nl * strength) * dvec3(lamp.color);
}

Picture shaded(const Surfaces& s, std::vector<Light> lamps)
{
    Scene scene;
    scene.lights = std::move(lamps);
    return run_for_output({.pass = "pbr",
                           .inputs = {{"albedo", s.albedo}, {"material", s.material}, {"normal", s.normal}, {"position", s.position}},
                           .scene = &scene});
}

Light moon()
{
    Light lamp;
    lamp.color = {1.2f, 1.2f, 3.5f};
    lamp.direction = glm::normalize(glm::vec3(0.75f, -0.75f, -0.75f));
    return lamp;
}

Light lantern()
{
    Light lamp;
    lamp.kind = Light::Kind::point;
    lamp.color = {3.0f, 1.9f, 0.5f};
    lamp.position = {0.4f, 0.6f, -1.2f};
    lamp.radius = 5.0f;
    return lamp;
}

/// Unit vectors carry 4 roundings: absolutely in n.l, hence as much of what a facing surface would show, and in D
/// relatively up to 2 / alpha = 2 / 0.09 times. The BRDF's own are 46 (see its test), the lamp's 10, diffuse's 15.
void require_lit(const Picture& got, const Surfaces& s, const Light& lamp)
{
    const auto expected = [&](int x, int y, int c) { return lit(s, x, y, lamp)[c]; };
    const auto tolerance = [&](int x, int y, int c) {
        const dvec3 way = lamp.kind == Light::Kind::point ? dvec3(lamp.position) - at(s.position, x, y) : -dvec3(lamp.direction);
        const double nl = std::max(glm::dot(glm::normalize(at(s.normal, x, y)), glm::normalize(way)), 1e-3);
        const double value = expected(x, y, c);
        return (46.0 + 10.0 + 15.0 + 4.0 * 2.0 / 0.09) * kRounding * value + 8.0 * kRounding * std::max(value / nl, 1.0);
    };
    require_texels(got, expected, tolerance);
}

} // namespace

TEST_CASE("a directional lamp lights surfaces as the published formulas say", "[passes][pbr]")
{
    unsigned seed = 130;
    for (const Extent extent : kExtents) {
        const Surfaces s = surfaces(extent, seed += 4);
        require_lit(shaded(s, {moon()}), s, moon());
    }
}

TEST_CASE("a point lamp lights surfaces as the published formulas say", "[passes][pbr]")
{
    unsigned seed = 160;
    for (const Extent extent : kExtents) {
        const Surfaces s = surfaces(extent, seed += 4);
        require_lit(shaded(s, {lantern()}), s, lantern());
    }
}

TEST_CASE("lamps add, where the first demo divided by their number", "[passes][pbr][identity]")
{
    const Surfaces s = surfaces({17, 13}, 180);
    const Picture one = shaded(s, {moon()});
    const Picture other = shaded(s, {lantern()});
    const Picture both = shaded(s, {moon(), lantern()});
    const auto sum = [&](int x, int y, int c) { return double(one.at(x, y, c)) + other.at(x, y, c); };
    require_texels(both, sum, [&](int x, int y, int c) { return 2.0 * kRounding * sum(x, y, c); });
}

TEST_CASE("twice the lamp's color is twice the light", "[passes][pbr][identity]")
{
    const Surfaces s = surfaces({17, 13}, 190);
    Picture once = shaded(s, {lantern()});
    Light bright = lantern();
    bright.color *= 2.0f;
    for (float& value : once.texels)
        value *= 2.0f;
    require_same(shaded(s, {bright}), once);
}

TEST_CASE("a lamp out of reach, of radius 0 or behind the surfaces leaves them black", "[passes][pbr]")
{
    const Surfaces s = surfaces({17, 13}, 200);
    const Picture black = constant({17, 13}, {0.0f, 0.0f, 0.0f});
    Light lamp = lantern();
    lamp.radius = 0.1f;
    require_same(shaded(s, {lamp}), black);
    lamp.radius = 0.0f;
    require_same(shaded(s, {lamp}), black);
    Light away = moon();
    away.direction = {0.0f, 0.0f, 1.0f};
    require_same(shaded(s, {away}), black);
}

TEST_CASE("a lamp in the surface itself lights it brightly, not infinitely", "[passes][pbr][defect 7]")
{
    Surfaces s = surfaces({1, 1}, 210);
    Light lamp = lantern();
    lamp.position = {0.25f, 0.5f, -2.0f};
    lamp.color = glm::vec3(1.0f);
    for (int c = 0; c < 3; ++c)
        s.position.at(0, 0, c) = static_cast<float>(lamp.position[c]);
    const Picture got = shaded(s, {lamp});
    for (int c = 0; c < 3; ++c) {
        CHECK(std::isfinite(got.at(0, 0, c)));
        CHECK(got.at(0, 0, c) > 0.0f);
        CHECK(got.at(0, 0, c) <= 65504.0f);
    }
}

TEST_CASE("lamps leave a pixel without geometry black", "[passes][pbr]")
{
    Surfaces s = surfaces({17, 13}, 220);
    s.position = constant({17, 13}, {0.0f, 0.0f, 0.0f});
    Light at_the_viewer = lantern();
    at_the_viewer.position = glm::vec3(0.0f);
    require_same(shaded(s, {moon(), lantern(), at_the_viewer}), constant({17, 13}, {0.0f, 0.0f, 0.0f}));
}
