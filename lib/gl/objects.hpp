// GL objects that delete themselves, and the driver they belong to.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "gl/functions.hpp"

namespace passgraph::gl {

/// The limits of a context that plans, scenes and pictures are checked against.
struct Limits {
    int texture_size = 1024;
    int cube_size = 1024;
    int texture_units = 16;
    int color_targets = 8;
    int varying_components = 60;
    int image_units = 0; ///< that fragment stages may load from
    int texture_buffer_texels = 65536;
};

/// The functions, limits and counters of one context. Objects point to it, so it stays where it is.
struct Driver {
    Functions gl;
    Limits limits;
    std::string device_name;
    std::int64_t objects_created = 0;
};

/// Errors   those of load_functions.
Result<Driver> create_driver(GlLoader loader);

enum class ObjectKind { texture, framebuffer, sampler, vertex_array, buffer, query, program, shader };

/// `detail` tells a program from a shader: the shader's stage, else 0.
GLuint create_object(Driver& driver, ObjectKind kind, GLenum detail);
void delete_object(Driver& driver, ObjectKind kind, GLuint id);

/// Owns one GL name; empty when default-constructed or moved from.
template <ObjectKind kind> class Object {
public:
    Object() = default;
    explicit Object(Driver& driver, GLenum detail = 0) : driver_(&driver), id_(create_object(driver, kind, detail)) {}
    Object(Object&& other) noexcept : driver_(std::exchange(other.driver_, nullptr)), id_(std::exchange(other.id_, 0u))
    {
    }
    Object& operator=(Object&& other) noexcept
    {
        std::swap(driver_, other.driver_);
        std::swap(id_, other.id_);
        return *this;
    }
    ~Object()
    {
        if (id_ != 0)
            delete_object(*driver_, kind, id_);
    }

    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

private:
    Driver* driver_ = nullptr;
    GLuint id_ = 0;
};

using TextureObject = Object<ObjectKind::texture>;
using FramebufferObject = Object<ObjectKind::framebuffer>;
using SamplerObject = Object<ObjectKind::sampler>;
using VertexArrayObject = Object<ObjectKind::vertex_array>;
using BufferObject = Object<ObjectKind::buffer>;
using QueryObject = Object<ObjectKind::query>;
using ProgramObject = Object<ObjectKind::program>;
using ShaderObject = Object<ObjectKind::shader>;

} // namespace passgraph::gl
