// The run: ladder after ladder, errors first, then times.
#include "tool/accuracy/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "tool/accuracy/crops.hpp"

namespace passgraph::accuracy {
namespace {

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Two kinds of work, each with the mean of what it took so far; guesses until the first is done.
class Clock {
public:
    Clock(int preparations, int samples, double sample_seconds)
        : preparations_{preparations, 0, 0.0, 0.5}, samples_{samples, 0, 0.0, sample_seconds}, last_(seconds_now())
    {
    }
    void prepared() { tick(preparations_); }
    void sampled() { tick(samples_); }
    void skip_samples(int count) { samples_.all -= count; }
    double seconds_left() const { return left(preparations_) + left(samples_); }

private:
    struct Work {
        int all;
        int done;
        double seconds;
        double guess;
    };
    void tick(Work& work)
    {
        const double now = seconds_now();
        work.seconds += now - last_;
        ++work.done;
        last_ = now;
    }
    static double left(const Work& work)
    {
        return std::max(work.all - work.done, 0) * (work.done > 0 ? work.seconds / work.done : work.guess);
    }
    Work preparations_;
    Work samples_;
    double last_;
};

const Rung& used_rung(const Ladder& ladder)
{
    const auto found = std::find_if(ladder.rungs.begin(), ladder.rungs.end(), [](const Rung& rung) { return rung.is_default; });
    return found == ladder.rungs.end() ? ladder.rungs.back() : *found;
}

double largest_difference(const std::vector<MeasuredRung>& rungs)
{
    double largest = 0.0;
    for (const MeasuredRung& rung : rungs)
        for (const double difference : rung.differences)
            largest = std::isfinite(difference) ? std::max(largest, std::abs(difference)) : largest;
    return largest;
}

class Run {
public:
    Run(const std::vector<const Ladder*>& ladders, const RunOptions& options, const PassLibrary& library, GlLoader loader, const Watch& watch)
        : options_(options), library_(library), loader_(loader), watch_(watch),
          clock_(count(ladders), count(ladders) * options.timing.rounds, 1.2e-3 * options.timing.sample_ms)
    {
    }

    Result<void> measure_ladder(const Ladder& ladder)
    {
        MeasuredLadder measured{.ladder = &ladder};
        const Inputs inputs = ladder.make_inputs(options_.extent);
        const Truth truth = ladder.find_truth(inputs, options_.extent);
        measured.truth_crop = truth_crop(ladder, truth);
        std::vector<Subject> subjects;
        for (const Rung& rung : ladder.rungs) {
            if (!show(fmt::format("{}: drawing {}", ladder.name, rung.name), &rung == &ladder.rungs.front()))
                return {};
            Result<Compared> compared = compare_rung(ladder, rung, inputs, truth, library_, loader_);
            if (!compared)
                return tl::unexpected(compared.error());
            measured.rungs.push_back(std::move(compared->rung));
            subjects.push_back(std::move(compared->subject));
            result_.renderer = subjects.back().renderer.device_name();
            clock_.prepared();
        }
        measured.map_limit = largest_difference(measured.rungs);
        Result<Subject> twin = make_subject(used_rung(ladder), inputs, options_.extent, library_, loader_);
        if (!twin)
            return tl::unexpected(twin.error());
        subjects.push_back(std::move(*twin));
        clock_.prepared();
        return time(std::move(measured), subjects);
    }

    Measurements take() { return std::move(result_); }
    bool is_interrupted() const { return result_.is_interrupted; }

private:
    static int count(const std::vector<const Ladder*>& ladders)
    {
        int rungs = 0;
        for (const Ladder* ladder : ladders)
            rungs += static_cast<int>(ladder->rungs.size()) + 1; // and the twin
        return rungs;
    }

    bool show(const std::string& text, bool is_new_ladder)
    {
        result_.is_interrupted = result_.is_interrupted || !watch_({text, clock_.seconds_left(), is_new_ladder});
        return !result_.is_interrupted;
    }

    Result<void> time(MeasuredLadder measured, std::vector<Subject>& subjects)
    {
        const int per_round = static_cast<int>(subjects.size());
        const Result<Samples> samples = measure(subjects, options_.timing, [&](int done, int all) {
            clock_.sampled();
            return show(fmt::format("{}: round {} of {}", measured.ladder->name, done / per_round + 1, all / per_round), false);
        });
        if (!samples)
            return tl::unexpected(samples.error());
        const auto rounds = static_cast<int>(samples->front().size());
        clock_.skip_samples((options_.timing.rounds - rounds) * per_round);
        if (rounds == 0)
            return {};
        judge(measured, *samples);
        result_.ladders.push_back(std::move(measured));
        return {};
    }

    const RunOptions& options_;
    const PassLibrary& library_;
    GlLoader loader_;
    const Watch& watch_;
    Clock clock_;
    Measurements result_;
};

} // namespace

Result<Compared> compare_rung(const Ladder& ladder, const Rung& rung, const Inputs& inputs, const Truth& truth,
                              const PassLibrary& library, GlLoader loader)
{
    Result<Subject> subject = make_subject(rung, inputs, truth.extent, library, loader);
    if (!subject)
        return tl::unexpected(subject.error());
    const Result<Picture> result = draw_and_read(*subject);
    if (!result)
        return tl::unexpected(result.error());
    MeasuredRung measured{.rung = rung};
    measured.deviation = compare(ladder.metric, truth, *result);
    measured.is_within_bound = measured.deviation.error <= rung.bound;
    measured.worst_input = ladder.describe_input(inputs, measured.deviation.worst[0], measured.deviation.worst[1]);
    measured.bytes_per_pixel = subject->bytes_per_pixel;
    if (ladder.find_figures)
        measured.figures = ladder.find_figures(inputs, *result);
    measured.crop = result_crop(ladder, truth, *result);
    measured.differences = crop_differences(ladder, truth, *result);
    return Compared{std::move(measured), std::move(*subject)};
}

Result<Measurements> run_ladders(const std::vector<const Ladder*>& ladders, const RunOptions& options, const PassLibrary& library,
                                 GlLoader loader, const Watch& watch)
{
    Run run(ladders, options, library, loader, watch);
    for (const Ladder* ladder : ladders) {
        if (const Result<void> done = run.measure_ladder(*ladder); !done)
            return tl::unexpected(done.error());
        if (run.is_interrupted())
            break;
    }
    return run.take();
}

} // namespace passgraph::accuracy
