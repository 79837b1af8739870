// Opens a context of the kind asked for.
#include "tool/device.hpp"

#include <fmt/format.h>

namespace passgraph::tool {

Result<std::unique_ptr<Context>> open_context(const DeviceOptions& options)
{
    auto context = options.context == "osmesa" ? create_context(ContextKind::osmesa)
                   : options.context == "egl"  ? create_context(ContextKind::egl)
                   : options.context == "glfw" ? create_context(ContextKind::glfw)
                                               : create_headless_context();
    if (context)
        return std::move(*context);
    return fail({.code = "context_missing",
                 .message = context.error().message,
                 .hint = context.error().hint,
                 .fault = Fault::machine});
}

} // namespace passgraph::tool
