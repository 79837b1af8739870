// Which steps the device may leave out of a frame, and which it did leave out of the last one.
#pragma once

#include <vector>

#include "gl/drawing.hpp"

namespace passgraph::gl {

/// True if pixels may be counted: OpenGL has one such query at a time, and the host's own may be running.
bool may_count(const Functions& gl, const Plan& plan);

/// The queries of one step, which is about to be drawn. `answers`: by query, whether it has counted, or will before the step's turn.
StepQueries queries_of(const Functions& gl, PlanObjects& objects, size_t step, const std::vector<bool>& answers, bool counts);

/// Whether the device left the step out, or drew its variant. Waits for the device.
bool was_skipped(const Functions& gl, const StepQueries& queries);

} // namespace passgraph::gl
