// The subcommands: each adds itself to the parser and leaves what is to be done.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include <passgraph/core/error.hpp>

namespace passgraph::tool {

/// What the chosen subcommand does; an error decides the exit code.
using Action = std::function<Result<void>()>;

void add_passes(CLI::App& app, Action& chosen);
void add_describe(CLI::App& app, Action& chosen);
void add_check(CLI::App& app, Action& chosen);
void add_plan(CLI::App& app, Action& chosen);
void add_run(CLI::App& app, Action& chosen);
void add_render(CLI::App& app, Action& chosen);
void add_bench(CLI::App& app, Action& chosen);
void add_eval(CLI::App& app, Action& chosen);
void add_view(CLI::App& app, Action& chosen);
void add_accuracy(CLI::App& app, Action& chosen);
void add_test(CLI::App& app, Action& chosen);

} // namespace passgraph::tool
