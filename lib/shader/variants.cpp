// The selections and static values under which a pass's body may differ.
#include "shader/variants.hpp"

#include <algorithm>
#include <cmath>

#include "core/glsl/assemble.hpp"
#include "core/pass/glsl_scan.hpp"

namespace passgraph::shader {
namespace {

constexpr size_t kMostVariants = 256;
constexpr double kMostWholeNumbers = 16.0; ///< an integer of so few values takes each of them

template <class Setting>
VariantList<Setting> combinations(const std::vector<std::vector<Setting>>& values, const std::vector<Setting>& defaults)
{
    VariantList<Setting> variants{{defaults}};
    size_t product = 1;
    for (const auto& candidates : values)
        product = std::min(product * std::max<size_t>(candidates.size(), 1), kMostVariants + 1);
    variants.is_complete = product <= kMostVariants;
    for (size_t setting = 0; setting < values.size(); ++setting) {
        if (values[setting].size() < 2)
            continue;
        std::vector<std::vector<Setting>> grown;
        for (const auto& variant : variants.is_complete ? variants.all : std::vector<std::vector<Setting>>{defaults})
            for (const Setting& value : values[setting]) {
                grown.push_back(variant);
                grown.back()[setting] = value;
            }
        if (variants.is_complete)
            variants.all = std::move(grown);
        else
            variants.all.insert(variants.all.end(), grown.begin(), grown.end());
    }
    return variants;
}

/// True when the preprocessor may see the selection, so that the body is another text for each of its items.
bool stands_in_directive(const GlslText& body, const Selection& selection)
{
    const auto tokens = scan_glsl(body.text, 1, 1);
    return std::any_of(tokens.begin(), tokens.end(), [&](const GlslToken& token) {
        return token.is_directive && token.text.find(selection.name) != std::string_view::npos;
    });
}

std::vector<Value> candidate_values(const Param& param)
{
    std::vector<Value> values = {param.default_value};
    if (!param.is_static)
        return values;
    if (param.type == ParamType::bool_)
        return {Value(0.0), Value(1.0)};
    const double highest =
        param.type == ParamType::enum_ ? static_cast<double>(param.items.size()) - 1.0 : param.highest;
    const double lowest = param.type == ParamType::enum_ ? 0.0 : param.lowest;
    const bool is_whole =
        param.type == ParamType::enum_ || (param.type == ParamType::int_ && highest - lowest < kMostWholeNumbers);
    if (is_whole) {
        values.clear();
        for (double value = std::ceil(lowest); value <= highest; value += 1.0)
            values.emplace_back(value);
        return values;
    }
    for (const double end : {lowest, highest})
        if (std::isfinite(end))
            values.emplace_back(end, end, end, end);
    return values;
}

} // namespace

VariantList<int> selections_of(const PassDeclaration& pass, bool leaves_open)
{
    std::vector<std::vector<int>> values;
    std::vector<int> defaults;
    for (const Selection& selection : pass.selections) {
        const bool is_open = leaves_open && selection.kind != Selection::Kind::layout && !stands_in_directive(pass.body, selection);
        defaults.push_back(is_open ? glsl::kAnyItem : selection.default_item);
        values.emplace_back();
        if (is_open)
            continue;
        for (size_t item = 0; selection.kind != Selection::Kind::layout && item < selection.items.size(); ++item)
            values.back().push_back(static_cast<int>(item));
    }
    return combinations(values, defaults);
}

VariantList<Value> statics_of(const PassDeclaration& pass)
{
    std::vector<std::vector<Value>> values;
    std::vector<Value> defaults;
    const bool has_statics =
        std::any_of(pass.params.begin(), pass.params.end(), [](const Param& param) { return param.is_static; });
    for (const Param& param : pass.params) {
        if (!has_statics)
            break;
        defaults.push_back(param.default_value);
        values.push_back(candidate_values(param));
    }
    return combinations(values, defaults);
}

} // namespace passgraph::shader
