// A pass's declaration as a JSON object.
#include <cmath>
#include <string_view>

#include <passgraph/core/json_value.hpp>

#include "tool/pass_pages.hpp"

namespace passgraph::tool {
namespace {

using Object = JsonValue;

constexpr std::string_view kWraps[] = {"clamp", "mirror", "repeat"};
constexpr std::string_view kOvers[] = {"image", "sphere", "table", "scene"};

Object numbers_json(const Value& value, int components)
{
    if (components == 1)
        return value.v[0];
    return std::vector<double>(value.v.begin(), value.v.begin() + components);
}

Object bound_json(double bound) { return std::isfinite(bound) ? Object(bound) : Object(nullptr); }

std::string text_of(const std::optional<Formula>& formula) { return formula ? formula->text() : ""; }

Object input_json(const InputPort& port)
{
    Object json = {{"name", port.name}, {"over", kOvers[static_cast<size_t>(port.over)]}};
    if (port.over == Over::scene)
        return json;
    json["signal"] = info(port.signal).name;
    json["filter"] = port.filter == Filter::linear ? "linear" : "nearest";
    json["wrap"] = kWraps[static_cast<size_t>(port.wrap)];
    json["levels"] = port.has_levels;
    json["once"] = port.is_visited_once;
    json["optional"] = port.is_optional;
    json["default"] = port.is_optional ? numbers_json(port.default_value, info(port.signal).components) : Object(nullptr);
    json["access"] = to_text(port.access);
    json["ignored_when"] = text_of(port.ignored_when);
    return json;
}

Object output_json(const OutputPort& port)
{
    Object json = {{"name", port.name}, {"signal", info(port.signal).name}};
    json["size"] = port.texels ? Object{{"texels", *port.texels}}
                               : Object{{"of", port.size_of}, {"scale", Object::array({port.scale.p, port.scale.q})}};
    json["bound"] = text_of(port.bound);
    return json;
}

Object param_json(const Param& param)
{
    Object json = {{"name", param.name}, {"type", name(param.type)}};
    json["default"] = numbers_json(param.default_value, component_count(param.type));
    if (param.type == ParamType::bool_)
        json["default"] = param.default_value.v[0] != 0.0;
    if (param.type == ParamType::enum_) {
        json["default"] = param.items.at(static_cast<size_t>(param.default_value.v[0]));
        json["items"] = param.items;
    }
    json["range"] = Object::array({bound_json(param.lowest), bound_json(param.highest)});
    json["step"] = param.step;
    json["scale"] = param.is_logarithmic ? "log" : "linear";
    json["static"] = param.is_static;
    json["unit"] = param.unit;
    json["label"] = param.label;
    json["group"] = param.group;
    json["visible_if"] = text_of(param.visible_if);
    return json;
}

/// null, one, or an array of several.
Object identity_json(const std::vector<Identity>& identities)
{
    Object json = Object::array();
    for (const Identity& identity : identities)
        json.push_back({{"when", identity.when.text()}, {"is", identity.is}});
    return identities.empty() ? Object(nullptr) : identities.size() == 1 ? json.front() : json;
}

Object layout_json(const Layout& layout)
{
    Object targets = Object::object();
    for (const Layout::Target& target : layout.targets)
        targets[target.name] = passgraph::name(target.format);
    Object outputs = Object::object();
    for (const Layout::Output& output : layout.outputs)
        outputs[output.output] = to_text(layout, output);
    return {{"name", layout.name}, {"targets", targets}, {"outputs", outputs}};
}

Object spans_json(const std::vector<Contract::Span>& spans)
{
    Object json = Object::object();
    for (const Contract::Span& span : spans)
        json[span.port] = Object::array({span.lowest, span.is_saturated ? Object("saturated") : Object(span.highest)});
    return json;
}

Object black_json(const PassDeclaration& pass)
{
    Object json = Object::object();
    for (size_t output = 0; output < pass.black.size(); ++output)
        for (const int input : pass.black[output])
            json[pass.outputs[output].name].push_back(pass.inputs[static_cast<size_t>(input)].name);
    return json;
}

Object contract_json(const Contract& contract)
{
    if (!contract.is_stated)
        return nullptr;
    Object laws = Object::array();
    for (const Law law : contract.laws)
        laws.push_back(name(law));
    Object json = {{"domain", spans_json(contract.domain)}, {"range", spans_json(contract.range)}};
    json["non_finite"] = contract.non_finite == Contract::NonFinite::replaced ? "replaced" : "contained";
    json["within"] = text_of(contract.within);
    json["anywhere"] = contract.anywhere;
    json["laws"] = laws;
    return json;
}

Object object_of(const PassDeclaration& pass)
{
    Object json = {{"name", pass.name},
                   {"family", pass.family},
                   {"summary", pass.summary},
                   {"kind", pass.composite ? "composite" : pass.kind == PassKind::geometry ? "geometry" : "image"},
                   {"source", pass.source},
                   {"file", pass.file}};
    for (const char* list : {"reads", "inputs", "outputs", "params", "choices", "ladders", "layouts"})
        json[list] = Object::array();
    for (const ReadRow& row : kReads)
        if (pass.reads.*row.member)
            json["reads"].push_back(row.name);
    for (const InputPort& port : pass.inputs)
        json["inputs"].push_back(input_json(port));
    for (const OutputPort& port : pass.outputs)
        json["outputs"].push_back(output_json(port));
    for (const Param& param : pass.params)
        json["params"].push_back(param_json(param));
    for (const Selection& selection : pass.selections) {
        // The selection called `layout` is a choice between the rows of "layouts".
        const char* list = selection.kind == Selection::Kind::ladder ? "ladders" : "choices";
        json[list].push_back({{"name", selection.name},
                              {"items", selection.items},
                              {"default", selection.items.at(static_cast<size_t>(selection.default_item))}});
        if (!selection.reference.empty())
            json[list].back()["reference"] = selection.reference;
    }
    for (const Layout& layout : pass.layouts)
        json["layouts"].push_back(layout_json(layout));
    json["identity"] = identity_json(pass.identities);
    json["needs"] = pass.needs;
    json["black"] = black_json(pass);
    json["skip"] = pass.skip_when.empty() ? Object(nullptr) : Object{{"when", pass.skip_when}, {"value", 0}};
    json["contract"] = contract_json(pass.contract);
    return json;
}

} // namespace

std::string pass_json(const PassDeclaration& pass)
{
    Object json = {{"passgraph", 1}};
    json.update(object_of(pass));
    return json.text(2);
}

std::string passes_json(const PassLibrary& library)
{
    Object json = {{"passgraph", 1}, {"passes", Object::array()}};
    for (const auto& [name, pass] : library.passes())
        json["passes"].push_back(object_of(*pass));
    return json.text(2);
}

} // namespace passgraph::tool
