// Finds min, max and clamp that stand where a guard should: bounds that bound nothing, and that NaN passes through.
#include <array>
#include <limits>

#include <fmt/format.h>

#include "tool/contract/feeds.hpp"
#include "tool/contract/hostile.hpp"
#include "tool/contract/judge.hpp"

namespace passgraph::tool::contract {
namespace {

constexpr int kFeeds = 5;

std::optional<std::vector<Outputs>> draw_in_domain(const Subject& subject, const StageOptions& options)
{
    Result<Stage> stage = Stage::create(subject.library, subject.pass, options, subject.loader);
    if (!stage)
        return std::nullopt; // a bound of vectors by floats has no second argument of its type
    std::mt19937 random(3);
    std::vector<Outputs> all;
    constexpr std::array<Filling, kFeeds> kFillings = {Filling::random, Filling::edges, Filling::edges, Filling::lowest, Filling::highest};
    for (const Filling filling : kFillings) {
        auto outputs = stage->run(fill_inputs(subject, options, filling, random), scenes_for(*subject.pass).front());
        if (!outputs)
            return std::nullopt;
        all.push_back(std::move(*outputs));
    }
    return all;
}

bool is_equal(const std::vector<Outputs>& a, const std::vector<Outputs>& b)
{
    for (size_t i = 0; i < a.size(); ++i)
        for (const auto& [port, picture] : a[i])
            if (find_texel(picture, [&](Texel texel) { return !is_same(picture, b[i].at(port), texel); }))
                return false;
    return true;
}

/// Whether the bound leaves every value of the domain as it is.
bool is_idle(const Subject& subject, StageOptions options, const std::string& builtin)
{
    options.hostile.clear();
    const auto with = draw_in_domain(subject, options);
    options.removed_bound = builtin;
    for (int argument = 0; with && argument < 2; ++argument) {
        options.kept_argument = argument;
        if (const auto without = draw_in_domain(subject, options); without && is_equal(*with, *without))
            return true;
    }
    return false;
}

bool is_finite_with_nan(const Subject& subject, const StageOptions& options, const InputPort& port)
{
    Result<Stage> stage = Stage::create(subject.library, subject.pass, options, subject.loader);
    if (!stage)
        return false;
    std::mt19937 random(4);
    Feed feed = fill_inputs(subject, options, Filling::random, random);
    for (float& value : feed.at(port.name).texels)
        value = std::numeric_limits<float>::quiet_NaN();
    const auto outputs = stage->run(feed, scenes_for(*subject.pass).front());
    return outputs && is_all_finite(*outputs);
}

} // namespace

void check_guards(const Subject& subject)
{
    // Who states what becomes of non-finite values is held to that instead.
    if (subject.contract().is_stated || subject.pass->kind != PassKind::image)
        return;
    StageOptions options;
    options.hostile = hostile_builtins();
    for (const std::string builtin : {"min", "max", "clamp"})
        for (const InputPort& port : subject.pass->inputs) {
            if (port.over != Over::image)
                continue;
            subject.findings.count_run("bound_as_guard");
            options.forgiving.clear();
            if (is_finite_with_nan(subject, options, port))
                continue;
            options.forgiving = builtin;
            if (is_finite_with_nan(subject, options, port) && is_idle(subject, options, builtin))
                subject.findings.add({"bound_as_guard", "", fmt::format("NaN in `{}`", port.name), fmt::format("`{}`", builtin),
                                      "0 on some drivers and NaN on others, and no change for any value the input may have",
                                      "an ordered select, or no bound at all",
                                      fmt::format("{} is undefined for NaN: write x > 0.0 ? min(x, cap) : 0.0, or state what becomes of non-finite "
                                                  "values: \"contract\": {{ \"non_finite\": \"contained\" }}",
                                                  builtin)});
        }
}

} // namespace passgraph::tool::contract
