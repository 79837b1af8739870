// Texts with marked places, passes declared by hand, and a library of both.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/compile.hpp>
#include <passgraph/core/declaration.hpp>
#include <passgraph/core/error.hpp>
#include <passgraph/core/pass_library.hpp>

namespace passgraph::test {

/// A text whose `@` signs mark places: they are taken out, and each leaves its line and column.
struct MarkedText {
    std::string text;
    std::vector<Location> places; ///< without a file
};
MarkedText marked(std::string_view text);

/// The mistakes as "code line:column", one per line, in the order they came.
std::string codes_of(const Errors& errors);
template <class T>
std::string codes_of(const Result<T>& result)
{
    return result ? "no error" : codes_of(result.error());
}
/// What `codes_of` gives for one error per mark.
std::string codes_at(const MarkedText& text, const std::vector<std::string>& codes);

/// A pass declared by hand.
struct PassMaker {
    PassDeclaration pass;

    explicit PassMaker(const std::string& name);
    PassMaker& input(const std::string& name, Access access, Signal signal = Signal::color);
    PassMaker& output(const std::string& name, Signal signal = Signal::color, Ratio scale = {});
    PassMaker& body(const std::string& text);
    PassPtr done() const { return std::make_shared<const PassDeclaration>(pass); }
};

/// Reads a pass file's text, with these common files; fails the test on an error.
PassDeclaration read_pass(const std::string& text);

/// Plans a graph, failing the test on an error.
Plan planned(const Graph& graph, const CompileOptions& options = {});

} // namespace passgraph::test
