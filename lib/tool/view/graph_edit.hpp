// Writes changed settings into a graph file's text, leaving the rest as its author wrote it.
#pragma once

#include <string>

#include "tool/view/controls.hpp"

namespace passgraph::tool::view {

/// The text with each setting ("PASS.NAME") in it: in place of the value that is there, or added to the pass.
///
/// Comments, order and spacing stay. Errors   json_*; unknown_image, unknown_param for settings that the file's passes lack.
Result<std::string> with_settings(const std::string& text, const std::string& file, const Settings& settings,
                                  const GraphDescription& description, const PassLibrary& library);

} // namespace passgraph::tool::view
