// Writes the C++ struct of a pass: its parameters as members, its ports as typed images.
#include "shader/bake/cpp_struct.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace passgraph::bake {
namespace {

std::string pascal_case(std::string_view name)
{
    std::string result;
    bool is_start = true;
    for (const char c : name) {
        if (c == '_') {
            is_start = true;
            continue;
        }
        result += is_start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        is_start = false;
    }
    return result;
}

std::string tag_of(Signal signal)
{
    if (signal == Signal::color)
        return "SignalTag"; // the struct's own template parameter
    return signal == Signal::material ? "MaterialSignal" : pascal_case(info(signal).name);
}

bool is_generic(const PassDeclaration& pass)
{
    const auto generic = [](const auto& port) { return port.signal == Signal::color; };
    return std::any_of(pass.inputs.begin(), pass.inputs.end(), generic) ||
           std::any_of(pass.outputs.begin(), pass.outputs.end(), generic);
}

std::string port_type(const InputPort& port)
{
    if (port.over == Over::scene)
        return "SceneInput";
    if (port.over == Over::table)
        return port.is_optional ? "std::optional<AnyImage>" : "AnyImage";
    const std::string image = fmt::format("{}<{}>", port.over == Over::sphere ? "Cube" : "Image", tag_of(port.signal));
    return port.is_optional ? fmt::format("std::optional<{}>", image) : image;
}

std::string enumerator(const std::string& owner, const std::string& item)
{
    return std::isdigit(static_cast<unsigned char>(item.front())) ? owner + "_" + item : item;
}

std::string enum_text(const std::string& name, const std::vector<std::string>& items)
{
    std::string text = fmt::format("    enum class {} {{", pascal_case(name));
    for (size_t i = 0; i < items.size(); ++i)
        text += fmt::format("{} {}", i > 0 ? "," : "", enumerator(name, items[i]));
    return text + " };\n";
}

std::string number_text(double number) { return fmt::format("{:#}f", static_cast<float>(number)); }

std::string member_text(const Param& param)
{
    switch (param.type) {
    case ParamType::bool_:
        return fmt::format("bool {} = {};", param.name, param.default_value.v[0] != 0.0);
    case ParamType::int_:
        return fmt::format("int {} = {};", param.name, static_cast<int>(param.default_value.v[0]));
    case ParamType::float_:
        return fmt::format("float {} = {};", param.name, number_text(param.default_value.v[0]));
    case ParamType::enum_:
        return fmt::format("{} {} = {}::{};", pascal_case(param.name), param.name, pascal_case(param.name),
                           enumerator(param.name, param.items[static_cast<size_t>(param.default_value.v[0])]));
    default:
        break;
    }
    std::string text = fmt::format("Vec{} {} = {{", component_count(param.type), param.name);
    for (int i = 0; i < component_count(param.type); ++i)
        text += fmt::format("{}{}", i > 0 ? ", " : "", number_text(param.default_value.v[static_cast<size_t>(i)]));
    return text + "};";
}

std::string comment_of(const Param& param)
{
    std::string text = param.label;
    if (std::isfinite(param.lowest) && std::isfinite(param.highest))
        text += fmt::format("{}in [{}, {}]", text.empty() ? "" : ", ", param.lowest, param.highest);
    if (!param.unit.empty())
        text += fmt::format("{}{}", text.empty() ? "" : ", ", param.unit);
    if (param.is_static)
        text += fmt::format("{}static", text.empty() ? "" : ", ");
    return text.empty() ? "" : " ///< " + text;
}

std::string setting_line(const Param& param)
{
    if (param.type == ParamType::enum_)
        return fmt::format("        settings.item(\"{}\", static_cast<int>({}), {{\"{}\"}});\n", param.name, param.name,
                           fmt::join(param.items, "\", \""));
    return fmt::format("        settings.value(\"{}\", {});\n", param.name, param.name);
}

std::string inputs_text(const PassDeclaration& pass)
{
    std::string members;
    std::string wires;
    for (const InputPort& port : pass.inputs) {
        members += fmt::format("        {} {}{};\n", port_type(port), port.name, port.is_optional ? "{}" : "");
        if (port.over == Over::scene)
            wires +=
                fmt::format("            arguments.inputs.push_back({{\"{}\", {}.elements}});\n", port.name, port.name);
        else if (port.is_optional)
            wires += fmt::format("            if ({})\n                arguments.inputs.push_back({{\"{}\", *{}}});\n",
                                 port.name, port.name, port.name);
        else
            wires += fmt::format("            arguments.inputs.push_back({{\"{}\", {}}});\n", port.name, port.name);
    }
    return fmt::format("    struct Inputs {{\n{}        void append_to([[maybe_unused]] PassArguments& arguments) "
                       "const\n        {{\n{}        }}\n    }};\n",
                       members, wires);
}

std::string outputs_text(const PassDeclaration& pass)
{
    std::string members;
    std::string values;
    for (const OutputPort& port : pass.outputs) {
        members += fmt::format("        Image<{}> {};\n", tag_of(port.signal), port.name);
        values += fmt::format("{}Graph::typed<{}>(added[\"{}\"])", values.empty() ? "" : ", ", tag_of(port.signal),
                              port.name);
    }
    return fmt::format(
        "    struct Outputs {{\n{}        static Outputs from(const AddedPass& added) {{ return {{{}}}; }}\n    }};\n",
        members, values);
}

} // namespace

std::string cpp_struct(const PassDeclaration& pass)
{
    std::string text = fmt::format("/// {}\n", pass.summary.empty() ? pass.name : pass.summary);
    if (!pass.source.empty())
        text += fmt::format("///\n/// Source   {}\n", pass.source);
    if (is_generic(pass))
        text += "template <class SignalTag = Radiance>\n";
    text += fmt::format("struct {} {{\n    static constexpr const char* name = \"{}\";\n", pascal_case(pass.name),
                        pass.name);
    std::string members;
    std::string settings;
    for (const Param& param : pass.params) {
        if (param.type == ParamType::enum_)
            text += enum_text(param.name, param.items);
        members += fmt::format("    {}{}\n", member_text(param), comment_of(param));
        settings += setting_line(param);
    }
    for (const Selection& selection : pass.selections) {
        text += enum_text(selection.name, selection.items);
        members +=
            fmt::format("    {0} {1} = {0}::{2};\n", pascal_case(selection.name), selection.name,
                        enumerator(selection.name, selection.items[static_cast<size_t>(selection.default_item)]));
        settings += fmt::format("        settings.item(\"{}\", static_cast<int>({}), {{\"{}\"}});\n", selection.name,
                                selection.name, fmt::join(selection.items, "\", \""));
    }
    text += "\n" + members + "\n" + inputs_text(pass) + outputs_text(pass);
    text += fmt::format("    PassArguments arguments() const\n    {{\n        Settings settings;\n{}        return "
                        "settings.take();\n    }}\n}};\n",
                        settings);
    return text;
}

} // namespace passgraph::bake
