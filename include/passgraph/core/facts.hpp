// What is true of a scene, as far as the compiler is told: what is not there need not be drawn.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace passgraph {

/// Upper bounds: a scene has at most so much of each. 0 is "none at all", infinity, the default, is "who knows".
///
/// A host fills in what it knows, or takes `facts_of(scene)`. A plan that was compiled for facts draws every scene right that
/// has no more of anything.
struct Facts {
    static constexpr double kUnknown = std::numeric_limits<double>::infinity();

    double directional_lights = kUnknown; ///< those that are not black and reach some surface
    double point_lights = kUnknown;
    double spot_lights = kUnknown;
    double irradiance = kUnknown; ///< on any surface by all of them together, in the largest channel
    double highlight = kUnknown;  ///< the smoothest surface's reflection of unit irradiance, per steradian
    double metal = kUnknown;      ///< the largest metallic
    double emission = kUnknown;   ///< radiance that any surface emits, in the largest channel
    double sky = kUnknown;        ///< radiance of the sky's brightest texel, in the largest channel
    double surfaces = kUnknown;   ///< triangles

    double lights() const { return directional_lights + point_lights + spot_lights; }
    friend bool operator==(const Facts&, const Facts&) = default;
};

struct FactRow {
    std::string_view name;
    std::string_view meaning;
    double (*get)(const Facts&);
    void (*set)(Facts&, double); ///< nullptr: follows from the others
};
/// Every fact by the name that pass headers use for it.
std::span<const FactRow> all_facts();
/// nullptr when there is none of that name.
const FactRow* find_fact(std::string_view name);

/// What is true of two scenes.
Facts either(const Facts& a, const Facts& b);

/// "the plan is for at most 2 point lights, the scene has 3": each fact of which `scene` has more than `promised`.
std::vector<std::string> broken_promises(const Facts& promised, const Facts& scene);

} // namespace passgraph
