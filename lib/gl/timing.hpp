// How long each step took, by the GL clock.
#pragma once

#include <vector>

#include <passgraph/core/plan.hpp>

#include "gl/textures.hpp"

namespace passgraph::gl {

/// One timestamp before the first step and one after each step's last draw, before the next framebuffer is bound.
///
/// A step's time is the difference of neighbours: llvmpipe reports 0.1 ms for a 50 ms pass when timed by
/// GL_TIME_ELAPSED or by a timestamp pair around the draw.
class Timing {
public:
    Timing() = default;
    Timing(Upload& upload, size_t steps);

    /// After a clear of a texel of its own: in a frame of one step the mark would be among the draws into the framebuffer that is still bound.
    void mark_start(const Functions& gl, State& state);
    void mark_end_of(const Functions& gl, size_t step) { mark(gl, step + 1); }
    void frame_done() { has_frame_ = !queries_.empty(); }

    /// Waits for the frame. Empty before the first one.
    std::vector<StepTime> read(const Functions& gl, const Plan& plan) const;

private:
    void mark(const Functions& gl, size_t index);

    std::vector<QueryObject> queries_;
    TextureObject texel_;
    FramebufferObject before_; ///< holds it
    bool has_frame_ = false;
};

} // namespace passgraph::gl
