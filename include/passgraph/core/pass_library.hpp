// The passes a graph may use, by name.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/declaration.hpp>

namespace passgraph {

/// A set of pass declarations; plain passes and composites share one namespace.
class PassLibrary {
public:
    /// Adds a pass; one of the same name is replaced, so that a user's pass may stand in for a built-in one.
    void add(PassPtr pass);
    /// The pass called `name`, or nullptr.
    PassPtr find(std::string_view name) const;
    std::vector<std::string> names() const;
    const std::map<std::string, PassPtr, std::less<>>& passes() const { return passes_; }

private:
    std::map<std::string, PassPtr, std::less<>> passes_;
};

} // namespace passgraph
