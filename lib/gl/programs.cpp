// Compiling, linking and wiring of a step's program.
#include "gl/programs.hpp"

#include <array>
#include <bit>
#include <iterator>

#include <fmt/format.h>

#include <passgraph/core/glsl_interface.hpp>

#include "gl/freshness.hpp"
#include "gl/shader_log.hpp"
#include "gl/state_names.hpp"

namespace passgraph::gl {
namespace {

void compile(const Functions& gl, const ShaderObject& shader, const std::string& glsl)
{
    const GLchar* text = glsl.c_str();
    gl.ShaderSource(shader.id(), 1, &text, nullptr);
    gl.CompileShader(shader.id());
}

std::string shader_log(const Functions& gl, const ShaderObject& shader)
{
    GLint length = 0;
    gl.GetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    gl.GetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
    return log;
}

std::string program_log(const Functions& gl, GLuint program)
{
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
    return log;
}

/// The compiled stage; on failure it is compiled once more with folded source numbers, for the place of the error.
Result<ShaderObject> create_shader(Driver& driver, GLenum stage, const Plan::Step& step)
{
    const bool is_vertex = stage == GL_VERTEX_SHADER;
    const std::string& glsl = is_vertex ? step.vertex : step.fragment;
    const Functions& gl = driver.gl;
    ShaderObject shader(driver, stage);
    compile(gl, shader, glsl);
    GLint is_compiled = GL_FALSE;
    gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled == GL_TRUE)
        return shader;
    compile(gl, shader, folded_source_numbers(glsl));
    const std::string subject = fmt::format("step `{}`, {} stage", step.name, is_vertex ? "vertex" : "fragment");
    return tl::unexpected(shader_errors(shader_log(gl, shader), subject, step.sources));
}

Result<ProgramObject> link(Driver& driver, const Plan::Step& step)
{
    Result<ShaderObject> vertex = create_shader(driver, GL_VERTEX_SHADER, step);
    Result<ShaderObject> fragment = create_shader(driver, GL_FRAGMENT_SHADER, step);
    Errors errors;
    for (const Result<ShaderObject>* stage : {&vertex, &fragment})
        if (!*stage)
            errors.insert(errors.end(), stage->error().begin(), stage->error().end());
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    const Functions& gl = driver.gl;
    ProgramObject program(driver);
    gl.AttachShader(program.id(), vertex->id());
    gl.AttachShader(program.id(), fragment->id());
    gl.LinkProgram(program.id());
    gl.DetachShader(program.id(), vertex->id());
    gl.DetachShader(program.id(), fragment->id());
    GLint is_linked = GL_FALSE;
    gl.GetProgramiv(program.id(), GL_LINK_STATUS, &is_linked);
    if (is_linked == GL_TRUE)
        return program;
    return tl::unexpected(
        shader_errors(program_log(gl, program.id()), fmt::format("step `{}`, linking", step.name), step.sources));
}

void bind_block(const Functions& gl, GLuint program, const char* name, int binding)
{
    const GLuint index = gl.GetUniformBlockIndex(program, name);
    if (index != GL_INVALID_INDEX)
        gl.UniformBlockBinding(program, index, static_cast<GLuint>(binding));
}

/// Gives a sampler the next free unit, if the program has that sampler. A unit is never shared: two kinds of sampler on
/// one unit make every draw an error.
int assign_unit(const Functions& gl, const Program& program, const char* sampler, int& units)
{
    const GLint location = gl.GetUniformLocation(program.id(), sampler);
    if (location < 0)
        return -1;
    gl.Uniform1i(location, units);
    return units++;
}

Error units_exceeded(const Plan::Step& step, const char* code, std::string_view what, int used, int most)
{
    return {.code = code,
            .message = fmt::format("step `{}` reads {} {}, the device has {} units for them", step.name, used, what, most),
            .hint = "compile with the device's limits (query_device)",
            .fault = Fault::machine};
}

} // namespace

Result<std::shared_ptr<LinkedProgram>> link_program(Driver& driver, const Plan::Step& step)
{
    Result<ProgramObject> object = link(driver, step);
    if (!object)
        return tl::unexpected(object.error());
    auto linked = std::make_shared<LinkedProgram>();
    linked->object = std::move(*object);
    linked->sent.resize(step.uniforms.size());
    linked->harmonics_sent.resize(step.reads.size());
    return linked;
}

Result<Program> create_program(Driver& driver, State& state, const Plan::Step& step)
{
    Result<std::shared_ptr<LinkedProgram>> linked = link_program(driver, step);
    if (!linked)
        return tl::unexpected(linked.error());
    return wire_program(driver, state, step, std::move(*linked));
}

namespace {

/// A driver may keep fewer rows than the text declares, when the last are not read.
void find_light_rows(const Functions& gl, Program& program)
{
    program.light_rows_location = gl.GetUniformLocation(program.id(), glsl::kLightRows);
    constexpr GLsizei kMost = glsl::kFewLights * glsl::kLightTexels;
    while (program.light_rows_location >= 0 && program.light_rows < kMost &&
           gl.GetUniformLocation(program.id(), fmt::format("{}[{}]", glsl::kLightRows, program.light_rows).c_str()) >= 0)
        ++program.light_rows;
}

} // namespace

Result<Program> wire_program(Driver& driver, State& state, const Plan::Step& step, std::shared_ptr<LinkedProgram> linked)
{
    const Functions& gl = driver.gl;
    Program program;
    program.linked = std::move(linked);
    const GLuint id = program.id();
    state.use_program(id);
    for (const Plan::Read& read : step.reads) {
        int& units = read.is_loaded ? program.units.images : program.units.textures;
        program.read_units.push_back(assign_unit(gl, program, read.sampler.c_str(), units));
        program.harmonics.push_back(gl.GetUniformLocation(id, glsl::harmonics_name(read.sampler).c_str()));
    }
    program.scene.lights = assign_unit(gl, program, glsl::kLightsBuffer, program.units.textures);
    program.scene.atlas_albedo = assign_unit(gl, program, glsl::kAtlasAlbedo, program.units.textures);
    program.scene.atlas_material = assign_unit(gl, program, glsl::kAtlasMaterial, program.units.textures);
    program.scene.atlas_emissive = assign_unit(gl, program, glsl::kAtlasEmissive, program.units.textures);
    if (program.units.textures > driver.limits.texture_units)
        return fail(units_exceeded(step, "texture_units_exceeded", "textures", program.units.textures, driver.limits.texture_units));
    if (program.units.images > driver.limits.image_units)
        return fail(units_exceeded(step, "image_units_exceeded", "images by texel", program.units.images, driver.limits.image_units));
    bind_block(gl, id, glsl::kCameraBlock, kCameraBinding);
    bind_block(gl, id, glsl::kFrameBlock, kFrameBinding);
    program.element_location = gl.GetUniformLocation(id, glsl::kElement);
    program.levels_location = gl.GetUniformLocation(id, glsl::kAtlasLevels);
    find_light_rows(gl, program);
    for (const Plan::Uniform& uniform : step.uniforms)
        program.uniforms.push_back({.location = gl.GetUniformLocation(id, uniform.name.c_str()),
                                    .type = uniform.type,
                                    .value = uniform.value});
    return program;
}

std::uint64_t version_of(const std::vector<LiveUniform>& uniforms)
{
    std::uint64_t version = 0;
    for (const LiveUniform& uniform : uniforms)
        for (const double component : uniform.value.v)
            version = mixed(version, std::bit_cast<std::uint64_t>(component));
    return version;
}

void send_harmonics(const Functions& gl, const Program& program, size_t read, const Harmonics& harmonics)
{
    const GLint location = program.harmonics[read];
    if (location < 0)
        return;
    std::vector<std::optional<Harmonics>>& sent = program.linked->harmonics_sent;
    if (sent[read] == harmonics)
        return;
    sent[read] = harmonics;
    gl.Uniform3fv(location, glsl::kHarmonics, &harmonics[0].x);
}

void send_uniforms(const Functions& gl, Program& program)
{
    for (size_t u = 0; u < program.uniforms.size(); ++u) {
        const LiveUniform& uniform = program.uniforms[u];
        std::optional<Value>& sent = program.linked->sent[u];
        if (sent == uniform.value)
            continue;
        sent = uniform.value;
        std::array<GLfloat, 4> v{};
        for (size_t i = 0; i < v.size(); ++i)
            v[i] = static_cast<GLfloat>(uniform.value.v[i]);
        switch (uniform.type) {
        case ParamType::float_: gl.Uniform1fv(uniform.location, 1, v.data()); break;
        case ParamType::int_:
        case ParamType::bool_:
        case ParamType::enum_: gl.Uniform1i(uniform.location, static_cast<GLint>(uniform.value.v[0])); break;
        case ParamType::vec2: gl.Uniform2fv(uniform.location, 1, v.data()); break;
        case ParamType::color:
        case ParamType::vec3: gl.Uniform3fv(uniform.location, 1, v.data()); break;
        case ParamType::vec4: gl.Uniform4fv(uniform.location, 1, v.data()); break;
        }
    }
}

} // namespace passgraph::gl
