// The options that several subcommands share, and how their texts are read.
#include "tool/options.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

namespace passgraph::tool {
namespace {

// No device comes near; products with a ratio still fit an int.
constexpr int kBeyondAnyDevice = 1 << 24;

std::vector<std::string> split(std::string_view text, char at)
{
    std::vector<std::string> parts;
    for (;;) {
        const size_t end = text.find(at);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

std::optional<double> number_of(std::string_view text)
{
    double number = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

std::optional<int> side_of(std::string_view text)
{
    if (text.empty() || !std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return std::nullopt;
    int side = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), side);
    return failure == std::errc() ? std::min(side, kBeyondAnyDevice) : kBeyondAnyDevice;
}

std::string refuse_no_pair(std::string& word)
{
    const size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
        return fmt::format("`{}` is not NAME=VALUE", word);
    return "";
}

std::string refuse_no_extent(std::string& word)
{
    return extent_of(word) ? "" : fmt::format("`{}` is not WIDTHxHEIGHT, such as 1280x720", word);
}

std::string refuse_unknown_steps(std::string& words)
{
    const std::vector<std::string> known = {"specialise", "skip", "unify", "cull", "fuse", "order", "alias", "guards"};
    for (const std::string& word : split(words, ','))
        if (std::find(known.begin(), known.end(), word) == known.end())
            return fmt::format("`{}` is no step of the compiler; {}", word, suggest(word, known, "steps"));
    return "";
}

} // namespace

std::vector<Pair> pairs_of(const std::string& option, const std::vector<std::string>& words)
{
    std::vector<Pair> pairs;
    for (const std::string& word : words) {
        const size_t equals = word.find('=');
        pairs.push_back({word.substr(0, equals), word.substr(equals + 1), {.file = fmt::format("{} {}", option, word)}});
    }
    return pairs;
}

PassArguments::Setting setting_of(const Pair& pair)
{
    PassArguments::Setting setting{.name = pair.name, .numbers = {}, .item = pair.text, .where = pair.where};
    for (const std::string& part : split(pair.text, ',')) {
        const std::optional<double> number = number_of(part);
        if (!number) {
            setting.numbers.clear();
            break;
        }
        setting.numbers.push_back(*number);
    }
    return setting;
}

std::optional<Extent> extent_of(const std::string& text)
{
    const std::vector<std::string> sides = split(text, 'x');
    if (sides.size() != 2)
        return std::nullopt;
    const std::optional<int> width = side_of(sides[0]);
    const std::optional<int> height = side_of(sides[1]);
    if (!width || !height)
        return std::nullopt;
    return Extent{*width, *height};
}

void CompilerOptions::apply_to(CompileOptions& options) const
{
    for (const std::string& word : split(off, ',')) {
        if (word == "fuse")
            options.fuse = false;
        if (word == "specialise")
            options.specialise = false;
        if (word == "skip")
            options.skipping = Skipping::never;
        if (word == "cull")
            options.cull = false;
        if (word == "alias")
            options.alias = false;
        if (word == "guards")
            options.guards = false;
    }
}

Option add_pairs(Command& command, const std::string& flag, std::vector<std::string>& words, const std::string& help)
{
    return command.add_option(flag, words, help).one_word_each().check(refuse_no_pair, "NAME=VALUE");
}

Option add_extent(Command& command, const std::string& flag, std::string& word, const std::string& help)
{
    return command.add_option(flag, word, help).check(refuse_no_extent, "WxH");
}

Option add_steps(Command& command, const std::string& flag, std::string& words, const std::string& help)
{
    return command.add_option(flag, words, help).check(refuse_unknown_steps, "LIST");
}

void add_to(Command& command, LibraryOptions& options)
{
    command.add_option("--passes", options.folders, "A folder of passes of your own; they may replace built-in ones")
        .one_word_each()
        .type_name("DIR");
}

void add_to(Command& command, GraphOptions& options)
{
    command.add_option("GRAPH", options.file, "The graph file").required();
    add_pairs(command, "--set", options.settings, "Sets PASS.NAME, or a param of the graph, to a value or item").type_name("PASS.NAME=V");
    command.add_option("--preset", options.preset, "A file of such values, applied before --set").type_name("FILE");
}

void add_to(Command& command, SourceOptions& options)
{
    command.add_option("--scene", options.scene, "The scene file").type_name("FILE");
    add_pairs(command, "--in", options.pictures, "A picture for an input; for a cube map a folder with px nx py ny pz nz")
        .type_name("NAME=FILE");
    add_extent(command, "--size", options.size, "The extent; else the first picture's, else 1280x720");
}

void add_to(Command& command, CompilerOptions& options)
{
    add_steps(command, "--off", options.off,
              "Compiler steps to leave out: specialise, skip, fuse, cull, alias, guards (unify and order change nothing in this version)");
}

void add_to(Command& command, DeviceOptions& options)
{
    command.add_option("--context", options.context, "osmesa, egl or glfw; else OSMesa, or EGL where that is missing")
        .one_of({"osmesa", "egl", "glfw"});
}

} // namespace passgraph::tool
