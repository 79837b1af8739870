// Binding and drawing of one step.
#include "gl/drawing.hpp"

#include <passgraph/core/glsl_interface.hpp>

namespace passgraph::gl {
namespace {

/// A cube map as a step reads it.
struct CubeRead {
    GLuint texture = 0;
    const Harmonics* harmonics = nullptr;
};

/// The cube a sky import stands for is the host's own, else the scene's, else black.
CubeRead cube_of(const DrawInputs& inputs, const ImportTexture& import)
{
    if (import.id != 0 || import.import.kind != Plan::Import::Kind::sky)
        return {import.id, &import.harmonics};
    const bool has_sky = inputs.scene != nullptr && inputs.scene->sky.texture;
    const Cube& cube = has_sky ? inputs.scene->sky : inputs.black_cube;
    return {cube.texture.id(), &cube.harmonics};
}

/// The scene's atlas that an import stands for; its signal tells which.
GLuint atlas_texture(const DrawInputs& inputs, const Plan::Import& import)
{
    const AtlasTextures& atlas = inputs.scene->atlas;
    return import.signal == Signal::albedo     ? atlas.albedo.id()
           : import.signal == Signal::material ? atlas.material.id()
                                               : atlas.emissive.id();
}

void bind_reads(const DrawInputs& inputs, const Plan::Step& step, const StepObjects& objects, const Program& program)
{
    for (size_t i = 0; i < step.reads.size(); ++i) {
        const Plan::Read& read = step.reads[i];
        const int unit = program.read_units[i];
        const bool is_import = read.source == Plan::Read::Source::import;
        const ImportTexture* import = is_import ? &inputs.imports[read.index] : nullptr;
        const CubeRead cube = import && import->is_cube() ? cube_of(inputs, *import) : CubeRead{};
        if (cube.harmonics)
            send_harmonics(inputs.gl, program, i, *cube.harmonics);
        if (unit < 0)
            continue;
        if (read.is_loaded) {
            inputs.state.image(unit, inputs.slots[static_cast<size_t>(read.index)].id(), objects.bindings[i].loaded_format);
            continue;
        }
        if (!import) {
            inputs.state.texture(unit, GL_TEXTURE_2D, inputs.slots[static_cast<size_t>(read.index)].id());
            inputs.state.sampler(unit, objects.bindings[i].plain);
            continue;
        }
        if (import->import.kind == Plan::Import::Kind::atlas) {
            inputs.state.texture(unit, GL_TEXTURE_2D, atlas_texture(inputs, import->import));
            inputs.state.sampler(unit, objects.bindings[i].plain);
            continue;
        }
        const bool has_levels = import->has_levels || (cube.harmonics && import->id == 0);
        inputs.state.texture(unit, import->target(), cube.harmonics ? cube.texture : import->id);
        inputs.state.sampler(unit, has_levels ? objects.bindings[i].with_levels : objects.bindings[i].plain);
    }
}

void bind_lights(const DrawInputs& inputs, const Program& program)
{
    if (inputs.scene == nullptr)
        return;
    if (program.scene.lights >= 0)
        inputs.state.texture(program.scene.lights, GL_TEXTURE_BUFFER, inputs.scene->lights.texture.id());
    if (program.light_rows > 0)
        inputs.gl.Uniform4fv(program.light_rows_location, program.light_rows, &inputs.scene->light_rows.front().x);
}

void bind_atlas(const DrawInputs& inputs, const SceneUnits& units)
{
    const AtlasTextures& atlas = inputs.scene->atlas;
    for (const auto& [unit, texture] : {std::pair{units.atlas_albedo, &atlas.albedo},
                                        {units.atlas_material, &atlas.material},
                                        {units.atlas_emissive, &atlas.emissive}}) {
        if (unit < 0)
            continue;
        inputs.state.texture(unit, GL_TEXTURE_2D, texture->id());
        inputs.state.sampler(unit, atlas.sampler);
    }
}

/// A step's textures are shared over time, so what they hold is of no use: colors become 0, depth far away.
void clear_targets(const DrawInputs& inputs, const Plan::Step& step)
{
    constexpr GLfloat kZero[] = {0.0f, 0.0f, 0.0f, 0.0f};
    for (size_t i = 0; i < step.targets.size(); ++i)
        inputs.gl.ClearBufferfv(GL_COLOR, static_cast<GLint>(i), kZero);
    if (step.depth_slot >= 0)
        inputs.gl.ClearBufferfv(GL_DEPTH, 0, kZero);
}

std::int64_t draw_elements(const DrawInputs& inputs, const Program& program)
{
    bind_atlas(inputs, program.scene);
    for (const ElementDraw& draw : inputs.scene->draws) {
        const MeshBuffers& mesh = inputs.scene->meshes[static_cast<size_t>(draw.mesh)];
        inputs.state.vertex_array(mesh.vertex_array.id());
        inputs.state.cull_back_faces(!draw.is_double_sided);
        inputs.state.mirrored_front_face(draw.is_mirrored);
        const size_t first_row = static_cast<size_t>(draw.element) * glsl::kElementRows;
        inputs.gl.Uniform4fv(program.element_location, glsl::kElementRows, &inputs.scene->element_rows[first_row].x);
        const size_t first_level = static_cast<size_t>(draw.element) * glsl::kAtlasLevelCount;
        inputs.gl.Uniform4fv(program.levels_location, glsl::kAtlasLevelCount,
                             &inputs.scene->element_levels[first_level].x);
        inputs.gl.DrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr);
    }
    return static_cast<std::int64_t>(inputs.scene->draws.size());
}

/// Everything that a program's draws read.
void use(const DrawInputs& inputs, const Plan::Step& step, const StepObjects& objects, Program& program)
{
    inputs.state.use_program(program.id());
    bind_reads(inputs, step, objects, program);
    bind_lights(inputs, program);
    send_uniforms(inputs.gl, program);
}

void draw_triangle(const DrawInputs& inputs)
{
    inputs.state.cull_back_faces(false);
    inputs.state.vertex_array(inputs.empty_vertex_array);
    inputs.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

/// Draws under a condition on what a query has counted; the query 0 means none.
class Condition {
public:
    Condition(const Functions& gl, GLuint query, GLenum mode) : gl_(gl), is_on_(query != 0)
    {
        if (is_on_)
            gl_.BeginConditionalRender(query, mode);
    }
    ~Condition()
    {
        if (is_on_)
            gl_.EndConditionalRender();
    }
    Condition(const Condition&) = delete;
    Condition& operator=(const Condition&) = delete;

private:
    const Functions& gl_;
    bool is_on_;
};

/// Counts pixels; the query 0 means none.
class Counting {
public:
    Counting(const Functions& gl, GLuint query) : gl_(gl), is_on_(query != 0)
    {
        if (is_on_)
            gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, query);
    }
    ~Counting()
    {
        if (is_on_)
            gl_.EndQuery(GL_ANY_SAMPLES_PASSED);
    }
    Counting(const Counting&) = delete;
    Counting& operator=(const Counting&) = delete;

private:
    const Functions& gl_;
    bool is_on_;
};

/// Whatever is not drawn is black. Outside of any condition, which a clear would be under too.
void clear_to_black(const DrawInputs& inputs, const Plan::Step& step)
{
    for (size_t i = 0; i < step.targets.size(); ++i)
        inputs.gl.ClearBufferfv(GL_COLOR, static_cast<GLint>(i), step.targets[i].black.data());
}

/// One triangle for the whole picture, or one for its surfaces and, unless that was cleared, one for its background.
std::int64_t draw_parts(const DrawInputs& inputs, const Plan::Step& step, StepObjects& objects)
{
    State& state = inputs.state;
    state.depth(step.tested_depth_slot >= 0 ? State::Depth::surfaces : State::Depth::unused);
    draw_triangle(inputs);
    if (!objects.background)
        return 1;
    use(inputs, step, objects, *objects.background);
    state.depth(State::Depth::background);
    draw_triangle(inputs);
    return 2;
}

/// Looks whether the step is to be drawn. What it leaves in the targets is cleared with them: the step counts.
std::int64_t draw_scout(const DrawInputs& inputs, const Plan::Step& step, StepObjects& objects, const StepQueries& queries)
{
    use(inputs, step, objects, *objects.scout);
    inputs.state.viewport(inputs.only_warms_up ? Extent{1, 1} : step.scout_extent);
    inputs.state.depth(State::Depth::unused);
    {
        const Counting counting(inputs.gl, queries.counts);
        draw_triangle(inputs);
    }
    return 1;
}

std::int64_t draw_variant(const DrawInputs& inputs, const Plan::Step& step, StepObjects& objects, GLuint query)
{
    use(inputs, step, objects, *objects.when_skipped);
    const Condition condition(inputs.gl, query, GL_QUERY_WAIT_INVERTED);
    draw_triangle(inputs);
    return 1;
}

} // namespace

std::int64_t draw_step(const DrawInputs& inputs, const Plan::Step& step, StepObjects& objects, const StepQueries& queries)
{
    const bool has_variant = objects.when_skipped.has_value();
    // Without inverted conditions there are no variants that know what is black: everybody may look.
    const bool is_read = step.is_cleared || !inputs.gl.has_inverted_conditions;
    if (queries.is_known_black && !has_variant && !is_read)
        return 0; // there is nothing that the device had to decide
    State& state = inputs.state;
    state.draw_framebuffer(objects.framebuffer.id());
    state.encodes_srgb(objects.has_srgb_target);
    std::int64_t draws = 0;
    if (queries.scouts || (objects.scout && inputs.only_warms_up))
        draws += draw_scout(inputs, step, objects, queries);
    state.viewport(inputs.only_warms_up ? Extent{1, 1} : step.extent);
    use(inputs, step, objects, objects.program);
    if (step.kind == Plan::Step::Kind::geometry) {
        state.depth(State::Depth::tested_and_written);
        clear_targets(inputs, step);
        return draw_elements(inputs, objects.program);
    }
    const bool is_background_black = step.tested_depth_slot >= 0 && step.background.empty();
    if (is_background_black || step.counts >= 0 || (queries.skipped_by != 0 && !has_variant && is_read))
        clear_to_black(inputs, step);
    {
        const Counting counting(inputs.gl, queries.scouts ? 0 : queries.counts);
        const Condition condition(inputs.gl, queries.scouts ? queries.counts : queries.skipped_by, GL_QUERY_WAIT);
        draws += draw_parts(inputs, step, objects);
    }
    if (has_variant && (queries.skipped_by != 0 || inputs.only_warms_up))
        draws += draw_variant(inputs, step, objects, queries.skipped_by);
    return draws;
}

} // namespace passgraph::gl
