// Oracle tables and expressions: numbers in, numbers out.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include <passgraph/gl/evaluate.hpp>
#include <passgraph/shader/expression.hpp>

#include "support/catch.hpp"
#include "support/pass_runner.hpp"
#include "support/test_context.hpp"

namespace passgraph::test {

std::vector<std::vector<float>> evaluate(const std::string& expression, const std::vector<std::string>& includes,
                                         const std::vector<std::string>& columns,
                                         const std::vector<std::vector<float>>& rows)
{
    Context& context = test_context();
    ExpressionScope scope;
    for (const std::string& include : includes) {
        const auto loaded = load_expression_scope(std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common/" + include);
        if (!loaded)
            FAIL(to_text(loaded.error()));
        scope.declarations += loaded->declarations;
        scope.sources = loaded->sources;
    }
    const auto components = expression_components(scope, expression, columns);
    if (!components)
        FAIL(to_text(components.error()));
    const auto values = passgraph::evaluate({scope.declarations, scope.sources, expression, *components, columns, rows},
                                            context.loader());
    if (!values)
        FAIL(to_text(values.error()));
    return *values;
}

size_t Table::column(const std::string& name) const
{
    for (size_t i = 0; i < columns.size(); ++i)
        if (columns[i] == name)
            return i;
    FAIL("no column " << name);
    return 0;
}

Table read_table(const std::string& file_in_tests_data)
{
    std::ifstream stream(std::string(PASSGRAPH_SOURCE_DIR) + "/tests/data/" + file_in_tests_data);
    REQUIRE(stream);
    Table table;
    for (std::string line; std::getline(stream, line);) {
        std::vector<std::string> cells;
        std::istringstream fields(line);
        for (std::string cell; std::getline(fields, cell, ',');)
            cells.push_back(cell);
        if (table.columns.empty()) {
            table.columns = cells;
            continue;
        }
        std::vector<double> numbers;
        for (const std::string& cell : cells) {
            char* end = nullptr;
            const double number = std::strtod(cell.c_str(), &end);
            numbers.push_back(end == cell.c_str() ? std::numeric_limits<double>::quiet_NaN() : number);
        }
        table.rows.push_back(std::move(numbers));
        table.text.push_back(std::move(cells));
    }
    return table;
}

} // namespace passgraph::test
