// What there is to draw: elements with meshes and materials, lights, a camera, a sky. Plain data, no GL.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <passgraph/core/picture.hpp>

namespace passgraph {

/// A corner of a triangle in model space. `normal` has length 1; `uv` is glTF's: (0, 0) is the texture's first row.
struct Vertex {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f, 1.0f, 0.0f};
    glm::vec2 uv{0.0f};
};

enum class Wrap : std::uint8_t { repeat, mirror, clamp };

/// 8-bit RGBA texels, first row first (glTF's order: v = 0 is row 0).
struct Texture {
    std::string name;
    Extent extent;
    std::vector<std::uint8_t> rgba;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool is_srgb = false; ///< colors (base color, emissive) are; data (metallic-roughness) is not
};

/// glTF's metallic-roughness material. Texture indices point into Scene::textures; -1 is "none" (white).
struct Material {
    std::string name{};
    glm::vec4 base_color{1.0f};
    float metallic = 1.0f;  ///< times the texture's blue
    float roughness = 1.0f; ///< times the texture's green
    float specular = 0.5f;  ///< 0.5 * KHR_materials_specular's factor; dielectric F0 = 0.08 * specular
    glm::vec3 emissive{0.0f}; ///< factor times KHR_materials_emissive_strength; scene-linear radiance
    int base_color_texture = -1;
    int metallic_roughness_texture = -1;
    int emissive_texture = -1;
    int specular_texture = -1; ///< specular times its red; only a scene file's ready atlas has one
    bool is_double_sided = false;
};

/// Indexed triangles with one material.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< three per triangle, each less than vertices.size()
    int material = 0;
};

/// One mesh placed in the world. Places in the world are doubles: a float of a million metres has steps of 6 cm.
struct Element {
    std::string name;
    int mesh = 0;
    glm::dmat4 world_from_model{1.0};
};

/// A directional light shines along `direction`; a point light from `position`, windowed to 0 at `radius`; a spot light
/// is a point light that shines into a cone about `direction`, fully inside `inner_angle` and not outside `outer_angle`.
struct Light {
    enum class Kind : std::uint8_t { directional, point, spot };
    Kind kind = Kind::directional;
    std::string name;
    glm::vec3 color{1.0f};                ///< directional: irradiance on a facing surface; else: irradiance at 1 m
    glm::vec3 direction{0.0f, -1.0f, 0.0f}; ///< world space, length 1, the way the light travels
    glm::dvec3 position{0.0};             ///< world space, metres
    float radius = 0.0f;                  ///< metres; beyond it the light is exactly 0; 0: off
    float inner_angle = 0.0f;             ///< radians from the axis, at most outer_angle; equal ones give a sharp edge
    float outer_angle = 0.785398163f;     ///< radians from the axis, at most pi
};

/// A perspective camera; looks along `direction` with `up` roughly up. Angles in radians, lengths in metres.
struct Camera {
    glm::dvec3 position{0.0};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float vertical_fov = 0.785398163f;
    float near_plane = 0.1f;
    float far_plane = 1000.0f;
};

/// A cube map of scene-linear radiance, faces +X -X +Y -Y +Z -Z in OpenGL's orientation; absent when `faces[0]` is empty.
struct Sky {
    std::array<Picture, 6> faces;
    bool is_present() const { return faces[0].extent.width > 0; }
};

/// Everything a scene file describes, loaded.
struct Scene {
    std::string name;
    Camera camera;
    Sky sky;
    std::vector<Texture> textures;
    std::vector<Material> materials; ///< never empty once loaded: a mesh without material gets a default one
    std::vector<Mesh> meshes;
    std::vector<Element> elements;
    std::vector<Light> lights;
};

} // namespace passgraph
