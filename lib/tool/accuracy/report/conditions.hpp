// Under which conditions a report's numbers were measured.
#pragma once

#include <string>

#include "tool/accuracy/run.hpp"

namespace passgraph::accuracy {

struct Conditions {
    std::string renderer;  ///< GL_RENDERER and GL_VERSION
    bool is_software = true; ///< the renderer runs on the processor
    std::string context;   ///< "osmesa", ...
    std::string threads;   ///< of the software renderer
    std::string processor;
    int cores = 1;
    double load_before = 0.0; ///< the system's load average over a minute
    double load_after = 0.0;
    Extent extent;
    int rounds = 0; ///< planned
    double sample_ms = 0.0;
    std::uint32_t seed = 0;
    std::string date; ///< ISO 8601, UTC
    std::string version;
    std::string commit; ///< of the source when the build was configured
    bool is_quick = false;
    bool is_interrupted = false;
    double seconds = 0.0; ///< of the whole run
};

/// What is known before the first draw. Errors: none; what the system does not tell is "unknown".
Conditions conditions_now(const RunOptions& options, const std::string& context);
/// Adds what the run itself found out.
void complete(Conditions& conditions, const Measurements& measurements, double seconds);

/// The system's load average over the last minute; 0 where it has none.
double load_average();

} // namespace passgraph::accuracy
