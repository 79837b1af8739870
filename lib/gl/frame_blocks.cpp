// Uniform buffers of the camera and the frame.
#include "gl/frame_blocks.hpp"

#include <cstring>

#include "gl/state_names.hpp"

namespace passgraph::gl {
namespace {

/// Both blocks are made of 4-byte numbers without padding, so equal bytes are equal contents.
template <class Block>
void upload_if_changed(const Functions& gl, const BufferObject& buffer, std::optional<Block>& known,
                       const Block& wanted)
{
    if (known && std::memcmp(&*known, &wanted, sizeof(Block)) == 0)
        return;
    known = wanted;
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffer.id());
    gl.BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(Block), &wanted);
}

} // namespace

FrameBlocks::FrameBlocks(Driver& driver) : camera_buffer_(driver), frame_buffer_(driver)
{
    const Functions& gl = driver.gl;
    gl.BindBuffer(GL_UNIFORM_BUFFER, camera_buffer_.id());
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof(glsl::CameraBlock), nullptr, GL_DYNAMIC_DRAW);
    gl.BindBuffer(GL_UNIFORM_BUFFER, frame_buffer_.id());
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof(glsl::FrameBlock), nullptr, GL_DYNAMIC_DRAW);
}

void FrameBlocks::set_camera(const Functions& gl, const glsl::CameraBlock& block)
{
    upload_if_changed(gl, camera_buffer_, camera_, block);
}

void FrameBlocks::set_frame(const Functions& gl, const glsl::FrameBlock& block)
{
    upload_if_changed(gl, frame_buffer_, frame_, block);
}

void FrameBlocks::bind(State& state) const
{
    state.uniform_buffer(kCameraBinding, camera_buffer_.id());
    state.uniform_buffer(kFrameBinding, frame_buffer_.id());
}

} // namespace passgraph::gl
