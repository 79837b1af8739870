// The `passgraph` program as a function.
#pragma once

namespace passgraph::tool {

/// Parses the arguments and runs what they ask for; data goes to stdout, progress and errors to stderr.
///
/// Returns the exit code: 0 done; 1 a name, value or file does not fit; 2 the arguments cannot be parsed; 3 the machine
/// lacks something.
int run_tool(int argc, const char* const* argv);

} // namespace passgraph::tool
