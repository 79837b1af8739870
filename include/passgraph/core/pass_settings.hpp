// Collects the members of a generated pass struct into run-time arguments.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>

#include <passgraph/core/graph.hpp>

namespace passgraph {

/// For generated code: each parameter by name and value, each selection by its item.
class Settings {
public:
    void value(std::string name, double number) { arguments_.settings.push_back({std::move(name), {number}, "", {}}); }
    template <std::size_t N>
    void value(std::string name, const std::array<float, N>& numbers)
    {
        arguments_.settings.push_back({std::move(name), {numbers.begin(), numbers.end()}, "", {}});
    }
    void item(std::string name, int index, std::initializer_list<const char*> items)
    {
        arguments_.settings.push_back({std::move(name), {}, items.begin()[index], {}});
    }
    PassArguments take() { return std::move(arguments_); }

private:
    PassArguments arguments_;
};

} // namespace passgraph
