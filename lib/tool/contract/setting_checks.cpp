// Parameters at and beyond the ends of their ranges.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "tool/contract/suite.hpp"

namespace passgraph::tool::contract {
namespace {

bool has_code(const Errors& errors, std::string_view code)
{
    return std::any_of(errors.begin(), errors.end(), [&](const Error& error) { return error.code == code; });
}

void expect_refusal(const Subject& subject, const Param& param, double value)
{
    const PassArguments::Setting setting = number_setting(param, value);
    const StageOptions options{.settings = {setting}};
    subject.findings.count_run("param_range");
    const Result<Plan> plan = plan_of(subject.library, subject.pass, options);
    if (!plan && has_code(plan.error(), "param_out_of_range"))
        return;
    subject.findings.add({"param_range", to_text(options.settings), "", fmt::format("parameter `{}`", param.name),
                          plan ? "it is taken" : to_text(plan.error().front()), "error[param_out_of_range]", ""});
}

/// A running plan refuses as a compiled one does.
void expect_live_refusal(const Subject& subject, Stage& stage, const Param& param, double value)
{
    for (const Plan::Step& step : stage.plan().steps)
        for (const Plan::Uniform& uniform : step.uniforms) {
            if (uniform.place.substr(uniform.place.rfind('.') + 1) != param.name)
                continue;
            subject.findings.count_run("param_range");
            Value wrong;
            wrong.v.fill(value);
            const Result<void> set = stage.renderer().set(uniform.place, wrong);
            if (!set && has_code(set.error(), "param_out_of_range"))
                return;
            subject.findings.add({"param_range", fmt::format("{}={}", param.name, value), "", fmt::format("live parameter `{}`", uniform.place),
                                  set ? "it is taken" : to_text(set.error().front()), "error[param_out_of_range]", ""});
            return;
        }
}

void check_parameters(const Subject& subject)
{
    std::optional<Stage> stage = subject.pass->params.empty() ? std::nullopt : open_stage(subject, {});
    for (const Param& param : subject.pass->params) {
        if (param.type == ParamType::bool_ || param.type == ParamType::enum_)
            continue;
        const bool is_whole = param.type == ParamType::int_;
        std::vector<double> wrong = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
        // The next float: a double closer to the end would be the end itself by the time a shader sees it.
        if (std::isfinite(param.lowest))
            wrong.push_back(is_whole ? param.lowest - 1.0 : static_cast<double>(std::nextafter(static_cast<float>(param.lowest), -HUGE_VALF)));
        if (std::isfinite(param.highest))
            wrong.push_back(is_whole ? param.highest + 1.0 : static_cast<double>(std::nextafter(static_cast<float>(param.highest), HUGE_VALF)));
        for (const double value : wrong) {
            expect_refusal(subject, param, value);
            if (stage)
                expect_live_refusal(subject, *stage, param, value);
        }
    }
}

} // namespace

void check_settings(const Subject& subject)
{
    check_parameters(subject);
}

} // namespace passgraph::tool::contract
