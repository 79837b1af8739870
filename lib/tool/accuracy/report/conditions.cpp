// Asks the system.
#include "tool/accuracy/report/conditions.hpp"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace passgraph::accuracy {
namespace {

std::string processor_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

/// llvmpipe's own rule: the variable, or as many as there are cores.
std::string thread_count(int cores)
{
    const char* set = std::getenv("LP_NUM_THREADS");
    return set ? fmt::format("{} (LP_NUM_THREADS)", set) : fmt::format("{} (one per core)", cores);
}

} // namespace

double load_average()
{
    double minute = 0.0;
    return ::getloadavg(&minute, 1) == 1 ? minute : 0.0;
}

Conditions conditions_now(const RunOptions& options, const std::string& context)
{
    Conditions conditions;
    conditions.context = context;
    conditions.cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
    conditions.processor = processor_name();
    conditions.load_before = load_average();
    conditions.extent = options.extent;
    conditions.rounds = options.timing.rounds;
    conditions.sample_ms = options.timing.sample_ms;
    conditions.seed = options.timing.seed;
    conditions.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    conditions.version = PASSGRAPH_VERSION;
    conditions.commit = PASSGRAPH_COMMIT;
    return conditions;
}

void complete(Conditions& conditions, const Measurements& measurements, double seconds)
{
    conditions.renderer = measurements.renderer.empty() ? "unknown" : measurements.renderer;
    const auto names = {"llvmpipe", "softpipe", "SwiftShader", "swrast"};
    conditions.is_software = std::any_of(names.begin(), names.end(), [&](const char* name) { return conditions.renderer.find(name) != std::string::npos; });
    conditions.threads = conditions.is_software ? thread_count(conditions.cores) : "the device's own";
    conditions.is_interrupted = measurements.is_interrupted;
    conditions.load_after = load_average();
    conditions.seconds = seconds;
}

} // namespace passgraph::accuracy
