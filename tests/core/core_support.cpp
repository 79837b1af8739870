// Texts with marked places, passes declared by hand.
#include "core_support.hpp"

#include <fmt/format.h>
#include <passgraph/core/pass_header.hpp>

#include "support/catch.hpp"

namespace passgraph::test {

MarkedText marked(std::string_view text)
{
    MarkedText result;
    int line = 1;
    int column = 1;
    for (const char c : text) {
        if (c == '@') {
            result.places.push_back({"", line, column});
            continue;
        }
        result.text += c;
        line += c == '\n' ? 1 : 0;
        column = c == '\n' ? 1 : column + 1;
    }
    return result;
}

std::string codes_of(const Errors& errors)
{
    std::string text;
    for (const Error& error : errors)
        text += fmt::format("{} {}:{}\n", error.code, error.where.line, error.where.column);
    return text;
}

std::string codes_at(const MarkedText& text, const std::vector<std::string>& codes)
{
    REQUIRE(text.places.size() == codes.size());
    std::string expected;
    for (size_t i = 0; i < codes.size(); ++i)
        expected += fmt::format("{} {}:{}\n", codes[i], text.places[i].line, text.places[i].column);
    return expected;
}

PassMaker::PassMaker(const std::string& name)
{
    pass.name = name;
    pass.file = name + ".glsl";
    pass.body.file = pass.file;
    pass.body.globals = {name};
}

PassMaker& PassMaker::input(const std::string& name, Access access, Signal signal)
{
    InputPort port;
    port.name = name;
    port.signal = signal;
    port.access = access;
    pass.inputs.push_back(port);
    return *this;
}

PassMaker& PassMaker::output(const std::string& name, Signal signal, Ratio scale)
{
    OutputPort port;
    port.name = name;
    port.signal = signal;
    port.scale = scale;
    pass.outputs.push_back(port);
    return *this;
}

PassMaker& PassMaker::body(const std::string& text)
{
    pass.body.text = text;
    return *this;
}

PassDeclaration read_pass(const std::string& text)
{
    const auto pass = read_pass_header(text, "pass.glsl", "test", [](std::string_view) { return std::nullopt; });
    if (!pass)
        FAIL(to_text(pass.error()));
    return *pass;
}

Plan planned(const Graph& graph, const CompileOptions& options)
{
    const auto plan = compile(graph, options);
    if (!plan)
        FAIL(to_text(plan.error()));
    return *plan;
}

} // namespace passgraph::test
