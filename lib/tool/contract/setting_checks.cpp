// Parameters at and beyond the ends of their ranges, and the settings that make a pass its input.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "tool/contract/scenes.hpp"
#include "tool/contract/suite.hpp"
#include "tool/contract/values.hpp"

namespace passgraph::tool::contract {
namespace {

PassArguments::Setting number_setting(const Param& param, double value)
{
    PassArguments::Setting setting;
    setting.name = param.name;
    setting.numbers.assign(static_cast<size_t>(component_count(param.type)), value);
    return setting;
}

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

/// Settings around the defaults under which the header's condition may hold: each parameter at its ends, at 0 and at 1.
std::vector<Settings> candidates(const PassDeclaration& pass)
{
    std::vector<Settings> all = {{}};
    for (const Settings& settings : parameter_variants(pass))
        all.push_back(settings);
    for (const Param& param : pass.params)
        for (const double value : {0.0, 1.0})
            if (param.type != ParamType::enum_ && param.type != ParamType::bool_ && value >= param.lowest && value <= param.highest)
                all.push_back({number_setting(param, value)});
    return all;
}

bool is_filtered(const PassDeclaration& pass)
{
    const InputPort& port = pass.inputs[static_cast<size_t>(pass.find_input(pass.identity_is))];
    return port.filter == Filter::linear || !port.filter_by.empty();
}

void check_identity(const Subject& subject)
{
    const PassDeclaration& pass = *subject.pass;
    if (pass.identity_when.empty())
        return;
    bool is_met = false;
    std::mt19937 random(5);
    for (const Settings& settings : candidates(pass)) {
        const Result<double> holds = value_of(subject, pass.identity_when, settings);
        if (!holds || *holds == 0.0)
            continue;
        for (const Settings& selection : selection_variants(pass)) {
            is_met = true;
            StageOptions options;
            options.settings = settings;
            options.settings.insert(options.settings.end(), selection.begin(), selection.end());
            std::optional<Stage> stage = open_stage(subject, options);
            if (!stage)
                return;
            Feed feed;
            for (const InputPort& port : pass.inputs)
                feed[port.name] = picture_of(Filling::random, signal_of(port.signal, options), span_of(pass.contract.domain, port.name, signal_of(port.signal, options)),
                                             extent_of(port, options), random);
            static const Scene scene = lit_scene();
            const auto outputs = run_stage(subject, *stage, feed, pass.reads.lights || pass.reads.camera ? &scene : nullptr, options);
            if (!outputs)
                return;
            subject.findings.count_run("identity");
            const Picture& out = outputs->begin()->second;
            const Picture& in = feed.at(pass.identity_is);
            const float largest = is_filtered(pass) ? *std::max_element(in.texels.begin(), in.texels.end()) : 0.0f;
            for (size_t i = 0; i < out.texels.size(); ++i) {
                // A division is a product with a rounded reciprocal on many devices: x / x may miss 1 by a few last bits. And a
                // linear filter takes a rounding's share of the neighbors even at a texel's center.
                const float allowed = 4.0f / 16777216.0f * std::abs(in.texels[i]) + static_cast<float>(kRounding) * largest;
                if (std::abs(out.texels[i] - in.texels[i]) <= allowed)
                    continue;
                const auto texel = static_cast<int>(i) / out.channels;
                subject.findings.add({"identity", to_text(options.settings), "random values",
                                      fmt::format("({}, {}) of {}x{}", texel % out.extent.width, texel / out.extent.width, out.extent.width, out.extent.height),
                                      fmt::format("{:.9g}", out.texels[i]), fmt::format("`{}` itself: {:.9g}", pass.identity_is, in.texels[i]),
                                      "correct \"identity\", or the pass: a compiler leaves it out where the condition holds"});
                break;
            }
        }
    }
    if (!is_met)
        subject.findings.add({"identity", "", "", fmt::format("\"{}\"", pass.identity_when), "no parameters within their ranges meet it",
                              "a condition that can hold", "correct the condition, or the range"});
}

} // namespace

void check_settings(const Subject& subject)
{
    check_parameters(subject);
    check_identity(subject);
}

} // namespace passgraph::tool::contract
