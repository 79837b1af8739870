// The subcommands: each adds itself to the command line.
#pragma once

#include "tool/command_line.hpp"

namespace passgraph::tool {

void add_passes(CommandLine& line);
void add_describe(CommandLine& line);
void add_check(CommandLine& line);
void add_plan(CommandLine& line);
void add_run(CommandLine& line);
void add_render(CommandLine& line);
void add_bench(CommandLine& line);
void add_eval(CommandLine& line);
void add_view(CommandLine& line);
void add_accuracy(CommandLine& line);
void add_test(CommandLine& line);
void add_facts(CommandLine& line);
void add_prove(CommandLine& line);

} // namespace passgraph::tool
