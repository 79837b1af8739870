// Timestamps between steps.
#include "gl/timing.hpp"

namespace passgraph::gl {

Timing::Timing(Driver& driver, size_t steps)
{
    for (size_t i = 0; i < steps + 1; ++i)
        queries_.emplace_back(driver);
}

void Timing::mark(const Functions& gl, size_t index)
{
    if (!queries_.empty())
        gl.QueryCounter(queries_[index].id(), GL_TIMESTAMP);
}

std::vector<StepTime> Timing::read(const Functions& gl, const Plan& plan) const
{
    std::vector<StepTime> times;
    if (!has_frame_)
        return times;
    GLuint64 before = 0;
    gl.GetQueryObjectui64v(queries_[0].id(), GL_QUERY_RESULT, &before);
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        GLuint64 after = 0;
        gl.GetQueryObjectui64v(queries_[i + 1].id(), GL_QUERY_RESULT, &after);
        // Signed: clocks of two workers may disagree by some nanoseconds.
        const auto nanoseconds = static_cast<std::int64_t>(after - before);
        times.push_back({plan.steps[i].name, static_cast<double>(nanoseconds) * 1e-6});
        before = after;
    }
    return times;
}

} // namespace passgraph::gl
