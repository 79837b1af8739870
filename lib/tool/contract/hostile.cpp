// Writes hostile versions of GLSL builtins in front of a shader, and macros that lead to them.
#include "tool/contract/hostile.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace passgraph::tool::contract {
namespace {

/// A builtin of one to three floats. `is_bad` says where GLSL leaves its result undefined; NaN arguments come on top where
/// the driver's answer to them is undefined too. `scalars` marks the arguments that may be floats beside vectors.
struct Builtin {
    const char* name;
    const char* arguments; ///< "xy": one letter each
    const char* is_bad;
    const char* scalars; ///< letters of those that may be scalar, all at once
    bool has_integers;
    const char* when;
    bool passes_on_nan = true; ///< what it makes of NaN is NaN everywhere; false: what it makes of it is the driver's choice
};

constexpr std::array<Builtin, 17> kBuiltins = {{
    {"smoothstep", "xyz", "!(x < y)", "xy", false, "its first edge is not below its second, or an argument is NaN"},
    {"pow", "xy", "x < 0.0 || (x == 0.0 && y <= 0.0)", "", false, "its base is negative, or 0 with an exponent of 0 or less"},
    {"sqrt", "x", "x < 0.0", "", false, "its argument is negative"},
    {"inversesqrt", "x", "x <= 0.0", "", false, "its argument is 0 or negative"},
    {"log", "x", "x <= 0.0", "", false, "its argument is 0 or negative"},
    {"log2", "x", "x <= 0.0", "", false, "its argument is 0 or negative"},
    {"acos", "x", "abs(x) > 1.0", "", false, "its argument is beyond 1, which rounding suffices for"},
    {"asin", "x", "abs(x) > 1.0", "", false, "its argument is beyond 1, which rounding suffices for"},
    {"atan", "yx", "x == 0.0 && y == 0.0", "", false, "both of its arguments are 0"},
    {"acosh", "x", "x < 1.0", "", false, "its argument is below 1"},
    {"atanh", "x", "abs(x) >= 1.0", "", false, "its argument is 1 or beyond"},
    {"mod", "xy", "y == 0.0", "y", false, "its divisor is 0"},
    {"min", "xy", "false", "y", true, "an argument is NaN", false},
    {"max", "xy", "false", "y", true, "an argument is NaN", false},
    {"clamp", "xyz", "y > z", "yz", true, "an argument is NaN, or the lower bound is above the upper", false},
    {"sign", "x", "false", "", true, "its argument is NaN", false},
    {"step", "xy", "false", "x", false, "an argument is NaN", false},
}};

constexpr const char* kNormalizeWhen = "its vector is 0, not finite, or so short or long that its squares leave binary32";

constexpr const char* kShared = R"(
bool passgraph_is_nan(float x) { return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u; }
float passgraph_nan() { return uintBitsToFloat(0x7fc00000u); }
)";

constexpr const char* kHasDirection = R"(
bool passgraph_has_direction(float squared) { return squared >= 1.17549435e-38 && squared <= 3.40282347e+38; }
)";

std::string normalize_versions(bool is_forgiving)
{
    std::string text = kHasDirection;
    for (const std::string_view type : {"float", "vec2", "vec3", "vec4"})
        text += fmt::format("{0} passgraph_hostile_normalize({0} v) {{ return passgraph_has_direction(dot(v, v)) ? normalize(v) : {0}({1}); }}\n",
                            type, is_forgiving ? "0.0" : "passgraph_nan()");
    return text;
}

bool has(std::string_view letters, char letter) { return letters.find(letter) != std::string_view::npos; }

/// "float x, float y" with the types that `type_of` gives each argument.
template <class TypeOf>
std::string parameters(const Builtin& builtin, const TypeOf& type_of)
{
    std::string text;
    for (const char letter : std::string_view(builtin.arguments))
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", type_of(letter), letter);
    return text;
}

std::string scalar_version(const Builtin& builtin, bool is_forgiving)
{
    std::string is_nan;
    std::string call;
    for (const char letter : std::string_view(builtin.arguments)) {
        is_nan += fmt::format("{}passgraph_is_nan({})", is_nan.empty() ? "" : " || ", letter);
        call += fmt::format("{}{}", call.empty() ? "" : ", ", letter);
    }
    return fmt::format("float passgraph_hostile_{0}({1})\n{{\n    if ({2})\n        return {3};\n    return {4} ? {5} : {0}({6});\n}}\n",
                       builtin.name, parameters(builtin, [](char) { return "float"; }), is_nan,
                       is_forgiving && !builtin.passes_on_nan ? "0.0" : "passgraph_nan()", builtin.is_bad,
                       is_forgiving ? "0.0" : "passgraph_nan()", call);
}

std::string vector_version(const Builtin& builtin, int width, bool with_scalars)
{
    static constexpr std::array<std::string_view, 4> kComponents = {"x", "y", "z", "w"};
    const auto is_scalar = [&](char letter) { return with_scalars && has(builtin.scalars, letter); };
    const std::string type = fmt::format("vec{}", width);
    std::string calls;
    for (int i = 0; i < width; ++i) {
        std::string arguments;
        for (const char letter : std::string_view(builtin.arguments))
            arguments += fmt::format("{}{}{}{}", arguments.empty() ? "" : ", ", letter, is_scalar(letter) ? "" : ".",
                                     is_scalar(letter) ? "" : kComponents[static_cast<size_t>(i)]);
        calls += fmt::format("{}passgraph_hostile_{}({})", i > 0 ? ", " : "", builtin.name, arguments);
    }
    return fmt::format("{0} passgraph_hostile_{1}({2}) {{ return {0}({3}); }}\n", type, builtin.name,
                       parameters(builtin, [&](char letter) { return is_scalar(letter) ? std::string("float") : type; }), calls);
}

/// Integers know no NaN: these only make the macro's name stand for them too.
std::string integer_versions(const Builtin& builtin)
{
    std::string text;
    for (const std::string_view scalar : {"int", "uint"}) {
        if (scalar == "uint" && std::string_view(builtin.name) == "sign")
            continue;
        for (int width = 1; width <= 4; ++width)
            for (const bool with_scalars : {false, true}) {
                if (with_scalars && (width == 1 || std::string_view(builtin.scalars).empty()))
                    continue;
                const std::string type =
                    width == 1 ? std::string(scalar) : fmt::format("{}vec{}", scalar == "int" ? "i" : "u", width);
                const auto type_of = [&](char letter) {
                    return with_scalars && has(builtin.scalars, letter) ? std::string(scalar) : type;
                };
                std::string call;
                for (const char letter : std::string_view(builtin.arguments))
                    call += fmt::format("{}{}", call.empty() ? "" : ", ", letter);
                text += fmt::format("{0} passgraph_hostile_{1}({2}) {{ return {1}({3}); }}\n", type, builtin.name,
                                    parameters(builtin, type_of), call);
            }
    }
    return text;
}

/// atan of one argument is defined everywhere: the macro's name stands for it too.
std::string one_argument_versions(const Builtin& builtin)
{
    std::string text;
    for (const std::string_view type : {"float", "vec2", "vec3", "vec4"})
        text += fmt::format("{0} passgraph_hostile_{1}({0} x) {{ return {1}(x); }}\n", type, builtin.name);
    return text;
}

std::string versions_of(const Builtin& builtin, bool is_forgiving)
{
    std::string text = scalar_version(builtin, is_forgiving);
    if (std::string_view(builtin.name) == "atan")
        text += one_argument_versions(builtin);
    for (int width = 2; width <= 4; ++width) {
        text += vector_version(builtin, width, false);
        if (!std::string_view(builtin.scalars).empty())
            text += vector_version(builtin, width, true);
    }
    return builtin.has_integers ? text + integer_versions(builtin) : text;
}

/// A constant may not be made by a function of one's own: where a hostile call makes it, it becomes a variable.
std::string with_variables_for_constants(const std::string& shader, const std::vector<std::string>& builtins)
{
    std::string text;
    for (size_t start = 0; start < shader.size();) {
        const size_t end = std::min(shader.find('\n', start), shader.size() - 1) + 1;
        std::string line = shader.substr(start, end - start);
        const size_t word = line.find_first_not_of(" \t");
        const bool is_made_by_call = std::any_of(builtins.begin(), builtins.end(), [&](const std::string& builtin) {
            return line.find(builtin + "(") != std::string::npos;
        });
        if (word != std::string::npos && is_made_by_call && line.compare(word, 6, "const ") == 0)
            line.erase(word, 6);
        text += line;
        start = end;
    }
    return text;
}

} // namespace

const std::vector<std::string>& hostile_builtins()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = {"normalize"};
        for (const Builtin& builtin : kBuiltins)
            all.emplace_back(builtin.name);
        return all;
    }();
    return names;
}

std::string_view undefined_when(std::string_view builtin)
{
    const auto row = std::find_if(kBuiltins.begin(), kBuiltins.end(), [&](const Builtin& b) { return b.name == builtin; });
    return row == kBuiltins.end() ? kNormalizeWhen : row->when;
}

std::string with_hostile(const std::string& shader, const std::vector<std::string>& builtins, std::string_view forgiving)
{
    const size_t body = shader.find('\n') + 1; // behind #version
    std::string text = shader.substr(0, body) + kShared;
    for (const std::string& name : builtins) {
        const auto row = std::find_if(kBuiltins.begin(), kBuiltins.end(), [&](const Builtin& b) { return b.name == name; });
        text += row == kBuiltins.end() ? normalize_versions(name == forgiving) : versions_of(*row, name == forgiving);
    }
    for (const std::string& name : builtins)
        text += fmt::format("#define {0} passgraph_hostile_{0}\n", name);
    return text + with_variables_for_constants(shader.substr(body), builtins);
}

std::string with_bound_removed(const std::string& shader, std::string_view builtin, int kept_argument)
{
    const size_t body = shader.find('\n') + 1;
    const bool has_two = builtin != "clamp";
    return shader.substr(0, body) +
           fmt::format("#define {}({}) ({})\n", builtin, has_two ? "a0, a1" : "a0, a1, a2", fmt::format("a{}", kept_argument)) +
           shader.substr(body);
}

} // namespace passgraph::tool::contract
