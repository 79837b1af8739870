// A frame as the original drew it.
#include "frame.hpp"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "shaders.hpp"

namespace original {
namespace {

[[noreturn]] void stop(const char* why)
{
    std::fprintf(stderr, "original_timing: %s\n", why);
    std::exit(3);
}

/// Two triangles over the picture: position and uv of each corner.
constexpr float kQuad[] = {-1, -1, 0, 0, 0, 1, -1, 0, 1, 0, 1, 1, 0, 1, 1, -1, -1, 0, 0, 0, 1, 1, 0, 1, 1, -1, 1, 0, 0, 1};

} // namespace

Frame::Frame(void* (*loader)(const char*), const passgraph::Scene& scene, passgraph::Extent extent)
    : extent_(extent), scene_(scene)
{
#define ORIGINAL_LOAD(type, name) gl_.name = reinterpret_cast<type>(loader("gl" #name));
    ORIGINAL_FUNCTIONS(ORIGINAL_LOAD)
#undef ORIGINAL_LOAD
    gl_.GenVertexArrays(1, &vertex_array_);
    gl_.BindVertexArray(vertex_array_);
    gl_.GenBuffers(1, &buffer_);
    geometry_ = program(kGeometryVertex, kGeometryFragment);
    lighting_ = program(kScreenVertex, kLighting);
    blur_ = program(kScreenVertex, kBlur);
    combine_ = program(kScreenVertex, kCombine);
    g_buffer_ = target(GL_RGB16F, 4, true);
    lit_ = target(GL_RGB16F, 2, true);
    rows_ = target(GL_RGB16F, 1, true);
    glow_ = target(GL_RGB16F, 1, true);
    shown_ = target(GL_RGBA8, 1, true);
    add_elements(scene);
    const passgraph::Camera& camera = scene.camera;
    const glm::vec3 eye(camera.position);
    view_ = glm::lookAt(eye, eye + camera.direction, camera.up);
    projection_ = glm::perspective(camera.vertical_fov, static_cast<float>(extent.width) / static_cast<float>(extent.height),
                                   camera.near_plane, camera.far_plane);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Viewport(0, 0, extent.width, extent.height);
    gl_.ClearColor(0, 0, 0, 1);
}

void Frame::add_elements(const passgraph::Scene& scene)
{
    for (const passgraph::Element& element : scene.elements) {
        const passgraph::Mesh& mesh = scene.meshes[static_cast<size_t>(element.mesh)];
        const passgraph::Material& material = scene.materials[static_cast<size_t>(mesh.material)];
        Drawn drawn;
        for (const std::uint32_t index : mesh.indices)
            drawn.vertices.push_back(mesh.vertices[index]);
        drawn.model = glm::mat4(element.world_from_model);
        drawn.color = texture_of(scene, material.base_color_texture, glm::vec3(material.base_color));
        drawn.material = texture_of(scene, material.metallic_roughness_texture,
                                    {material.specular, material.roughness, material.metallic});
        vertices_ += drawn.vertices.size();
        drawn_.push_back(std::move(drawn));
    }
}

GLuint Frame::texture_of(const passgraph::Scene& scene, int index, const glm::vec3& factor)
{
    passgraph::Extent extent{1, 1};
    std::vector<std::uint8_t> texels;
    for (int c = 0; c < 3; ++c)
        texels.push_back(static_cast<std::uint8_t>(255.0f * factor[c]));
    texels.push_back(255);
    if (index >= 0) {
        extent = scene.textures[static_cast<size_t>(index)].extent;
        texels = scene.textures[static_cast<size_t>(index)].rgba;
    }
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, extent.width, extent.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl_.GenerateMipmap(GL_TEXTURE_2D);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

GLuint Frame::program(const char* vertex, const char* fragment)
{
    const GLuint made = gl_.CreateProgram();
    for (const auto& [stage, text] : {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = gl_.CreateShader(static_cast<GLenum>(stage));
        gl_.ShaderSource(shader, 1, &text, nullptr);
        gl_.CompileShader(shader);
        gl_.AttachShader(made, shader);
    }
    gl_.LinkProgram(made);
    GLint is_linked = 0;
    gl_.GetProgramiv(made, GL_LINK_STATUS, &is_linked);
    if (!is_linked)
        stop("a shader does not link");
    return made;
}

Frame::Target Frame::target(GLenum format, int colors, bool has_depth)
{
    Target made;
    gl_.GenFramebuffers(1, &made.framebuffer);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, made.framebuffer);
    std::vector<GLenum> buffers;
    for (int i = 0; i < colors + has_depth; ++i) {
        const bool is_depth = i == colors;
        GLuint texture = 0;
        gl_.GenTextures(1, &texture);
        gl_.BindTexture(GL_TEXTURE_2D, texture);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(is_depth ? GL_DEPTH_COMPONENT24 : format), extent_.width,
                       extent_.height, 0, is_depth ? GL_DEPTH_COMPONENT : GL_RGBA, is_depth ? GL_UNSIGNED_INT : GL_FLOAT,
                       nullptr);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        const GLenum place = is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture, 0);
        made.textures.push_back(texture);
        if (!is_depth)
            buffers.push_back(place);
    }
    gl_.DrawBuffers(colors, buffers.data());
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        stop("RGB16F cannot be drawn into here");
    return made;
}

void Frame::begin(const Target& target, GLuint program)
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.UseProgram(program);
}

void Frame::set(GLuint program, const std::string& name, int value)
{
    gl_.Uniform1i(gl_.GetUniformLocation(program, name.c_str()), value);
}

void Frame::set(GLuint program, const std::string& name, const glm::vec3& value)
{
    gl_.Uniform3f(gl_.GetUniformLocation(program, name.c_str()), value.x, value.y, value.z);
}

void Frame::set(GLuint program, const std::string& name, const glm::mat4& value)
{
    gl_.UniformMatrix4fv(gl_.GetUniformLocation(program, name.c_str()), 1, GL_FALSE, glm::value_ptr(value));
}

void Frame::read(GLuint program, int unit, const std::string& name, GLuint texture)
{
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    set(program, name, unit);
}

void Frame::draw_geometry()
{
    begin(g_buffer_, geometry_);
    set(geometry_, "view", view_);
    set(geometry_, "projection", projection_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    for (const Drawn& drawn : drawn_) {
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(drawn.vertices.size() * sizeof(passgraph::Vertex)),
                       drawn.vertices.data(), GL_STATIC_DRAW);
        constexpr GLsizei kStride = sizeof(passgraph::Vertex);
        for (const auto& [location, count, offset] :
             {std::tuple{0u, 3, offsetof(passgraph::Vertex, position)}, std::tuple{1u, 3, offsetof(passgraph::Vertex, normal)},
              std::tuple{2u, 2, offsetof(passgraph::Vertex, uv)}}) {
            gl_.EnableVertexAttribArray(location);
            gl_.VertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, kStride, reinterpret_cast<const void*>(offset));
        }
        set(geometry_, "model", drawn.model);
        read(geometry_, 0, "color_texture", drawn.color);
        read(geometry_, 1, "material_texture", drawn.material);
        gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(drawn.vertices.size()));
    }
}

void Frame::draw_screen()
{
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_STATIC_DRAW);
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 5 * sizeof(float), nullptr);
    gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, 5 * sizeof(float), reinterpret_cast<const void*>(3 * sizeof(float)));
    gl_.DrawArrays(GL_TRIANGLES, 0, 6);
}

void Frame::light()
{
    begin(lit_, lighting_);
    int unit = 0;
    for (const char* name : {"diffuse_map", "normal_map", "position_map", "material_map"}) {
        read(lighting_, unit, name, g_buffer_.textures[static_cast<size_t>(unit)]);
        ++unit;
    }
    int count = 0;
    for (const passgraph::Light& light : scene_.lights) {
        if (count == 8)
            break;
        const std::string name = "lamps[" + std::to_string(count++) + "].";
        set(lighting_, name + "color", light.color);
        set(lighting_, name + "position", glm::vec3(view_ * glm::vec4(glm::vec3(light.position), 1.0f)));
        set(lighting_, name + "direction", glm::mat3(view_) * light.direction);
        set(lighting_, name + "kind", light.kind == passgraph::Light::Kind::point ? 1 : 0);
    }
    set(lighting_, "lamp_count", count);
    draw_screen();
}

PassTimes Frame::draw()
{
    const std::array<std::function<void()>, kPasses.size()> passes = {
        [&] { draw_geometry(); },
        [&] { light(); },
        [&] {
            begin(rows_, blur_);
            read(blur_, 0, "image", lit_.textures[1]);
            set(blur_, "is_horizontal", 1);
            draw_screen();
        },
        [&] {
            begin(glow_, blur_);
            read(blur_, 0, "image", rows_.textures[0]);
            set(blur_, "is_horizontal", 0);
            draw_screen();
        },
        [&] {
            begin(shown_, combine_);
            read(combine_, 0, "scene", lit_.textures[0]);
            read(combine_, 1, "bloom", glow_.textures[0]);
            set(combine_, "is_night", 0);
            draw_screen();
        }};
    PassTimes times{};
    gl_.Finish();
    for (size_t i = 0; i < passes.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        passes[i]();
        gl_.Finish();
        times[i] = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
    if (gl_.GetError() != GL_NO_ERROR)
        stop("a GL error");
    return times;
}

std::string Frame::device() const { return reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER)); }

double Frame::sky_share()
{
    std::vector<float> places(static_cast<size_t>(extent_.width) * static_cast<size_t>(extent_.height) * 3);
    Target only_position;
    gl_.GenFramebuffers(1, &only_position.framebuffer);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, only_position.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, g_buffer_.textures[2], 0);
    gl_.ReadPixels(0, 0, extent_.width, extent_.height, GL_RGB, GL_FLOAT, places.data());
    size_t sky = 0;
    for (size_t i = 2; i < places.size(); i += 3)
        sky += places[i] == 0.0f;
    return static_cast<double>(sky) * 3.0 / static_cast<double>(places.size());
}

std::vector<unsigned char> Frame::pixels()
{
    std::vector<unsigned char> rgba(static_cast<size_t>(extent_.width) * static_cast<size_t>(extent_.height) * 4);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, shown_.framebuffer);
    gl_.ReadPixels(0, 0, extent_.width, extent_.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

} // namespace original
