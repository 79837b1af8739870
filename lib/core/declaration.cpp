// Small look-ups on pass declarations, and the library that holds them.
#include "passgraph/core/declaration.hpp"

#include <array>

#include <fmt/format.h>

#include "passgraph/core/pass_library.hpp"

namespace passgraph {
namespace {

template <class Items>
int index_of(const Items& items, std::string_view wanted)
{
    for (size_t i = 0; i < items.size(); ++i)
        if (items[i].name == wanted)
            return static_cast<int>(i);
    return -1;
}

} // namespace

std::string_view name(ParamType type)
{
    static constexpr std::array<std::string_view, 8> kNames = {"float", "int",  "bool", "enum",
                                                               "color", "vec2", "vec3", "vec4"};
    return kNames[static_cast<size_t>(type)];
}

int component_count(ParamType type)
{
    switch (type) {
    case ParamType::color:
    case ParamType::vec3:
        return 3;
    case ParamType::vec2:
        return 2;
    case ParamType::vec4:
        return 4;
    default:
        return 1;
    }
}

std::string to_text(const Access& access)
{
    switch (access.kind) {
    case AccessClass::size_only:
        return "size only";
    case AccessClass::pointwise:
        return "pointwise";
    case AccessClass::warp:
        return "warp";
    case AccessClass::gather:
        break;
    }
    return access.radius == Access::kUnknownRadius ? "gather(radius unknown)"
                                                   : fmt::format("gather({})", access.radius);
}

int PassDeclaration::find_input(std::string_view wanted) const { return index_of(inputs, wanted); }
int PassDeclaration::find_output(std::string_view wanted) const { return index_of(outputs, wanted); }
int PassDeclaration::find_param(std::string_view wanted) const { return index_of(params, wanted); }
int PassDeclaration::find_selection(std::string_view wanted) const { return index_of(selections, wanted); }

const std::vector<int>& PassDeclaration::black_inputs(int output) const
{
    static const std::vector<int> none;
    return static_cast<size_t>(output) < black.size() ? black[static_cast<size_t>(output)] : none;
}

const Layout::Output* Layout::find(std::string_view wanted) const
{
    for (const Output& entry : outputs)
        if (entry.output == wanted)
            return &entry;
    return nullptr;
}

Filter filter_of(const PassDeclaration& pass, const InputPort& port, const std::vector<int>& selections)
{
    const int by = port.filter_by.empty() ? -1 : pass.find_selection(port.filter_by);
    if (by < 0)
        return port.filter;
    const auto& items = pass.selections[static_cast<size_t>(by)].items;
    const std::string& item = items[static_cast<size_t>(selections[static_cast<size_t>(by)])];
    for (const auto& [name, filter] : port.filter_of_item)
        if (name == item)
            return filter;
    return port.filter;
}

std::string to_text(const Layout& layout, const Layout::Output& output)
{
    if (!output.derived_from.empty())
        return "from " + output.derived_from;
    std::string text;
    for (const Layout::Place& place : output.places)
        text += fmt::format("{}{}.{}", text.empty() ? "" : ", ", layout.targets[static_cast<size_t>(place.target)].name,
                            place.channels);
    return fmt::format("{} : {}", text, output.codec.name);
}

void PassLibrary::add(PassPtr pass) { passes_[pass->name] = std::move(pass); }

PassPtr PassLibrary::find(std::string_view name) const
{
    const auto found = passes_.find(name);
    return found == passes_.end() ? nullptr : found->second;
}

std::vector<std::string> PassLibrary::names() const
{
    std::vector<std::string> all;
    for (const auto& [name, pass] : passes_)
        all.push_back(name);
    return all;
}

std::optional<Formula::Number> find_setting(const PassDeclaration& pass, const std::vector<Value>& params,
                                            const std::vector<int>& selections, std::string_view name)
{
    const auto item_of = [&](const auto& owner) -> std::optional<Formula::Number> {
        for (size_t item = 0; item < owner.items.size(); ++item)
            if (name == owner.name + "_" + owner.items[item])
                return Formula::Number{{static_cast<double>(item)}, 1};
        return std::nullopt;
    };
    for (size_t i = 0; i < pass.params.size(); ++i) {
        if (pass.params[i].name == name)
            return Formula::Number{params[i].v, component_count(pass.params[i].type)};
        if (const auto item = item_of(pass.params[i]))
            return item;
    }
    for (size_t i = 0; i < pass.selections.size(); ++i) {
        if (pass.selections[i].name == name)
            return Formula::Number{{static_cast<double>(selections[i])}, 1};
        if (const auto item = item_of(pass.selections[i]))
            return item;
    }
    return std::nullopt;
}

std::vector<std::string> formula_names(const PassDeclaration& pass)
{
    std::vector<std::string> names;
    const auto add = [&](const auto& owner) {
        names.push_back(owner.name);
        for (const std::string& item : owner.items)
            names.push_back(owner.name + "_" + item);
    };
    for (const Param& param : pass.params)
        add(param);
    for (const Selection& selection : pass.selections)
        add(selection);
    return names;
}

} // namespace passgraph
