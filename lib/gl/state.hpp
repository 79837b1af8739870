// A memory of the GL state, so that only changes reach the driver.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/objects.hpp"

namespace passgraph::gl {

/// How many units something uses, from 0.
struct Units {
    int textures = 0;
    int images = 0;

    /// Enough for both.
    friend Units most(Units a, Units b) { return {std::max(a.textures, b.textures), std::max(a.images, b.images)}; }
};

/// Issues state changes that are changes, and counts both kinds.
///
/// What it remembers holds within one public call of the renderer: each starts with `reset`, because the host may have
/// changed anything in between, and a deleted object's name may have been given to a new one.
class State {
public:
    explicit State(const Driver& driver);

    /// Forgets everything, and sets what no step ever changes (blending off, reversed depth, pixel transfer, ...).
    void reset();

    void use_program(GLuint program);
    void draw_framebuffer(GLuint framebuffer);
    void viewport(Extent extent);
    void vertex_array(GLuint vertex_array);
    void texture(int unit, GLenum target, GLuint texture);
    void sampler(int unit, GLuint sampler);
    /// To be loaded from, as the format that it is stored in.
    void image(int unit, GLuint texture, GLenum format);
    void uniform_buffer(int binding, GLuint buffer);
    /// What a draw does with the depth buffer.
    enum class Depth : std::uint8_t {
        unused,
        tested_and_written, ///< nearer wins
        surfaces,           ///< only where there is a surface; nothing is written
        background,         ///< only where there is none; nothing is written
    };
    void depth(Depth use);
    void cull_back_faces(bool is_on);
    void mirrored_front_face(bool is_mirrored);
    void encodes_srgb(bool is_on);

    /// Binds a texture to be created or filled, at the active unit 0.
    void edit_texture(GLenum target, GLuint texture);

    std::int64_t issued() const { return issued_; }
    std::int64_t redundant() const { return redundant_; }

private:
    static constexpr GLuint kUnknown = 0xffffffffu;
    struct Unit {
        GLuint texture_2d = kUnknown;
        GLuint cube = kUnknown;
        GLuint buffer = kUnknown;
        GLuint sampler = kUnknown;
    };
    struct ImageUnit {
        GLuint texture = kUnknown;
        GLenum format = 0;
        friend bool operator==(const ImageUnit&, const ImageUnit&) = default;
    };
    enum class Switch : std::uint8_t { unknown, off, on };

    /// True, and remembered, when `wanted` is not what `known` says.
    template <class T> bool changes(T& known, T wanted);
    bool changes(Switch& known, bool wanted) { return changes(known, wanted ? Switch::on : Switch::off); }
    void enable(GLenum capability, bool is_on);
    void active_unit(int unit);
    void set_fixed_state();

    const Driver& driver_;
    std::vector<Unit> units_;
    std::vector<ImageUnit> image_units_;
    std::vector<GLuint> uniform_buffers_;
    GLuint program_ = kUnknown;
    GLuint framebuffer_ = kUnknown;
    GLuint vertex_array_ = kUnknown;
    int active_unit_ = -1;
    Extent viewport_{-1, -1};
    std::optional<Depth> depth_;
    Switch cull_ = Switch::unknown;
    Switch mirrored_ = Switch::unknown;
    Switch srgb_ = Switch::unknown;
    std::int64_t issued_ = 0;
    std::int64_t redundant_ = 0;
};

} // namespace passgraph::gl
