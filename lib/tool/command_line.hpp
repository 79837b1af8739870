// The command line: subcommands, their options and the parse. CLI11, one large template, is seen by command_line.cpp alone.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <passgraph/core/error.hpp>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace passgraph::tool {

/// What the chosen subcommand does; an error decides the exit code.
using Action = std::function<Result<void>()>;

/// What may be said of an option. Each returns the option itself.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    Option required();
    /// What help calls the value.
    Option type_name(const std::string& name);
    /// Takes one word each time it is given, not all that follow.
    Option one_word_each();
    Option positive();
    Option between(double low, double high);
    Option one_of(const std::vector<std::string>& words);
    /// `refuse` says why a word is not taken, or nothing; help calls the words it takes `name`.
    Option check(const std::function<std::string(std::string&)>& refuse, const std::string& name);

private:
    CLI::Option* option_;
};

/// One subcommand. What an option is given goes into its variable, which has to live as long as the command line.
class Command {
public:
    Command(CLI::App& app, Action& chosen) : app_(&app), chosen_(&chosen) {}

    /// `name` starts with `--`, or is a positional argument's.
    Option add_option(const std::string& name, std::string& word, const std::string& help);
    Option add_option(const std::string& name, std::vector<std::string>& words, const std::string& help);
    Option add_option(const std::string& name, int& number, const std::string& help);
    Option add_option(const std::string& name, double& number, const std::string& help);
    void add_flag(const std::string& name, bool& is_given, const std::string& help);

    /// Stands below the options in help.
    void footer(const std::string& text);
    /// What the command does once all its options are read.
    void action(Action action);

private:
    CLI::App* app_;
    Action* chosen_;
};

class CommandLine {
public:
    CommandLine(const std::string& name, const std::string& summary, const std::string& version);
    ~CommandLine();

    Command add_command(const std::string& name, const std::string& summary);

    struct Parsed {
        Action action;        ///< the chosen command's; empty where help or the version was asked for and has been printed
        bool is_right = true; ///< else stderr says what is wrong
    };
    Parsed parse(std::vector<std::string> words);

private:
    std::unique_ptr<CLI::App> app_;
    Action chosen_;
};

} // namespace passgraph::tool
