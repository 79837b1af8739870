// Checking and storing of live parameters.
#include "gl/parameters.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

bool is_whole(ParamType type)
{
    return type == ParamType::int_ || type == ParamType::bool_ || type == ParamType::enum_;
}

Errors find_value_errors(const Plan::Uniform& uniform, const Value& value)
{
    Errors errors;
    for (int i = 0; i < component_count(uniform.type); ++i) {
        const double x = value.v[static_cast<size_t>(i)];
        const bool is_inside = std::isfinite(x) && x >= uniform.lowest && x <= uniform.highest; // false for NaN
        if (!is_inside)
            errors.push_back({.code = "param_out_of_range",
                              .message = fmt::format("`{}` is {}, outside {} to {}", uniform.place, x, uniform.lowest,
                                                     uniform.highest)});
        else if (is_whole(uniform.type) && x != std::floor(x))
            errors.push_back({.code = "param_out_of_range",
                              .message = fmt::format("`{}` is {}, but takes whole numbers", uniform.place, x)});
    }
    return errors;
}

tl::unexpected<Errors> unknown(const Plan& plan, std::string_view place)
{
    std::vector<std::string> places;
    for (const Plan::Step& step : plan.steps)
        for (const Plan::Uniform& uniform : step.uniforms)
            if (std::find(places.begin(), places.end(), uniform.place) == places.end())
                places.push_back(uniform.place);
    return fail({.code = "unknown_param",
                 .message = fmt::format("the plan has no live parameter `{}`", place),
                 .hint = suggest(place, places, "live parameters")});
}

} // namespace

Result<void> set_parameter(PlanObjects& objects, std::string_view place, const Value& value)
{
    bool is_known = false;
    for (size_t s = 0; s < objects.steps.size(); ++s) {
        const std::vector<Plan::Uniform>& uniforms = objects.plan.steps[s].uniforms;
        for (size_t u = 0; u < uniforms.size(); ++u) {
            if (uniforms[u].place != place)
                continue;
            if (Errors errors = find_value_errors(uniforms[u], value); !errors.empty())
                return tl::unexpected(std::move(errors));
            for (Program* program : objects.steps[s].programs())
                program->uniforms[u].value = value;
            is_known = true;
        }
    }
    if (!is_known)
        return unknown(objects.plan, place);
    return {};
}

} // namespace passgraph::gl
