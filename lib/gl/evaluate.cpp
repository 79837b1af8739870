// One draw that evaluates an expression for every row of a table: a texel per row.
#include <passgraph/gl/evaluate.hpp>

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "gl/programs.hpp"
#include "gl/read_back.hpp"

namespace passgraph {
namespace {

constexpr const char* kTable = "passgraph_table";

constexpr const char* kVertex = R"(#version 330 core
void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// The expression's value in the channels it has; the others are 0.
std::string widened(int components)
{
    switch (components) {
    case 1: return "vec4(float(passgraph_value), 0.0, 0.0, 0.0)";
    case 2: return "vec4(passgraph_value, 0.0, 0.0)";
    case 3: return "vec4(passgraph_value, 0.0)";
    default: return "passgraph_value";
    }
}

/// Rows lie in blocks of `rows`, one block per column on top of another.
std::string fragment_text(const Evaluation& evaluation, Extent rows)
{
    const std::string type = evaluation.components == 1 ? "float" : fmt::format("vec{}", evaluation.components);
    std::string text = fmt::format("#version 330 core\nuniform sampler2D {};\nout vec4 passgraph_result;\n", kTable);
    text += evaluation.declarations + "\n";
    text += "void main()\n{\n    ivec2 passgraph_row = ivec2(gl_FragCoord.xy);\n";
    for (size_t i = 0; i < evaluation.columns.size(); ++i)
        text += fmt::format("    float {} = texelFetch({}, passgraph_row + ivec2(0, {}), 0).r;\n", evaluation.columns[i],
                            kTable, i * static_cast<size_t>(rows.height));
    // A line of its own: a driver's complaint then names the expression, and a comment in it ends there.
    text += fmt::format("    {0} passgraph_value = {0}(\n#line 1 {1}\n{2}\n);\n", type, evaluation.sources.size(),
                        evaluation.expression);
    return text + fmt::format("    passgraph_result = {};\n}}\n", widened(evaluation.components));
}

Result<Extent> rows_extent(const Evaluation& evaluation, const gl::Limits& limits)
{
    const size_t most = static_cast<size_t>(limits.texture_size);
    const size_t width = std::min(evaluation.rows.size(), most);
    const size_t height = (evaluation.rows.size() + width - 1) / width;
    const size_t blocks = std::max<size_t>(evaluation.columns.size(), 1);
    if (height * blocks > most)
        return fail({.code = "table_too_large",
                     .message = fmt::format("{} rows of {} columns do not fit a texture of {} texels each way",
                                            evaluation.rows.size(), evaluation.columns.size(), most),
                     .hint = "split the table",
                     .fault = Fault::machine});
    return Extent{static_cast<int>(width), static_cast<int>(height)};
}

gl::TextureObject create_table(gl::Upload& upload, const Evaluation& evaluation, Extent rows)
{
    const size_t block = static_cast<size_t>(rows.width) * static_cast<size_t>(rows.height);
    const size_t blocks = std::max<size_t>(evaluation.columns.size(), 1);
    std::vector<float> texels(block * blocks);
    for (size_t row = 0; row < evaluation.rows.size(); ++row) {
        assert(evaluation.rows[row].size() == evaluation.columns.size());
        for (size_t column = 0; column < evaluation.columns.size(); ++column)
            texels[column * block + row] = evaluation.rows[row][column];
    }
    gl::TextureObject texture(upload.driver);
    upload.state.edit_texture(GL_TEXTURE_2D, texture.id());
    const gl::Functions& gl = upload.driver.gl;
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, rows.width, rows.height * static_cast<GLsizei>(blocks), 0, GL_RED, GL_FLOAT,
                  texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

/// Draws every row's texel into `target`.
Result<void> draw(gl::Upload& upload, gl::Program& program, GLuint table, GLuint sampler, GLuint target, Extent rows)
{
    const gl::Functions& gl = upload.driver.gl;
    gl::State& state = upload.state;
    const gl::FramebufferObject framebuffer(upload.driver);
    const gl::VertexArrayObject no_vertices(upload.driver);
    state.draw_framebuffer(framebuffer.id());
    gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    constexpr GLenum kFirst = GL_COLOR_ATTACHMENT0;
    gl.DrawBuffers(1, &kFirst);
    if (gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return fail({.code = "framebuffer_incomplete",
                     .message = "this device cannot draw into rgba32f",
                     .hint = "use another device, or Mesa's software renderer",
                     .fault = Fault::machine});
    state.depth(gl::State::Depth::unused);
    state.cull_back_faces(false);
    state.viewport(rows);
    state.use_program(program.id());
    state.vertex_array(no_vertices.id());
    if (const int unit = program.read_units.front(); unit >= 0) {
        state.texture(unit, GL_TEXTURE_2D, table);
        state.sampler(unit, sampler);
    }
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.UseProgram(0); // the program is deleted next, and the current one would outlive that
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

} // namespace

Result<std::vector<std::vector<float>>> evaluate(const Evaluation& evaluation, GlLoader loader)
{
    assert(evaluation.components >= 1 && evaluation.components <= 4);
    if (evaluation.rows.empty())
        return {};
    Result<gl::Driver> driver = gl::create_driver(loader);
    if (!driver)
        return tl::unexpected(std::move(driver.error()));
    const Result<Extent> rows = rows_extent(evaluation, driver->limits);
    if (!rows)
        return tl::unexpected(rows.error());

    gl::State state(*driver);
    gl::ErrorWatch watch(*driver);
    gl::Upload upload{*driver, state, watch};
    state.reset();
    gl::Samplers samplers(*driver);
    const GLuint nearest = samplers.get(Filter::nearest, AddressMode::clamp, AddressMode::clamp, false);

    Plan::Step step;
    step.name = evaluation.expression;
    step.reads.push_back({.sampler = kTable, .image = "table"});
    step.vertex = kVertex;
    step.fragment = fragment_text(evaluation, *rows);
    step.sources = evaluation.sources;
    step.sources.push_back("expression");
    Result<gl::Program> program = gl::create_program(*driver, state, step);
    if (!program)
        return tl::unexpected(program.error());

    const gl::Reader reader(upload);
    const gl::TextureObject table = create_table(upload, evaluation, *rows);
    const gl::TextureObject target = gl::create_target(upload, Format::rgba32f, *rows);
    if (Result<void> drawn = draw(upload, *program, table.id(), nearest, target.id(), *rows); !drawn)
        return tl::unexpected(drawn.error());
    const Result<Picture> values = reader.read(upload, target.id(), Format::rgba32f, {0, 0, *rows});
    if (!values)
        return tl::unexpected(values.error());

    std::vector<std::vector<float>> result(evaluation.rows.size());
    for (size_t row = 0; row < result.size(); ++row) {
        const auto first = values->texels.begin() + static_cast<std::ptrdiff_t>(row * 4);
        result[row].assign(first, first + evaluation.components);
    }
    return result;
}

} // namespace passgraph
