// What analysis derived from a pass, as JSON and back: a build bakes it, a start reads it.
#include <array>

#include "passgraph/core/json.hpp"
#include "passgraph/core/json_value.hpp"
#include "passgraph/core/pass_header.hpp"

namespace passgraph {
namespace {

constexpr std::array<std::pair<const char*, AccessClass>, 4> kClasses = {{{"size_only", AccessClass::size_only},
                                                                          {"pointwise", AccessClass::pointwise},
                                                                          {"warp", AccessClass::warp},
                                                                          {"gather", AccessClass::gather}}};

} // namespace

std::string derived_to_json(const PassDeclaration& pass)
{
    JsonValue json = JsonValue::object();
    for (const InputPort& port : pass.inputs)
        json[port.name] = {{"access", kClasses[static_cast<size_t>(port.access.kind)].first},
                           {"radius", port.access.radius}};
    return json.text();
}

Result<void> apply_derived(PassDeclaration& pass, std::string_view json)
{
    const auto root = parse_json(json, pass.file + " (derived)");
    if (!root)
        return tl::unexpected(root.error());
    Errors errors;
    for (InputPort& port : pass.inputs) {
        const Json* entry = root->find(port.name);
        if (!entry)
            continue;
        JsonFields fields(*entry, port.name, errors);
        const std::string word = fields.text("access", "gather");
        for (const auto& [name, kind] : kClasses)
            if (word == name)
                port.access.kind = kind;
        port.access.radius = static_cast<int>(fields.number("radius", Access::kUnknownRadius));
        fields.finish();
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

} // namespace passgraph
