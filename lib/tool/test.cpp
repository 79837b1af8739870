// `passgraph test`: the contract suite over passes.
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include <passgraph/core/json_value.hpp>
#include <passgraph/shader/pass_file.hpp>

#include "tool/commands.hpp"
#include "tool/contract/suite.hpp"
#include "tool/device.hpp"
#include "tool/library.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

using contract::CheckLine;
using contract::Finding;
using contract::PassReport;

struct TestOptions {
    std::vector<std::string> passes;
    LibraryOptions library;
    DeviceOptions device;
    bool as_json = false;
};

/// What is tested: the passes named, else those of the folders, else the built-in ones.
Result<std::vector<PassPtr>> subjects_of(const TestOptions& options, PassLibrary& library)
{
    std::vector<PassPtr> subjects;
    Errors errors;
    for (const std::string& name : options.passes) {
        const Result<PassPtr> pass = find_pass(name, library);
        if (pass)
            subjects.push_back(*pass);
        else
            append(errors, pass.error());
    }
    if (options.passes.empty()) {
        PassLibrary own;
        for (const std::string& folder : options.library.folders)
            if (const Result<void> loaded = load_pass_folder(folder, own, common_folder()); !loaded)
                append(errors, loaded.error());
        for (const std::string& name : options.library.folders.empty() ? library.names() : own.names())
            subjects.push_back(library.find(name));
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return subjects;
}

void print_finding(const Finding& finding)
{
    if (!finding.settings.empty())
        fmt::print("        with {}\n", finding.settings);
    if (!finding.fed.empty())
        fmt::print("        fed with {}\n", finding.fed);
    fmt::print("        {}: got {}, expected {}\n", finding.place, finding.got, finding.expected);
    if (!finding.hint.empty())
        fmt::print("        hint: {}\n", finding.hint);
}

void print_report(const PassReport& report)
{
    for (const CheckLine& line : report.lines) {
        if (line.faults == 0) {
            fmt::print("ok    {:<22} {:<16} {} {}\n", report.pass, line.check, line.runs, line.runs == 1 ? "run" : "runs");
            continue;
        }
        fmt::print("FAIL  {:<22} {:<16} {} of {} runs\n", report.pass, line.check, line.faults, std::max(line.runs, line.faults));
        for (const Finding& finding : line.findings)
            print_finding(finding);
    }
}

JsonValue report_json(const PassReport& report)
{
    auto checks = JsonValue::array();
    for (const CheckLine& line : report.lines) {
        auto findings = JsonValue::array();
        for (const Finding& finding : line.findings)
            findings.push_back({{"settings", finding.settings},
                                {"fed", finding.fed},
                                {"place", finding.place},
                                {"got", finding.got},
                                {"expected", finding.expected},
                                {"hint", finding.hint}});
        checks.push_back({{"check", line.check}, {"runs", line.runs}, {"faults", line.faults}, {"findings", findings}});
    }
    return {{"pass", report.pass}, {"file", report.file}, {"checks", checks}};
}

Result<void> test(const TestOptions& options)
{
    Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    const Result<std::vector<PassPtr>> subjects = subjects_of(options, *library);
    if (!subjects)
        return tl::unexpected(subjects.error());
    // Hundreds of small programs: Mesa's softpipe compiles one in 2 ms where llvmpipe takes 50. A driver named by hand stays.
    setenv("GALLIUM_DRIVER", "softpipe", 0);
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    JsonValue json = {{"passgraph", 1}, {"passes", JsonValue::array()}};
    std::vector<std::string> unsound;
    for (const PassPtr& pass : *subjects) {
        const Progress progress(fmt::format("testing {}", pass->name));
        const PassReport report = contract::test_pass(*library, pass, (*context)->loader());
        if (!report.is_sound())
            unsound.push_back(pass->name);
        if (options.as_json)
            json["passes"].push_back(report_json(report));
        else
            print_report(report);
    }
    if (options.as_json)
        fmt::print("{}\n", json.text(2));
    if (unsound.empty())
        return {};
    return fail({"contract_broken", fmt::format("{} of {} passes break their contract: {}", unsound.size(), subjects->size(), fmt::join(unsound, ", ")),
                 "each line that begins with FAIL says where, and what to do about it"});
}

} // namespace

void add_test(CommandLine& line)
{
    const auto options = std::make_shared<TestOptions>();
    Command command = line.add_command("test", "Holds passes to their contracts");
    command.add_option("PASS", options->passes, "Passes by name, or their .glsl files; else those of --passes, else all built-in ones");
    command.add_flag("--json", options->as_json, "As JSON");
    add_to(command, options->library);
    add_to(command, options->device);
    command.action([options] { return test(*options); });
}

} // namespace passgraph::tool
