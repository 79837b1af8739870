// The entry of the `passgraph` program.
#include "tool/tool.hpp"

int main(int argc, char** argv) { return passgraph::tool::run_tool(argc, argv); }
