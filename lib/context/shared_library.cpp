// dlopen with a choice of names and a reason when none works.
#include "context/shared_library.hpp"

#include <cstdlib>

#include <dlfcn.h>
#include <fmt/format.h>

namespace passgraph::context_kinds
{

tl::expected<SharedLibrary, std::string> SharedLibrary::open(const char* override_name,
                                                             const std::vector<std::string>& names)
{
    const char* const chosen = std::getenv(override_name);
    const std::vector<std::string> tried = chosen && *chosen ? std::vector<std::string>{chosen} : names;
    for (const std::string& name : tried)
        if (void* const handle = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE))
            return SharedLibrary(handle);
    return tl::unexpected(fmt::format("{} cannot be opened", fmt::join(tried, ", ")));
}

void* SharedLibrary::symbol(const char* name) const
{
    return ::dlsym(handle_, name);
}

} // namespace passgraph::context_kinds
