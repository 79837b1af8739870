// Leaves the host's GL state as it was found.
#pragma once

#include <array>
#include <vector>

#include "gl/state.hpp"
#include "gl/state_names.hpp"

namespace passgraph::gl {

/// Saves, when made, everything the executor touches, and puts it back when destroyed.
///
/// Cost     about 100 queries and as many settings, a few microseconds on Mesa; drivers with a thread of their own wait
///          for it.
class StateGuard {
public:
    /// `units`: that may be touched.
    StateGuard(const Driver& driver, Units units);
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

private:
    struct Unit {
        GLint texture_2d = 0;
        GLint cube = 0;
        GLint buffer = 0;
        GLint sampler = 0;
    };
    struct ImageUnit {
        GLint texture = 0;
        GLint level = 0;
        GLint is_layered = 0;
        GLint layer = 0;
        GLint access = 0;
        GLint format = 0;
    };
    struct UniformBuffer {
        GLint buffer = 0;
        GLint64 start = 0;
        GLint64 size = 0;
    };
    static constexpr int kDrawBuffers = 8; ///< what 3.3 guarantees

    GLint get(GLenum name) const;
    void save_units(int units);
    void save_image_units(int units);
    void restore_units() const;
    void restore_image_units() const;
    void restore_bindings() const;
    void restore_fixed_state() const;
    void set_enabled(GLenum capability, bool is_on) const;

    const Functions& gl_;
    std::array<bool, std::size(kAlwaysOff)> enabled_{};
    std::array<bool, 4> switches_{};
    std::array<bool, kDrawBuffers> blends_{};
    std::array<std::array<GLboolean, 4>, kDrawBuffers> color_masks_{};
    std::array<GLint, std::size(kPixelStores)> pixel_stores_{};
    std::array<UniformBuffer, kUniformBufferCount> uniform_buffers_{};
    std::vector<Unit> units_;
    std::vector<ImageUnit> image_units_;
    GLint program_, draw_framebuffer_, read_framebuffer_, vertex_array_, active_texture_;
    GLint array_buffer_, texture_buffer_, uniform_buffer_, pack_buffer_, unpack_buffer_;
    GLint depth_func_, cull_mode_, front_face_, clamp_read_color_;
    GLint clip_origin_ = 0, clip_depth_ = 0;
    std::array<GLint, 4> viewport_{};
    std::array<GLint, 2> polygon_mode_{};
    std::array<GLdouble, 2> depth_range_{};
    GLboolean depth_mask_ = GL_TRUE;
};

} // namespace passgraph::gl
