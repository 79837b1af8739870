// The uniform blocks of camera and frame, uploaded when their contents change.
#pragma once

#include <optional>

#include <passgraph/core/glsl_interface.hpp>

#include "gl/state.hpp"

namespace passgraph::gl {

class FrameBlocks {
public:
    explicit FrameBlocks(Driver& driver);

    void set_camera(const Functions& gl, const glsl::CameraBlock& block);
    void set_frame(const Functions& gl, const glsl::FrameBlock& block);
    void bind(State& state) const;

private:
    BufferObject camera_buffer_;
    BufferObject frame_buffer_;
    std::optional<glsl::CameraBlock> camera_;
    std::optional<glsl::FrameBlock> frame_;
};

} // namespace passgraph::gl
