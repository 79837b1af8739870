// Ladders drawn small and compared with their truths, untimed.
#pragma once

#include <string>
#include <vector>

#include "tool/accuracy/run.hpp"

namespace passgraph::test {

/// The built-in passes and the probes.
const PassLibrary& probed_library();

/// Every rung of a ladder, compared at 320x192: four cells of bright texels each way, and a strip of every distance.
std::vector<accuracy::MeasuredRung> compared(const accuracy::Ladder& ladder);

const accuracy::Ladder& ladder_called(const std::string& name);
const accuracy::MeasuredRung& rung_called(const std::vector<accuracy::MeasuredRung>& rungs, const std::string& name);
double figure_of(const accuracy::MeasuredRung& rung, const std::string& name);

} // namespace passgraph::test
