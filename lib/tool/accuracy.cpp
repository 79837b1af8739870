// `passgraph accuracy`: what accuracy costs in time, as a report.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>

#include <fmt/format.h>
#include <unistd.h>

#include "tool/accuracy/choose.hpp"
#include "tool/accuracy/probes.hpp"
#include "tool/accuracy/report/report.hpp"
#include "tool/commands.hpp"
#include "tool/device.hpp"
#include "tool/library.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

struct AccuracyOptions {
    std::vector<std::string> passes;
    std::string out;
    std::string size;
    bool is_quick = false;
    LibraryOptions library;
    DeviceOptions device;
};

std::atomic<bool> is_interrupted = false; // set by Ctrl-C

/// While it lives, the first Ctrl-C asks for an end; another at least a second later ends the program as always. One that comes sooner is
/// the same: `timeout` and some shells signal the process and then its group.
class InterruptWatch {
public:
    InterruptWatch()
    {
        struct sigaction action {};
        action.sa_handler = &InterruptWatch::handle;
        ::sigaction(SIGINT, &action, &before_);
    }
    ~InterruptWatch() { ::sigaction(SIGINT, &before_, nullptr); }
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

private:
    static void handle(int signal)
    {
        static std::atomic<std::time_t> first = 0;
        timespec now {};
        ::clock_gettime(CLOCK_MONOTONIC, &now);
        if (!is_interrupted.exchange(true)) {
            first = now.tv_sec;
        } else if (now.tv_sec > first + 1) {
            ::signal(signal, SIG_DFL);
            ::raise(signal);
        }
    }

    struct sigaction before_ {};
};

std::string time_left_text(double seconds)
{
    const int whole = static_cast<int>(seconds + 0.5);
    return fmt::format("about {}:{:02} left", whole / 60, whole % 60);
}

/// A line on a terminal that changes; elsewhere a line per ladder.
bool show(Progress& progress, const accuracy::Moment& moment)
{
    const std::string left = time_left_text(moment.seconds_left);
    if (::isatty(STDERR_FILENO) == 1)
        progress.update(moment.text + ", " + left);
    else if (moment.is_new_ladder)
        fmt::print(stderr, "{}, {}\n", moment.text, left);
    return !is_interrupted;
}

accuracy::RunOptions run_options(const AccuracyOptions& options, size_t ladders)
{
    accuracy::RunOptions run;
    if (options.is_quick) {
        run.extent = {640, 360};
        run.timing.rounds = 9;
        run.timing.fewest_rounds = 5;
        run.timing.seconds_at_most = 20.0 / static_cast<double>(ladders); // of 50 in all; building and comparing takes the rest
    } else {
        run.timing.rounds = 31;
        run.timing.seconds_at_most = 300.0 / static_cast<double>(ladders); // of 480
    }
    if (const auto extent = extent_of(options.size))
        run.extent = *extent;
    return run;
}

Result<accuracy::Ladders> ladders_for(const AccuracyOptions& options, PassLibrary& library)
{
    Errors errors;
    std::vector<std::string> words;
    for (const std::string& word : options.passes) {
        if (!word.ends_with(".glsl")) {
            words.push_back(word);
            continue;
        }
        if (const Result<PassPtr> pass = find_pass(word, library))
            words.push_back((*pass)->name);
        else
            append(errors, pass.error());
    }
    Result<accuracy::Ladders> ladders;
    if (!words.empty() || options.passes.empty())
        ladders = accuracy::choose_ladders(words, library);
    if (!ladders)
        append(errors, ladders.error());
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return ladders;
}

Result<void> measure_accuracy(const AccuracyOptions& options)
{
    const InterruptWatch watch; // from the start, so that a Ctrl-C at any time leaves a report
    const auto start = std::chrono::steady_clock::now();
    Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    const Result<accuracy::Ladders> ladders = ladders_for(options, *library);
    if (!ladders)
        return tl::unexpected(ladders.error());
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    const Result<PassLibrary> probed = accuracy::with_probes(*library, common_folder());
    if (!probed)
        return tl::unexpected(probed.error());

    const accuracy::RunOptions run = run_options(options, ladders->size());
    accuracy::Conditions conditions = accuracy::conditions_now(run, std::string(name((*context)->kind())));
    conditions.is_quick = options.is_quick;
    std::vector<const accuracy::Ladder*> list;
    for (const auto& ladder : *ladders)
        list.push_back(ladder.get());
    Result<accuracy::Measurements> measurements;
    {
        Progress progress("measuring");
        measurements = accuracy::run_ladders(list, run, *probed, (*context)->loader(), [&](const accuracy::Moment& moment) { return show(progress, moment); });
    }
    if (!measurements)
        return tl::unexpected(measurements.error());
    accuracy::complete(conditions, *measurements, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (conditions.is_interrupted)
        fmt::print(stderr, "interrupted: {} of {} ladders are kept\n", measurements->ladders.size(), list.size());
    if (const Result<void> written = accuracy::write_report(options.out, *measurements, conditions); !written)
        return written;
    fmt::print("{}/index.html\n", options.out);
    return {};
}

} // namespace

void add_accuracy(CommandLine& line)
{
    const auto options = std::make_shared<AccuracyOptions>();
    Command command = line.add_command("accuracy", "Measures what accuracy costs in time");
    command.add_option("PASS", options->passes, "Passes by name or .glsl file, or ladders; else all ladders");
    command.add_option("--out", options->out, "The folder for index.html, accuracy.json, accuracy.csv and charts").required().type_name("DIR");
    command.add_flag("--quick", options->is_quick, "At 640x360 and with fewer rounds: in less than a minute");
    add_extent(command, "--size", options->size, "The extent to measure at; else 1280x720");
    add_to(command, options->library);
    add_to(command, options->device);
    command.footer("Ctrl-C ends the run; what has been measured is written.");
    command.action([options] { return measure_accuracy(*options); });
}

} // namespace passgraph::tool
