// Reads what a header says about blackness: which inputs hand it on, and where a pixel is black for sure.
//
//   "black": ["image"]                                       every output is exactly 0 everywhere when all of these are
//   "black": { "emissive": ["atlas_emissive"] }              the same by output
//   "skip": { "when": "luminance(image(uv)) <= limit", "value": 0 }   the only output is 0 at pixels where this holds
#include <algorithm>

#include <fmt/format.h>

#include "core/pass/glsl_scan.hpp"
#include "core/pass/header_fields.hpp"

namespace passgraph::header {
namespace {

template <class Ports>
void report_unknown(const std::string& name, const Ports& ports, std::string_view what, const Location& where, Errors& errors)
{
    std::vector<std::string> names;
    for (const auto& port : ports)
        names.push_back(port.name);
    errors.push_back({fmt::format("unknown_{}", what), fmt::format("there is no {} `{}`", what, name),
                      suggest(name, names, fmt::format("{}s", what)), where});
}

std::vector<int> read_black_inputs(const Json& list, const PassDeclaration& pass, Errors& errors)
{
    std::vector<int> inputs;
    if (!list.is(Json::Kind::array) || list.array.empty()) {
        report_wrong_type(list, "\"black\"", "a list of inputs", errors);
        return inputs;
    }
    for (const Json& entry : list.array) {
        if (!entry.is(Json::Kind::string)) {
            report_wrong_type(entry, "\"black\"", "names of inputs", errors);
            continue;
        }
        const int input = pass.find_input(entry.string);
        if (input < 0)
            report_unknown(entry.string, pass.inputs, "input", entry.where, errors);
        else if (pass.inputs[static_cast<size_t>(input)].over == Over::scene)
            errors.push_back({"black_mismatch", fmt::format("`{}` is a scene, which is never black", entry.string),
                              "name inputs that are pictures, cube maps or tables", entry.where});
        else if (std::find(inputs.begin(), inputs.end(), input) != inputs.end())
            errors.push_back({"duplicate_name", fmt::format("`{}` is named twice", entry.string), "once is enough", entry.where});
        else
            inputs.push_back(input);
    }
    return inputs;
}

} // namespace

void read_black(const Json& black, PassDeclaration& pass, Errors& errors)
{
    if (!black.is(Json::Kind::object)) {
        pass.black.assign(pass.outputs.size(), read_black_inputs(black, pass, errors));
        return;
    }
    pass.black.assign(pass.outputs.size(), {});
    for (const Json::Member& member : black.members) {
        const int output = pass.find_output(member.key);
        if (output < 0)
            report_unknown(member.key, pass.outputs, "output", member.where, errors);
        else
            pass.black[static_cast<size_t>(output)] = read_black_inputs(member.value, pass, errors);
    }
}

void read_skip(const Json& skip, PassDeclaration& pass, Errors& errors)
{
    if (pass.kind == PassKind::geometry || pass.outputs.size() > 1)
        errors.push_back({"skip_mismatch",
                          pass.kind == PassKind::geometry ? "a geometry pass is no function of one pixel"
                                                          : fmt::format("the pass has {} outputs", pass.outputs.size()),
                          "\"skip\" is for a full-screen pass of one output", skip.where});
    JsonFields fields(skip, "\"skip\"", errors);
    if (const Json* when = fields.require("when", Json::Kind::string)) {
        pass.skip_when = when->string;
        pass.skip_where = when->where;
        report_forbidden(scan_glsl(when->string, when->where.line, when->where.column + 1), pass.file, false, errors);
        if (when->string.find_first_not_of(" \t\r\n") == std::string::npos)
            report_wrong_type(*when, "\"when\"", "a GLSL condition of inputs at uv and parameters", errors);
    }
    if (const Json* value = fields.require("value", Json::Kind::number); value && value->number != 0.0)
        errors.push_back({"skip_mismatch", fmt::format("a skipped pixel is 0, not {}", value->number),
                          "write \"value\": 0", value->where});
    fields.finish();
}

} // namespace passgraph::header
