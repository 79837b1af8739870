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
    const bool is_near = lamp.kind != Light::Kind::directional;
    const dvec3 way = is_near ? dvec3(lamp.position) - place : -dvec3(lamp.direction);
    const double d = glm::length(way);
    const dvec3 l = way / d;
    const double inner = std::cos(double(lamp.inner_angle)), outer = std::cos(double(lamp.outer_angle));
    const double ramp = std::clamp((glm::dot(-l, dvec3(lamp.direction)) - outer) / (inner - outer), 0.0, 1.0);
    const double cone = lamp.kind == Light::Kind::spot ? ramp * ramp : 1.0;
    const double window = 1.0 - std::pow(d / lamp.radius, 4.0);
    const double strength = !is_near ? 1.0 : d < lamp.radius ? cone * window * window / std::max(d * d, 1e-4) : 0.0;
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

Light torch()
{
    Light lamp = lantern();
    lamp.kind = Light::Kind::spot;
    lamp.direction = glm::normalize(glm::vec3(-0.4f, -0.6f, -0.8f));
    lamp.inner_angle = 0.2f;
    lamp.outer_angle = 0.8f;
    return lamp;
}

/// Unit vectors carry 4 roundings: absolutely in n.l, hence as much of what a facing surface would show, and in D
/// relatively up to 2 / alpha = 2 / 0.09 times. The BRDF's own are 55 (see its test), the lamp's 14, diffuse's 15; a spot's
/// ramp has 8, absolutely, of a range of 0.28 in the cosine, and is squared.
void require_lit(const Picture& got, const Surfaces& s, const Light& lamp)
{
    const auto expected = [&](int x, int y, int c) { return lit(s, x, y, lamp)[c]; };
    const auto tolerance = [&](int x, int y, int c) {
        const dvec3 way = lamp.kind != Light::Kind::directional ? dvec3(lamp.position) - at(s.position, x, y) : -dvec3(lamp.direction);
        const double nl = std::max(glm::dot(glm::normalize(at(s.normal, x, y)), glm::normalize(way)), 1e-3);
        const double value = expected(x, y, c);
        return (55.0 + 14.0 + 15.0 + 4.0 * 2.0 / 0.09) * kRounding * value +
               (8.0 + 2.0 * 8.0 / 0.28) * kRounding * std::max(value / nl, 1.0);
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

TEST_CASE("a spot lamp lights surfaces as the published formulas say", "[passes][pbr]")
{
    unsigned seed = 170;
    for (const Extent extent : kExtents) {
        const Surfaces s = surfaces(extent, seed += 4);
        require_lit(shaded(s, {torch()}), s, torch());
    }
}

TEST_CASE("a spot without an axis is a point lamp, and one that opens all around too", "[passes][pbr][identity]")
{
    const Surfaces s = surfaces({17, 13}, 185);
    const Picture all_around = shaded(s, {lantern()});
    Light lamp = torch();
    lamp.direction = glm::vec3(0.0f);
    require_same(shaded(s, {lamp}), all_around);
    lamp = torch();
    lamp.inner_angle = lamp.outer_angle = 3.14159274f;
    require_same(shaded(s, {lamp}), all_around);
}

TEST_CASE("a spot whose angles are equal has a sharp, finite edge", "[passes][pbr]")
{
    const Surfaces s = surfaces({64, 64}, 186);
    Light lamp = torch();
    lamp.inner_angle = lamp.outer_angle = 0.4f;
    const Picture sharp = shaded(s, {lamp});
    const Picture whole = shaded(s, {lantern()});
    int lit = 0, dark = 0, between = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            REQUIRE(std::isfinite(sharp.at(x, y, 0)));
            if (whole.at(x, y, 0) <= 0.0f)
                continue;
            const bool is_dark = sharp.at(x, y, 0) == 0.0f;
            const bool is_lit = sharp.at(x, y, 0) == whole.at(x, y, 0);
            ++(is_dark ? dark : is_lit ? lit : between);
        }
    CHECK(lit > 500);
    CHECK(dark > 500);
    CHECK(between < 10); // the edge is 1e-4 of the cosine wide
}

TEST_CASE("a thousand lamps are the sum of each", "[passes][pbr]")
{
    const Surfaces s = surfaces({9, 5}, 187);
    Light dim = lantern();
    dim.color *= 0.001f;
    const Picture many = shaded(s, std::vector<Light>(1000, dim));
    const Picture one = shaded(s, {dim});
    // Added one by one in binary32: each sum rounds by at most half a unit of what it has become.
    require_texels(many, [&](int x, int y, int c) { return 1000.0 * one.at(x, y, c); },
                   [&](int x, int y, int c) { return 1000.0 * 500.0 * kRounding * one.at(x, y, c); });
}

TEST_CASE("a lamp's light ends exactly at its radius", "[passes][pbr]")
{
    for (const float radius : {0.3f, 1.0f, 2.7f, 33.3f}) {
        Surfaces s = {constant({3, 1}, {1, 1, 1}), constant({3, 1}, {0.5f, 0.5f, 0.0f}), constant({3, 1}, {0, 0, 1}), Picture({3, 1}, 3)};
        const float distances[] = {0.999f * radius, radius, std::nextafter(radius, INFINITY)};
        for (int x = 0; x < 3; ++x)
            s.position.at(x, 0, 2) = -distances[x];
        Light lamp = lantern();
        lamp.color = glm::vec3(60000.0f);
        lamp.position = glm::vec3(0.0f);
        lamp.radius = radius;
        const Picture got = shaded(s, {lamp});
        CHECK(got.at(0, 0, 0) > 0.0f);
        CHECK(got.at(1, 0, 0) == 0.0f);
        CHECK(got.at(2, 0, 0) == 0.0f);
    }
}

TEST_CASE("lamps that a file would refuse leave finite light, and none below 0", "[passes][pbr]")
{
    const Surfaces s = surfaces({9, 5}, 188);
    const auto is_sound = [&](Light lamp) {
        for (const float value : shaded(s, {moon(), lamp}).texels)
            if (!std::isfinite(value) || value < 0.0f)
                return false;
        return true;
    };
    for (const float bad : {NAN, INFINITY, -INFINITY, -1000.0f, 1e30f}) {
        CAPTURE(bad);
        Light lamp = torch();
        lamp.color = glm::vec3(bad, 1.0f, 1.0f);
        CHECK(is_sound(lamp));
        lamp = torch();
        lamp.position.x = bad;
        CHECK(is_sound(lamp));
        lamp = torch();
        lamp.direction.x = bad;
        CHECK(is_sound(lamp));
        lamp = torch();
        lamp.radius = bad;
        CHECK(is_sound(lamp));
        lamp = torch();
        lamp.outer_angle = bad;
        CHECK(is_sound(lamp));
        lamp = moon();
        lamp.direction = glm::vec3(bad, 0.0f, 0.0f);
        CHECK(is_sound(lamp));
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
