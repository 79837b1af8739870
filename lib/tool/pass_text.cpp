// A pass's declaration as text.
#include <cmath>

#include <fmt/format.h>

#include "tool/pass_pages.hpp"

namespace passgraph::tool {
namespace {

std::string value_text(const Param& param)
{
    const Value& value = param.default_value;
    if (param.type == ParamType::bool_)
        return value.v[0] != 0.0 ? "true" : "false";
    if (param.type == ParamType::enum_)
        return param.items.at(static_cast<size_t>(value.v[0]));
    const int components = component_count(param.type);
    return fmt::format("{}", fmt::join(value.v.begin(), value.v.begin() + components, ","));
}

std::string range_text(const Param& param)
{
    if (param.type == ParamType::enum_)
        return fmt::format("  one of {}", fmt::join(param.items, ", "));
    if (!std::isfinite(param.lowest) && !std::isfinite(param.highest))
        return "";
    return fmt::format("  in [{}, {}]", param.lowest, param.highest);
}

std::string_view signal_text(const InputPort& port)
{
    return port.over == Over::scene ? "a scene" : info(port.signal).name;
}

const std::string& default_item(const Selection& selection)
{
    return selection.items.at(static_cast<size_t>(selection.default_item));
}

std::string input_line(const InputPort& port)
{
    if (port.over == Over::scene)
        return fmt::format("  {}  a scene\n", port.name);
    static constexpr std::string_view kWraps[] = {"clamp", "mirror", "repeat"};
    return fmt::format("  {}  {}{}, {}, {}{}, read {}{}\n", port.name, info(port.signal).name,
                       port.over == Over::sphere  ? " over directions (a cube map)"
                       : port.over == Over::table ? " as a table"
                                                  : "",
                       port.filter == Filter::linear ? "linear" : "nearest", kWraps[static_cast<size_t>(port.wrap)],
                       port.has_levels ? ", with levels" : "", port.is_visited_once ? to_text(port.access) + ", each texel once" : to_text(port.access),
                       port.is_optional ? ", optional" : "");
}

std::string output_line(const OutputPort& port)
{
    std::string size;
    if (port.texels)
        size = fmt::format("{}x{} texels", (*port.texels)[0], (*port.texels)[1]);
    else if (port.scale == Ratio{})
        size = port.size_of.empty() ? "" : fmt::format("the extent of {}", port.size_of);
    else
        size = fmt::format("{}/{} of {}", port.scale.p, port.scale.q, port.size_of.empty() ? "the largest input" : port.size_of);
    return fmt::format("  {}  {}{}{}\n", port.name, info(port.signal).name, size.empty() ? "" : ", ", size);
}

std::string param_line(const Param& param)
{
    return fmt::format("  {}  {} = {}{}{}{}{}{}\n", param.name, name(param.type), value_text(param), range_text(param),
                       param.unit.empty() ? "" : " " + param.unit, param.is_logarithmic ? ", logarithmic" : "",
                       param.is_static ? ", static" : "", param.label.empty() ? "" : "; " + param.label);
}

std::string_view kind_text(Selection::Kind kind)
{
    switch (kind) {
    case Selection::Kind::choice: return "choice";
    case Selection::Kind::ladder: return "ladder";
    case Selection::Kind::layout: return "layout";
    }
    return "";
}

} // namespace

std::string pass_entry(const PassDeclaration& pass)
{
    std::vector<std::string> inputs;
    for (const InputPort& port : pass.inputs)
        inputs.push_back(fmt::format("{}: {}", port.name, signal_text(port)));
    std::vector<std::string> outputs;
    for (const OutputPort& port : pass.outputs)
        outputs.push_back(fmt::format("{}: {}", port.name, info(port.signal).name));
    std::string text = fmt::format("  {}\n      {}\n      {} -> {}\n", pass.name, pass.summary,
                                   inputs.empty() ? "()" : fmt::format("{}", fmt::join(inputs, ", ")), fmt::join(outputs, ", "));
    std::vector<std::string> settings;
    for (const Param& param : pass.params)
        settings.push_back(fmt::format("{}={}", param.name, value_text(param)));
    for (const Selection& selection : pass.selections)
        settings.push_back(fmt::format("{}={} ({}: {})", selection.name, default_item(selection), kind_text(selection.kind),
                                       fmt::join(selection.items, " ")));
    if (!settings.empty())
        text += fmt::format("      {}\n", fmt::join(settings, "  "));
    return text;
}

/// What the pass promises, a line each.
std::string contract_lines(const Contract& contract)
{
    if (!contract.is_stated)
        return "";
    std::string text = contract.non_finite == Contract::NonFinite::replaced ? "contract non-finite values are replaced\n"
                       : !contract.within ? "contract non-finite values reach no further than the pass reads\n"
                                                 : fmt::format("contract non-finite values reach {} texels\n", contract.within->text());
    for (const Contract::Span& span : contract.domain)
        text += fmt::format("  {}  from {} to {}\n", span.port, span.lowest, span.highest);
    for (const Contract::Span& span : contract.range)
        text += fmt::format("  {}  from {} to {}{}\n", span.port, span.lowest, span.highest,
                            span.is_saturated ? ", cut off there" : "");
    for (const Law law : contract.laws)
        text += fmt::format("  {}: {}\n", name(law), meaning(law));
    return text;
}

std::string pass_page(const PassDeclaration& pass)
{
    std::string text = fmt::format("{}: {}\n", pass.name, pass.summary);
    text += fmt::format("family   {}\nkind     {}\nsource   {}\nfile     {}\n", pass.family,
                        pass.composite ? "composite" : pass.kind == PassKind::geometry ? "geometry" : "image", pass.source, pass.file);
    for (const Identity& identity : pass.identities)
        text += fmt::format("identity is {} when {}\n", identity.is, identity.when.text());
    for (const std::string& fact : pass.needs)
        text += fmt::format("needs {}\n", fact);
    for (const OutputPort& output : pass.outputs)
        if (output.bound)
            text += fmt::format("bound {} is at most {}\n", output.name, output.bound->text());
    for (const InputPort& input : pass.inputs)
        if (input.ignored_when)
            text += fmt::format("ignores {} when {}\n", input.name, input.ignored_when->text());
    for (size_t output = 0; output < pass.black.size(); ++output) {
        std::vector<std::string> inputs;
        for (const int input : pass.black[output])
            inputs.push_back(pass.inputs[static_cast<size_t>(input)].name);
        if (!inputs.empty())
            text += fmt::format("black    {} when {} {}\n", pass.outputs[output].name, fmt::join(inputs, " and "),
                                inputs.size() > 1 ? "are" : "is");
    }
    if (!pass.skip_when.empty())
        text += fmt::format("skipped  where {}\n", pass.skip_when);
    text += contract_lines(pass.contract);
    if (!pass.inputs.empty())
        text += "inputs\n";
    for (const InputPort& port : pass.inputs)
        text += input_line(port);
    text += "outputs\n";
    for (const OutputPort& port : pass.outputs)
        text += output_line(port);
    if (!pass.params.empty())
        text += "parameters\n";
    for (const Param& param : pass.params)
        text += param_line(param);
    if (!pass.selections.empty())
        text += "selections\n";
    for (const Selection& selection : pass.selections)
        text += fmt::format("  {}  {} = {}; items: {}\n", selection.name, kind_text(selection.kind), default_item(selection),
                            fmt::join(selection.items, ", "));
    for (const Layout& layout : pass.layouts) {
        text += fmt::format("layout {}\n", layout.name);
        for (const Layout::Output& output : layout.outputs)
            text += fmt::format("  {}  {}\n", output.output, to_text(layout, output));
    }
    return text;
}

} // namespace passgraph::tool
