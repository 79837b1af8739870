// Interleaved, shuffled rounds.
#include "tool/accuracy/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

#include <fmt/format.h>

namespace passgraph::accuracy {
namespace {

constexpr int kWarmUps = 2; // the first draw compiles

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Milliseconds per draw of `count` draws.
Result<double> time_draws(Subject& subject, int count)
{
    const auto before = subject.renderer.counters().draws;
    subject.renderer.finish();
    const double start = seconds_now();
    for (int i = 0; i < count; ++i)
        if (const Result<void> drawn = subject.renderer.render({.redraws = true}); !drawn)
            return tl::unexpected(drawn.error());
    subject.renderer.finish();
    const double ms = 1e3 * (seconds_now() - start) / count;
    const auto wanted = static_cast<std::int64_t>(subject.renderer.plan().steps.size()) * count;
    if (subject.renderer.counters().draws - before < wanted)
        return fail({.code = "draws_skipped", .message = "the renderer skipped draws that were to be timed", .fault = Fault::machine});
    return ms;
}

/// std::shuffle is another one in each standard library.
void shuffle(std::vector<size_t>& order, std::mt19937& engine)
{
    for (size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[engine() % i]);
}

} // namespace

Result<Samples> measure(std::vector<Subject>& subjects, const TimingOptions& options, const std::function<bool(int, int)>& go_on)
{
    std::vector<int> repeats;
    for (Subject& subject : subjects) {
        double fastest = 1e9;
        for (int i = 0; i < kWarmUps + 1; ++i) {
            const Result<double> ms = time_draws(subject, 1);
            if (!ms)
                return tl::unexpected(ms.error());
            fastest = i > 0 ? std::min(fastest, *ms) : fastest;
        }
        repeats.push_back(std::max(1, static_cast<int>(std::ceil(options.sample_ms / fastest))));
    }
    Samples samples(subjects.size());
    std::vector<size_t> order(subjects.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::mt19937 engine(options.seed);
    const double start = seconds_now();
    const int all = options.rounds * static_cast<int>(subjects.size());
    int done = 0;
    for (int round = 0; round < options.rounds; ++round) {
        if (round >= options.fewest_rounds && seconds_now() - start > options.seconds_at_most)
            break;
        shuffle(order, engine);
        std::vector<double> row(subjects.size());
        for (const size_t i : order) {
            if (!go_on(done++, all))
                return samples;
            const Result<double> ms = time_draws(subjects[i], repeats[i]);
            if (!ms)
                return tl::unexpected(ms.error());
            row[i] = *ms;
        }
        for (size_t i = 0; i < subjects.size(); ++i)
            samples[i].push_back(row[i]);
    }
    return samples;
}

} // namespace passgraph::accuracy
