// The program of one step: compiled, linked, with every location looked up and every sampler given its unit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <passgraph/core/plan.hpp>

#include "gl/cube_filter.hpp"
#include "gl/program_pool.hpp"
#include "gl/state.hpp"

namespace passgraph::gl {

/// A live parameter's place in a program. Its value goes to the driver with the next draw when another was sent last.
struct LiveUniform {
    GLint location = -1;
    ParamType type = ParamType::float_;
    Value value;
};

/// Units of the buffer and atlas textures; -1 when the program has no such sampler.
struct SceneUnits {
    int lights = -1;
    int atlas_albedo = -1;
    int atlas_material = -1;
    int atlas_emissive = -1;
};
inline constexpr int kSceneUnits = 4;

struct Program {
    std::shared_ptr<LinkedProgram> linked;
    std::vector<int> read_units;       ///< per read of the step, of textures or of images; -1 when the code never fetches it
    std::vector<GLint> harmonics;      ///< per read: where a cube's irradiance goes; -1 when the code never asks for it
    std::vector<LiveUniform> uniforms; ///< per uniform of the step
    SceneUnits scene;
    GLint element_location = -1;
    GLint levels_location = -1;
    GLint light_rows_location = -1;
    GLsizei light_rows = 0; ///< that the program takes
    Units units;

    GLuint id() const { return linked ? linked->object.id() : 0; }
};

/// Compiles and links the step's program.
/// Errors   shader_failed (with the source file's own line).
Result<std::shared_ptr<LinkedProgram>> link_program(Driver& driver, const Plan::Step& step);

/// Looks up what a linked program of this step needs for its draws.
/// Errors   texture_units_exceeded, image_units_exceeded.
Result<Program> wire_program(Driver& driver, State& state, const Plan::Step& step, std::shared_ptr<LinkedProgram> linked);

/// Both.
Result<Program> create_program(Driver& driver, State& state, const Plan::Step& step);

/// A number that changes when one of the values does.
std::uint64_t version_of(const std::vector<LiveUniform>& uniforms);

/// Sends the irradiance of the cube that a read reads to the program, which is the current one, unless it is there already.
void send_harmonics(const Functions& gl, const Program& program, size_t read, const Harmonics& harmonics);

/// Sends changed values to the program, which is the current one.
void send_uniforms(const Functions& gl, Program& program);

} // namespace passgraph::gl
