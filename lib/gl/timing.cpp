// Timestamps between steps.
#include "gl/timing.hpp"

namespace passgraph::gl {

Timing::Timing(Upload& upload, size_t steps)
{
    for (size_t i = 0; i < steps + 1; ++i)
        queries_.emplace_back(upload.driver);
    constexpr std::uint8_t kTexel[] = {0, 0, 0, 0};
    texel_ = create_filled(upload, Format::rgba8, {1, 1}, kTexel);
    before_ = FramebufferObject(upload.driver);
    upload.state.draw_framebuffer(before_.id());
    upload.driver.gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texel_.id(), 0);
}

void Timing::mark_start(const Functions& gl, State& state)
{
    if (queries_.empty())
        return;
    constexpr GLfloat kZero[] = {0.0f, 0.0f, 0.0f, 0.0f};
    state.draw_framebuffer(before_.id());
    gl.ClearBufferfv(GL_COLOR, 0, kZero);
    mark(gl, 0);
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
