// Upper bounds of what is in a scene.
#include "passgraph/scene/facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "passgraph/scene/bounds.hpp"
#include "passgraph/scene/camera_matrices.hpp"

namespace passgraph {
namespace {

constexpr double kLargest = 65504.0;         // radiance's domain
constexpr double kHalfUlp = 1.0 / 1024.0;    // what binary16 may round a value up by, twice over
constexpr double kCodeStep = 0.5 / 255.0;    // what an 8-bit code may be off by
constexpr double kSmallestRoughness = 0.045; // as in the passes' brdf.glsl: smoother is drawn as this
constexpr double kSmallestSquared = 1e-4;    // metres^2, as in attenuation.glsl: nearer, light grows no more
// A surface's place in a picture is off by its distance times 1e-7, so a lamp reaches a little further than its radius.
constexpr double kReach = 1.01;

std::vector<Bounds> boxes_of(const Scene& scene)
{
    std::vector<Bounds> boxes;
    for (const Element& element : scene.elements)
        if (const Bounds box = bounds(scene, element); !box.is_empty())
            boxes.push_back(box);
    return boxes;
}

double largest(const glm::vec3& color) { return static_cast<double>(std::max({color.x, color.y, color.z})); }

double squared_distance(const Bounds& box, const glm::dvec3& place)
{
    const glm::dvec3 nearest = glm::clamp(place, glm::dvec3(box.low), glm::dvec3(box.high));
    return glm::dot(nearest - place, nearest - place);
}

bool reaches(const Light& light, const Bounds& box)
{
    const double radius = static_cast<double>(light.radius) * kReach;
    return light.kind == Light::Kind::directional || squared_distance(box, light.position) < radius * radius;
}

/// The most a lamp gives to any place of the box: neither its window nor its cone gives more than 1.
double most_irradiance(const Light& light, const Bounds& box)
{
    if (light.kind == Light::Kind::directional)
        return largest(light.color);
    return reaches(light, box) ? largest(light.color) / std::max(squared_distance(box, light.position), kSmallestSquared) : 0.0;
}

/// Whether any of a sphere may be inside a view's frustum: its center is no further outside of any side than its radius.
class Frustum {
public:
    Frustum(const Camera& camera, Extent view)
    {
        const CameraMatrices m = matrices(camera, view);
        const glm::mat4 rows = glm::transpose(m.clip_from_view * m.view_from_world);
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {1.0f, -1.0f})
                sides_.push_back(axis < 2 ? glm::dvec4(rows[3] + sign * rows[axis])
                                          : glm::dvec4(sign > 0.0f ? rows[2] : rows[3] - rows[2])); // depth from 0 to w
    }

    bool may_contain(const glm::dvec3& center, double radius) const
    {
        return std::all_of(sides_.begin(), sides_.end(), [&](const glm::dvec4& side) {
            return glm::dot(side, glm::dvec4(center, 1.0)) >= -radius * glm::length(glm::dvec3(side));
        });
    }

private:
    std::vector<glm::dvec4> sides_;
};

/// Ends of what a texture's channel holds, as 0 to 1; white where there is none.
struct Ends {
    double lowest = 1.0;
    double highest = 1.0;
};
Ends ends_of(const Scene& scene, int texture, int channel)
{
    if (texture < 0)
        return {};
    const std::vector<std::uint8_t>& codes = scene.textures[static_cast<size_t>(texture)].rgba;
    int lowest = 255;
    int highest = 0;
    for (size_t i = static_cast<size_t>(channel); i < codes.size(); i += 4) {
        lowest = std::min(lowest, static_cast<int>(codes[i]));
        highest = std::max(highest, static_cast<int>(codes[i]));
    }
    return {lowest / 255.0, highest / 255.0};
}

/// D(h) V n.l of unit light at most: GGX's D is 1 / (pi alpha^2) at its peak; Beckmann's too, except that alpha above
/// sqrt(1/2) moves the peak to cos^2 = 1 / (2 alpha^2), where it is 4 alpha^2 e^(1/alpha^2 - 2) / pi. Smith's V n.l
/// = 1 / (4 (n.v + n.v Lambda(v))) is largest where n.v is 0: 1 / (2 alpha) for GGX, sqrt(pi) / (2 alpha) for Beckmann.
double highlight_of(double roughness)
{
    const double alpha = std::pow(std::clamp(roughness, kSmallestRoughness, 1.0), 2.0);
    double density = 1.0 / (std::numbers::pi * alpha * alpha);
    if (alpha * alpha > 0.5)
        density = std::max(density, 4.0 * alpha * alpha * std::exp(1.0 / (alpha * alpha) - 2.0) / std::numbers::pi);
    constexpr double kRounding = 1.01;
    return kRounding * density * std::sqrt(std::numbers::pi) / (2.0 * alpha);
}

void add_materials(const Scene& scene, Facts& facts)
{
    std::vector<bool> is_used(scene.materials.size(), false);
    for (const Element& element : scene.elements)
        if (const Mesh& mesh = scene.meshes[static_cast<size_t>(element.mesh)]; !mesh.indices.empty())
            is_used[static_cast<size_t>(mesh.material)] = true;
    facts.metal = facts.emission = facts.highlight = 0.0;
    for (size_t i = 0; i < is_used.size(); ++i) {
        if (!is_used[i])
            continue;
        const Material& material = scene.materials[i];
        const double metal = static_cast<double>(material.metallic) * ends_of(scene, material.metallic_roughness_texture, 2).highest;
        facts.metal = std::max(facts.metal, metal > 0.0 ? std::min(metal + kCodeStep, 1.0) : 0.0);
        const double roughness = static_cast<double>(material.roughness) * ends_of(scene, material.metallic_roughness_texture, 1).lowest;
        facts.highlight = std::max(facts.highlight, highlight_of(roughness - kCodeStep));
        for (int c = 0; c < 3; ++c) // the sRGB decoding of a texel never exceeds the texel
            facts.emission = std::max(facts.emission, static_cast<double>(material.emissive[c]) *
                                                          ends_of(scene, material.emissive_texture, c).highest * (1.0 + kHalfUlp));
    }
    facts.emission = std::min(facts.emission, kLargest);
}

double brightest_of(const Sky& sky)
{
    double brightest = 0.0;
    for (const Picture& face : sky.faces)
        for (size_t i = 0; i < face.texels.size(); ++i)
            if (const double value = static_cast<double>(face.texels[i]); value > brightest && (face.channels < 4 || i % 4 != 3))
                brightest = value;
    return std::min(brightest * (1.0 + kHalfUlp), kLargest);
}

} // namespace

bool shines(const Light& light)
{
    const auto is_finite = [](const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    if (!is_finite(light.color) || !is_finite(light.direction) || !(largest(light.color) > 0.0))
        return false;
    if (light.kind == Light::Kind::directional)
        return glm::length(light.direction) > 0.0f;
    return is_finite(light.position) && light.radius > 0.0f;
}

std::vector<LampReach> lamp_reaches(const Scene& scene, Extent view)
{
    const std::vector<Bounds> boxes = boxes_of(scene);
    const Frustum frustum(scene.camera, view);
    std::vector<LampReach> all;
    for (const Light& light : scene.lights) {
        LampReach reach{.is_on = shines(light)};
        reach.to_surface = reach.is_on && std::any_of(boxes.begin(), boxes.end(), [&](const Bounds& box) { return reaches(light, box); });
        reach.to_view = reach.to_surface && (light.kind == Light::Kind::directional ||
                                             frustum.may_contain(light.position, static_cast<double>(light.radius) * kReach));
        all.push_back(reach);
    }
    return all;
}

Facts facts_of(const Scene& scene)
{
    Facts facts;
    facts.directional_lights = facts.point_lights = facts.spot_lights = 0.0;
    const std::vector<LampReach> reaching = lamp_reaches(scene);
    for (size_t i = 0; i < reaching.size(); ++i)
        if (reaching[i].to_surface)
            (scene.lights[i].kind == Light::Kind::directional ? facts.directional_lights
             : scene.lights[i].kind == Light::Kind::point     ? facts.point_lights
                                                              : facts.spot_lights) += 1.0;
    facts.irradiance = 0.0;
    for (const Bounds& box : boxes_of(scene)) {
        double together = 0.0;
        for (size_t i = 0; i < reaching.size(); ++i)
            together += reaching[i].to_surface ? most_irradiance(scene.lights[i], box) : 0.0;
        facts.irradiance = std::max(facts.irradiance, together);
    }
    facts.surfaces = 0.0;
    for (const Element& element : scene.elements)
        facts.surfaces += static_cast<double>(scene.meshes[static_cast<size_t>(element.mesh)].indices.size() / 3);
    add_materials(scene, facts);
    facts.sky = brightest_of(scene.sky);
    return facts;
}

} // namespace passgraph
