// The command line, by CLI11.
#include "tool/command_line.hpp"

#include <algorithm>
#include <utility>

#include <CLI/CLI.hpp>

namespace passgraph::tool {

Option Option::required()
{
    option_->required();
    return *this;
}

Option Option::type_name(const std::string& name)
{
    option_->type_name(name);
    return *this;
}

Option Option::one_word_each()
{
    option_->allow_extra_args(false);
    return *this;
}

Option Option::positive()
{
    option_->check(CLI::PositiveNumber);
    return *this;
}

Option Option::between(double low, double high)
{
    option_->check(CLI::Range(low, high));
    return *this;
}

Option Option::one_of(const std::vector<std::string>& words)
{
    option_->check(CLI::IsMember(words));
    return *this;
}

Option Option::check(const std::function<std::string(std::string&)>& refuse, const std::string& name)
{
    option_->check(CLI::Validator(refuse, name));
    return *this;
}

Option Command::add_option(const std::string& name, std::string& word, const std::string& help)
{
    return Option(*app_->add_option(name, word, help));
}

Option Command::add_option(const std::string& name, std::vector<std::string>& words, const std::string& help)
{
    return Option(*app_->add_option(name, words, help));
}

Option Command::add_option(const std::string& name, int& number, const std::string& help)
{
    return Option(*app_->add_option(name, number, help));
}

Option Command::add_option(const std::string& name, double& number, const std::string& help)
{
    return Option(*app_->add_option(name, number, help));
}

void Command::add_flag(const std::string& name, bool& is_given, const std::string& help) { app_->add_flag(name, is_given, help); }

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::action(Action action)
{
    app_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

CommandLine::CommandLine(const std::string& name, const std::string& summary, const std::string& version)
    : app_(std::make_unique<CLI::App>(summary, name))
{
    app_->require_subcommand(1);
    app_->set_version_flag("--version", version);
}

CommandLine::~CommandLine() = default;

Command CommandLine::add_command(const std::string& name, const std::string& summary)
{
    return {*app_->add_subcommand(name, summary), chosen_};
}

CommandLine::Parsed CommandLine::parse(std::vector<std::string> words)
{
    std::reverse(words.begin(), words.end()); // CLI11 takes them from the back
    try {
        app_->parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        return {.action = {}, .is_right = app_->exit(error) == 0}; // help and version are no mistakes
    }
    return {.action = chosen_};
}

} // namespace passgraph::tool
