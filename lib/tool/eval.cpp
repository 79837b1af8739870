// `passgraph eval`: a GLSL expression once per row of a table, in binary32.
#include <cstdio>

#include <fmt/format.h>

#include <passgraph/core/json.hpp>
#include <passgraph/gl/evaluate.hpp>
#include <passgraph/shader/expression.hpp>

#include "tool/commands.hpp"
#include "tool/csv.hpp"
#include "tool/device.hpp"
#include "tool/library.hpp"

namespace passgraph::tool {
namespace {

struct EvalOptions {
    std::string expression;
    std::vector<std::string> includes;
    std::string csv;
    std::string out;
    DeviceOptions device;
};

/// The text with every `#line LINE SOURCE` pointing `offset` sources further.
std::string with_sources_moved(const std::string& text, size_t offset)
{
    std::string moved;
    for (size_t start = 0; start < text.size();) {
        const size_t end = std::min(text.find('\n', start), text.size());
        const std::string line = text.substr(start, end - start);
        int number = 0;
        int source = 0;
        if (std::sscanf(line.c_str(), " # line %d %d", &number, &source) == 2)
            moved += fmt::format("#line {} {}\n", number, static_cast<size_t>(source) + offset);
        else
            moved += line + "\n";
        start = end + 1;
    }
    return moved;
}

Result<ExpressionScope> load_scopes(const std::vector<std::string>& files)
{
    ExpressionScope all;
    Errors errors;
    for (const std::string& file : files) {
        const Result<ExpressionScope> scope = load_expression_scope(file, common_folder());
        if (!scope) {
            errors.insert(errors.end(), scope.error().begin(), scope.error().end());
            continue;
        }
        all.declarations += with_sources_moved(scope->declarations, all.sources.size());
        all.sources.insert(all.sources.end(), scope->sources.begin(), scope->sources.end());
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    if (all.sources.empty())
        all.sources.push_back("generated");
    return all;
}

Result<void> eval(const EvalOptions& options)
{
    Errors errors;
    Result<ExpressionScope> scope = load_scopes(options.includes);
    if (!scope)
        errors = scope.error();
    Result<std::string> text = read_text_file(options.csv);
    Result<CsvTable> table = text ? read_csv(*text, options.csv) : Result<CsvTable>(tl::unexpected(text.error()));
    if (!table)
        errors.insert(errors.end(), table.error().begin(), table.error().end());
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    const Result<int> components = expression_components(*scope, options.expression, table->columns);
    if (!components)
        return tl::unexpected(components.error());
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    const auto values = evaluate({.declarations = scope->declarations,
                                  .sources = scope->sources,
                                  .expression = options.expression,
                                  .components = *components,
                                  .columns = table->columns,
                                  .rows = table->rows},
                                 (*context)->loader());
    if (!values)
        return tl::unexpected(values.error());
    static const std::vector<std::string> kVector = {"x", "y", "z", "w"};
    const std::vector<std::string> columns =
        *components == 1 ? std::vector<std::string>{"value"} : std::vector<std::string>(kVector.begin(), kVector.begin() + *components);
    const std::string result = csv_text(*table, columns, *values);
    if (!options.out.empty() && options.out != "-")
        return write_text_file(options.out, result);
    fmt::print("{}", result);
    return {};
}

} // namespace

void add_eval(CommandLine& line)
{
    const auto options = std::make_shared<EvalOptions>();
    Command command = line.add_command("eval", "Evaluates a GLSL expression once per row of a CSV table, in binary32");
    command.add_option("EXPR", options->expression, "The expression; the table's columns are float variables in it").required();
    command.add_option("--include", options->includes, "A file whose functions the expression may call: a common file or a pass")
        .one_word_each()
        .type_name("FILE.glsl");
    command.add_option("--csv", options->csv, "The table").required().type_name("IN.csv");
    command.add_option("--out", options->out, "The table with the value behind; else, or as -, stdout").type_name("OUT.csv");
    add_to(command, options->device);
    command.action([options] { return eval(*options); });
}

} // namespace passgraph::tool
