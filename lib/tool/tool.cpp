// Parses argv, runs the chosen subcommand and turns its result into an exit code.
#include "tool/tool.hpp"

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "tool/commands.hpp"

namespace passgraph::tool {
namespace {

enum ExitCode { kDone = 0, kMistake = 1, kUnparsed = 2, kMachineLacks = 3 };

bool is_flag_of_pairs(const std::string& word)
{
    return word == "--in" || word == "--out" || word == "--set" || word == "--param";
}

/// `--in a=1 b=2 GRAPH` becomes `--in a=1 --in b=2 GRAPH`, so that a flag may take several pairs and still leave the
/// words after them alone.
std::vector<std::string> with_a_flag_each(const std::vector<std::string>& words)
{
    std::vector<std::string> result;
    std::string flag;
    bool is_value = false; // the word right behind a flag, whatever it looks like
    for (const std::string& word : words) {
        if (is_flag_of_pairs(word)) {
            flag = word;
            is_value = true;
        } else if (!is_value && !flag.empty()) {
            if (word.starts_with("-") || word.find('=') == std::string::npos)
                flag.clear();
            else
                result.push_back(flag);
        } else {
            is_value = false;
        }
        result.push_back(word);
    }
    return result;
}

/// An expression such as `-x` is no option: a space in front, which GLSL ignores, tells the parser so.
std::vector<std::string> with_expressions_apart(std::vector<std::string> words)
{
    for (size_t i = 1; i < words.size(); ++i) {
        const bool is_value = words[i - 1].starts_with("--");
        if (!is_value && words[i].size() > 1 && words[i][0] == '-' && words[i][1] != '-' && words[i] != "-h")
            words[i].insert(0, 1, ' ');
    }
    return words;
}

int report(const Errors& errors)
{
    fmt::print(stderr, "{}", to_text(errors));
    const bool machine_lacks =
        std::any_of(errors.begin(), errors.end(), [](const Error& error) { return error.fault == Fault::machine; });
    return machine_lacks ? kMachineLacks : kMistake;
}

int run_parsed(const Action& chosen)
{
    try {
        const Result<void> done = chosen();
        if (!done)
            return report(done.error());
        if (std::fflush(stdout) == 0)
            return kDone;
    } catch (const std::system_error&) { // from fmt::print
    } catch (const std::bad_alloc&) {
        return report({{.code = "out_of_memory",
                        .message = "this needs more memory than the machine has",
                        .hint = "use a smaller extent",
                        .fault = Fault::machine}});
    }
    return report({{.code = "file_unwritable",
                    .message = "stdout cannot be written",
                    .hint = "is the disk full, or was the pipe closed?",
                    .fault = Fault::machine}});
}

} // namespace

int run_tool(int argc, const char* const* argv)
{
    CommandLine line("passgraph", "Rendering passes and a compiler for graphs of them.", "passgraph " PASSGRAPH_VERSION);
    add_passes(line);
    add_describe(line);
    add_check(line);
    add_plan(line);
    add_run(line);
    add_render(line);
    add_bench(line);
    add_eval(line);
    add_view(line);
    add_accuracy(line);
    add_test(line);
    add_facts(line);
    add_prove(line);

    std::vector<std::string> words(argv + 1, argv + argc);
    words = !words.empty() && words.front() == "eval" ? with_expressions_apart(std::move(words)) : with_a_flag_each(words);
    const CommandLine::Parsed parsed = line.parse(std::move(words));
    if (!parsed.is_right)
        return kUnparsed;
    return parsed.action ? run_parsed(parsed.action) : kDone;
}

} // namespace passgraph::tool
