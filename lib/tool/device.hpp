// The context that the options ask for.
#pragma once

#include <memory>

#include <passgraph/context/context.hpp>
#include <passgraph/core/error.hpp>

#include "tool/options.hpp"

namespace passgraph::tool {

/// Makes a context and makes it current. Errors: context_missing, a lack of the machine.
Result<std::unique_ptr<Context>> open_context(const DeviceOptions& options);

} // namespace passgraph::tool
