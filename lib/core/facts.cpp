// The table of facts.
#include "passgraph/core/facts.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace passgraph {
namespace {

template <double Facts::*member>
constexpr FactRow row(std::string_view name, std::string_view meaning)
{
    return {name, meaning, [](const Facts& facts) { return facts.*member; }, [](Facts& facts, double value) { facts.*member = value; }};
}

constexpr std::array kFacts = {
    FactRow{"lights", "lamps that reach a surface", [](const Facts& facts) { return facts.lights(); }, nullptr},
    row<&Facts::directional_lights>("directional_lights", "directional lights that reach a surface"),
    row<&Facts::point_lights>("point_lights", "point lights that reach a surface"),
    row<&Facts::spot_lights>("spot_lights", "spot lights that reach a surface"),
    row<&Facts::irradiance>("irradiance", "irradiance of all lamps together on the surface they reach best"),
    row<&Facts::highlight>("highlight", "radiance of the smoothest surface's highlight, per unit of irradiance"),
    row<&Facts::metal>("metal", "largest metallic of any surface"),
    row<&Facts::emission>("emission", "largest radiance that a surface emits"),
    row<&Facts::sky>("sky", "largest radiance of the sky"),
    row<&Facts::surfaces>("surfaces", "triangles"),
};

} // namespace

std::span<const FactRow> all_facts() { return kFacts; }

const FactRow* find_fact(std::string_view name)
{
    for (const FactRow& row : kFacts)
        if (row.name == name)
            return &row;
    return nullptr;
}

Facts either(const Facts& a, const Facts& b)
{
    Facts both;
    for (const FactRow& row : kFacts)
        if (row.set != nullptr)
            row.set(both, std::max(row.get(a), row.get(b)));
    return both;
}

std::vector<std::string> broken_promises(const Facts& promised, const Facts& scene)
{
    std::vector<std::string> broken;
    for (const FactRow& row : kFacts)
        if (row.set != nullptr && row.get(scene) > row.get(promised))
            broken.push_back(fmt::format("the plan is for at most {:g} `{}` ({}), the scene has {:g}", row.get(promised), row.name,
                                         row.meaning, row.get(scene)));
    return broken;
}

} // namespace passgraph
