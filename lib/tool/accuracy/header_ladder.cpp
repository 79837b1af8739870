// Ladders of pass headers: inputs, truth and metric by the name of their reference.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "tool/accuracy/choose.hpp"
#include "tool/accuracy/ladders/ladders.hpp"

namespace passgraph::accuracy {
namespace {

/// A reference that headers may name: a ladder to take all but the rungs from, and what a pass needs to be drawn like it.
struct Reference {
    std::string name;
    Ladder (*like)();
    std::string param;  ///< that the pass must have; ""
    std::string value;  ///< and what it is set to
    std::string choice; ///< of the pass, whose items are drawn one after another; ""
    std::string needs;  ///< in words
};

const std::vector<Reference>& references()
{
    static const std::vector<Reference> all = {
        {"gaussian", blur, "sigma", "3", "direction", "one image, a parameter `sigma` in texels, and a choice `direction` if it blurs along one axis"},
        {"filmic_display", tone_curve, "", "", "", "an image of radiance in, of display out"},
    };
    return all;
}

std::string reference_names()
{
    std::string names;
    for (const Reference& reference : references())
        names += fmt::format("{}`{}` ({})", names.empty() ? "" : "; ", reference.name, reference.needs);
    return names;
}

int required_images(const PassDeclaration& pass)
{
    return static_cast<int>(std::count_if(pass.inputs.begin(), pass.inputs.end(), [](const InputPort& port) { return !port.is_optional; }));
}

/// The pass drawn once, or once for each item of a choice, each reading the one before.
std::string graph_of(const PassDeclaration& pass, const Reference& reference)
{
    std::vector<std::string> items = {""};
    const int choice = reference.choice.empty() ? -1 : pass.find_selection(reference.choice);
    if (choice >= 0)
        items = pass.selections[static_cast<size_t>(choice)].items;
    std::string passes;
    std::string before = "image";
    for (size_t i = 0; i < items.size(); ++i) {
        const std::string choices = items[i].empty() ? "" : fmt::format(R"(, "choices": {{ "{}": "{}" }})", reference.choice, items[i]);
        passes += fmt::format(R"({}"draw_{}": {{ "pass": "{}", "inputs": {{ "{}": "{}" }}{}, "codecs": {{ "{}": "rgba32f" }} }})", i > 0 ? ", " : "", i, pass.name,
                              pass.inputs.front().name, before, choices, pass.outputs.front().name);
        before = fmt::format("draw_{}", i);
    }
    return fmt::format(R"({{ "passgraph": 1, "inputs": {{ "image": "radiance" }}, "passes": {{ {} }}, "outputs": {{ "result": "{}" }} }})", passes, before);
}

NamePairs settings_of(const PassDeclaration& pass, const Reference& reference, const std::string& ladder, const std::string& item)
{
    NamePairs settings;
    const int choice = reference.choice.empty() ? -1 : pass.find_selection(reference.choice);
    const size_t draws = choice >= 0 ? pass.selections[static_cast<size_t>(choice)].items.size() : 1;
    for (size_t i = 0; i < draws; ++i) {
        settings.emplace_back(fmt::format("draw_{}.{}", i, ladder), item);
        if (!reference.param.empty())
            settings.emplace_back(fmt::format("draw_{}.{}", i, reference.param), reference.value);
    }
    return settings;
}

} // namespace

Result<Ladder> header_ladder(const PassDeclaration& pass, const Selection& selection)
{
    if (selection.reference.empty())
        return fail({"ladder_without_reference",
                     fmt::format("the ladder `{}` of `{}` names no reference: its errors cannot be measured", selection.name, pass.name),
                     "add \"reference\": NAME to it; references are: " + reference_names(), selection.where});
    const auto found = std::find_if(references().begin(), references().end(), [&](const Reference& row) { return row.name == selection.reference; });
    if (found == references().end())
        return fail({"unknown_reference", fmt::format("the ladder `{}` of `{}`: there is no reference `{}`", selection.name, pass.name, selection.reference),
                     "references are: " + reference_names(), selection.where});
    if (required_images(pass) != 1 || pass.inputs.front().over != Over::image || pass.outputs.size() != 1 ||
        (!found->param.empty() && pass.find_param(found->param) < 0))
        return fail({"reference_mismatch", fmt::format("`{}` cannot be compared with `{}`", pass.name, found->name), "it needs " + found->needs, selection.where});
    Ladder ladder = found->like();
    ladder.name = pass.name + "." + selection.name;
    ladder.title = fmt::format("{}: {}", pass.name, selection.name);
    ladder.about = fmt::format("{} The reference is `{}`.", pass.summary, found->name);
    ladder.passes = {pass.name};
    ladder.measures = {{pass.name, selection.name}};
    ladder.rungs.clear();
    for (size_t item = 0; item < selection.items.size(); ++item)
        ladder.rungs.push_back({.name = selection.items[item],
                                .what = fmt::format("{} {}", selection.name, selection.items[item]),
                                .graph = graph_of(pass, *found),
                                .settings = settings_of(pass, *found, selection.name, selection.items[item]),
                                .bound = std::numeric_limits<double>::infinity(),
                                .is_default = static_cast<int>(item) == selection.default_item});
    return ladder;
}

} // namespace passgraph::accuracy
