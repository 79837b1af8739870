// Draws one step: a full-screen triangle, or the scene's elements.
#pragma once

#include "gl/frame_blocks.hpp"
#include "gl/imports.hpp"
#include "gl/scene_buffers.hpp"
#include "gl/targets.hpp"

namespace passgraph::gl {

/// What steps draw with, beside their own objects.
struct DrawInputs {
    const Functions& gl;
    State& state;
    const std::vector<TextureObject>& slots;
    const Imports& imports;
    const SceneBuffers* scene; ///< nullptr: no scene was set, and no step needs one
    GLuint empty_vertex_array;
    const Cube& black_cube; ///< a sky that is not there
    bool only_warms_up = false; ///< draws into one pixel: the driver compiles, and nothing is seen
};

/// The queries that a step's draws have to do with in this frame; 0: none.
struct StepQueries {
    GLuint counts = 0;     ///< is to count the pixels that are drawn
    bool scouts = false;   ///< it counts the scout's, and without one the device leaves the step out
    GLuint skipped_by = 0; ///< has counted; without a pixel, the device leaves the step out or draws its variant
    bool is_known_black = false; ///< without one, as the device has said by now
};

/// Draws the step and returns how many draws that took.
std::int64_t draw_step(const DrawInputs& inputs, const Plan::Step& step, StepObjects& objects,
                       const StepQueries& queries = {});

} // namespace passgraph::gl
