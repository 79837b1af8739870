// Parameters as GLSL: their types and values.
#include <fmt/format.h>

#include "core/glsl/assemble.hpp"

namespace passgraph::glsl {

std::string_view glsl_type_of(ParamType type)
{
    switch (type) {
    case ParamType::float_:
        return "float";
    case ParamType::int_:
    case ParamType::enum_:
        return "int";
    case ParamType::bool_:
        return "bool";
    case ParamType::vec2:
        return "vec2";
    case ParamType::color:
    case ParamType::vec3:
        return "vec3";
    case ParamType::vec4:
        return "vec4";
    }
    return "float";
}

std::string literal(ParamType type, const Value& value)
{
    switch (type) {
    case ParamType::bool_:
        return value.v[0] != 0.0 ? "true" : "false";
    case ParamType::int_:
    case ParamType::enum_:
        return std::to_string(static_cast<long long>(value.v[0]));
    case ParamType::float_:
        return fmt::format("{:#}", static_cast<float>(value.v[0]));
    default:
        break;
    }
    std::string text = std::string(glsl_type_of(type)) + "(";
    for (int i = 0; i < component_count(type); ++i)
        text += fmt::format("{}{:#}", i > 0 ? ", " : "", static_cast<float>(value.v[static_cast<size_t>(i)]));
    return text + ")";
}

} // namespace passgraph::glsl
