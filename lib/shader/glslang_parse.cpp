// Parses GLSL with glslang and keeps the syntax tree.
#include "shader/glslang_parse.hpp"

#include <charconv>
#include <sstream>

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>

namespace passgraph::shader {
namespace {

void initialise_once()
{
    // Never finalised: passes may be loaded until the program ends.
    static const bool is_ready = glslang::InitializeProcess();
    static_cast<void>(is_ready);
}

int to_int(const std::string& text)
{
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// glslang writes "ERROR: SOURCE:LINE: 'token' : what"; its summary lines say less.
Errors errors_of(const std::string& log, const std::vector<std::string>& sources)
{
    Errors errors;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("ERROR: "))
            continue;
        const std::string rest = line.substr(7);
        const size_t first = rest.find(':');
        const size_t second = first == std::string::npos ? first : rest.find(':', first + 1);
        if (second == std::string::npos || rest.find_first_not_of("0123456789") != first)
            continue;
        const size_t source = static_cast<size_t>(to_int(rest.substr(0, first)));
        std::string message = rest.substr(second + 1);
        message.erase(0, message.find_first_not_of(' '));
        if (message.find("compilation terminated") != std::string::npos)
            continue;
        const Location where{source < sources.size() ? sources[source] : "generated",
                             to_int(rest.substr(first + 1, second - first - 1)), 0};
        // What follows on the same line follows from its first mistake.
        if (errors.empty() || errors.back().where != where)
            errors.push_back({"glsl_error", std::move(message), "", where});
    }
    if (errors.empty())
        errors.push_back({"glsl_error", "glslang refused the text", log});
    return errors;
}

} // namespace

Result<ParsedShader> ParsedShader::parse(const std::string& text, const std::vector<std::string>& sources)
{
    initialise_once();
    constexpr int kVersion = 330;
    ParsedShader parsed;
    parsed.shader_ = std::make_shared<glslang::TShader>(EShLangFragment);
    const char* strings[] = {text.c_str()};
    parsed.shader_->setStrings(strings, 1);
    if (!parsed.shader_->parse(GetDefaultResources(), kVersion, ECoreProfile, false, false, EShMsgCascadingErrors))
        return tl::unexpected(errors_of(parsed.shader_->getInfoLog(), sources));
    return parsed;
}

TIntermNode* ParsedShader::root() const { return shader_->getIntermediate()->getTreeRoot(); }

} // namespace passgraph::shader
