// What the subcommands' options say, in the types the commands work with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <passgraph/core/compile.hpp>
#include <passgraph/core/error.hpp>
#include <passgraph/core/graph.hpp>

#include "tool/command_line.hpp"

namespace passgraph::tool {

/// NAME=TEXT, split at the first `=`.
struct Pair {
    std::string name;
    std::string text;
    Location where; ///< the option itself, for messages
};

/// The pairs of an option. Every word holds a `=`: the parser has checked that.
std::vector<Pair> pairs_of(const std::string& option, const std::vector<std::string>& words);

/// `--param` and `--set`: numbers where the text is some, and the text itself, which may name an item.
PassArguments::Setting setting_of(const Pair& pair);

/// "1280x720"; sides beyond any device's stay beyond it. nullopt when it is no extent.
std::optional<Extent> extent_of(const std::string& text);

struct LibraryOptions {
    std::vector<std::string> folders;
};

struct GraphOptions {
    std::string file;
    std::vector<std::string> settings;
    std::string preset;
};

/// What the host supplies.
struct SourceOptions {
    std::string scene;
    std::vector<std::string> pictures;
    std::string size;

    std::optional<Extent> extent() const { return size.empty() ? std::nullopt : extent_of(size); }
};

struct CompilerOptions {
    std::string off; ///< words with commas between

    void apply_to(CompileOptions& options) const;
};

struct DeviceOptions {
    std::string context;
};

void add_to(Command& command, LibraryOptions& options);
void add_to(Command& command, GraphOptions& options);
void add_to(Command& command, SourceOptions& options);
void add_to(Command& command, CompilerOptions& options);
void add_to(Command& command, DeviceOptions& options);

/// An option that may be given several times, each time with one `NAME=TEXT`.
Option add_pairs(Command& command, const std::string& flag, std::vector<std::string>& words, const std::string& help);
/// An option that takes WIDTHxHEIGHT.
Option add_extent(Command& command, const std::string& flag, std::string& word, const std::string& help);
/// A list of compiler steps with commas between.
Option add_steps(Command& command, const std::string& flag, std::string& words, const std::string& help);

} // namespace passgraph::tool
