// A library opened at run time, for what a machine need not have.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace passgraph::context_kinds
{

/// A library that stays open until the process ends: drivers keep threads and exit handlers inside.
class SharedLibrary
{
public:
    /// Opens the library that the environment variable `override_name` names, else the first of `names` that is there.
    /// Errors   one sentence that names what was tried.
    static tl::expected<SharedLibrary, std::string> open(const char* override_name,
                                                         const std::vector<std::string>& names);

    /// Sets `function` to the symbol called `name`; false when there is none.
    template <class Function> bool load(Function*& function, const char* name) const
    {
        function = reinterpret_cast<Function*>(symbol(name));
        return function != nullptr;
    }

private:
    explicit SharedLibrary(void* handle) : handle_(handle) {}
    void* symbol(const char* name) const;

    void* handle_;
};

} // namespace passgraph::context_kinds
