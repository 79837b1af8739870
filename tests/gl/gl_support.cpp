// The test context, the spying loader and the plan builder.
#include "gl_support.hpp"

#include <memory>

// Mesa's off-screen library keeps its last buffer for ever. What we own is counted by the spy.
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libOSMesa";
}

namespace passgraph::test {
namespace {

void* (*real_loader())(const char*)
{
    return test_loader();
}

template <class Function> Function real(const char* name)
{
    return reinterpret_cast<Function>(real_loader()(name));
}

#define PASSGRAPH_SPY_GEN(name)                                                                                        \
    void APIENTRY spy_##name(GLsizei count, GLuint* ids)                                                               \
    {                                                                                                                  \
        spy().objects_alive += count;                                                                                  \
        real<PFNGLGENTEXTURESPROC>("gl" #name)(count, ids);                                                            \
    }
#define PASSGRAPH_SPY_DELETE(name)                                                                                     \
    void APIENTRY spy_##name(GLsizei count, const GLuint* ids)                                                         \
    {                                                                                                                  \
        spy().objects_alive -= count;                                                                                  \
        real<PFNGLDELETETEXTURESPROC>("gl" #name)(count, ids);                                                         \
    }
PASSGRAPH_SPY_GEN(GenTextures)
PASSGRAPH_SPY_GEN(GenFramebuffers)
PASSGRAPH_SPY_GEN(GenSamplers)
PASSGRAPH_SPY_GEN(GenVertexArrays)
PASSGRAPH_SPY_GEN(GenBuffers)
PASSGRAPH_SPY_GEN(GenQueries)
PASSGRAPH_SPY_DELETE(DeleteTextures)
PASSGRAPH_SPY_DELETE(DeleteFramebuffers)
PASSGRAPH_SPY_DELETE(DeleteSamplers)
PASSGRAPH_SPY_DELETE(DeleteVertexArrays)
PASSGRAPH_SPY_DELETE(DeleteBuffers)
PASSGRAPH_SPY_DELETE(DeleteQueries)

GLuint APIENTRY spy_CreateProgram()
{
    ++spy().objects_alive;
    return real<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
}
GLuint APIENTRY spy_CreateShader(GLenum stage)
{
    ++spy().objects_alive;
    return real<PFNGLCREATESHADERPROC>("glCreateShader")(stage);
}
void APIENTRY spy_DeleteProgram(GLuint id)
{
    --spy().objects_alive;
    real<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(id);
}
void APIENTRY spy_DeleteShader(GLuint id)
{
    --spy().objects_alive;
    real<PFNGLDELETESHADERPROC>("glDeleteShader")(id);
}
void APIENTRY spy_UseProgram(GLuint id)
{
    ++spy().calls["glUseProgram"];
    real<PFNGLUSEPROGRAMPROC>("glUseProgram")(id);
}
void APIENTRY spy_LinkProgram(GLuint id)
{
    ++spy().calls["glLinkProgram"];
    real<PFNGLLINKPROGRAMPROC>("glLinkProgram")(id);
}
void APIENTRY spy_BindTexture(GLenum target, GLuint id)
{
    ++spy().calls["glBindTexture"];
    real<PFNGLBINDTEXTUREPROC>("glBindTexture")(target, id);
}
void APIENTRY spy_Viewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
    ++spy().calls["glViewport"];
    real<PFNGLVIEWPORTPROC>("glViewport")(x, y, width, height);
}
void APIENTRY spy_Uniform1fv(GLint location, GLsizei count, const GLfloat* values)
{
    ++spy().calls["glUniform1fv"];
    real<PFNGLUNIFORM1FVPROC>("glUniform1fv")(location, count, values);
}
void APIENTRY spy_BufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data)
{
    ++spy().calls["glBufferSubData"];
    real<PFNGLBUFFERSUBDATAPROC>("glBufferSubData")(target, offset, size, data);
}
GLint APIENTRY spy_GetUniformLocation(GLuint program, const GLchar* name)
{
    ++spy().calls["glGetUniformLocation"];
    return real<PFNGLGETUNIFORMLOCATIONPROC>("glGetUniformLocation")(program, name);
}
void APIENTRY spy_GetIntegerv(GLenum name, GLint* values)
{
    real<PFNGLGETINTEGERVPROC>("glGetIntegerv")(name, values);
    if (spy().version != 0 && name == GL_MAJOR_VERSION)
        *values = spy().version / 10;
    if (spy().version != 0 && name == GL_MINOR_VERSION)
        *values = spy().version % 10;
    if (spy().version != 0 && name == GL_NUM_EXTENSIONS)
        *values = 0;
}
GLenum APIENTRY spy_CheckFramebufferStatus(GLenum target)
{
    const GLenum truth = real<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus")(target);
    return spy().framebuffer_status != 0 ? spy().framebuffer_status : truth;
}
bool error_is_due = false;
void APIENTRY spy_TexImage2D(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
                             GLenum format, GLenum type, const void* texels)
{
    real<PFNGLTEXIMAGE2DPROC>("glTexImage2D")(target, level, internal, width, height, border, format, type, texels);
    error_is_due = spy().next_error != GL_NO_ERROR;
}
GLenum APIENTRY spy_GetError()
{
    if (std::exchange(error_is_due, false))
        return std::exchange(spy().next_error, static_cast<GLenum>(GL_NO_ERROR));
    return real<PFNGLGETERRORPROC>("glGetError")();
}
void APIENTRY spy_DrawArrays(GLenum mode, GLint first, GLsizei count)
{
    ++spy().calls["glDrawArrays"];
    real<PFNGLDRAWARRAYSPROC>("glDrawArrays")(spy().spoils_draws ? 0xffffu : mode, first, count);
}

void* spy_function(const std::string& name)
{
#define PASSGRAPH_SPY_ROW(function) {"gl" #function, reinterpret_cast<void*>(&spy_##function)},
    static const std::map<std::string, void*> rows = {
        PASSGRAPH_SPY_ROW(GenTextures) PASSGRAPH_SPY_ROW(GenFramebuffers) PASSGRAPH_SPY_ROW(
            GenSamplers) PASSGRAPH_SPY_ROW(GenVertexArrays) PASSGRAPH_SPY_ROW(GenBuffers) PASSGRAPH_SPY_ROW(GenQueries)
            PASSGRAPH_SPY_ROW(DeleteTextures) PASSGRAPH_SPY_ROW(DeleteFramebuffers) PASSGRAPH_SPY_ROW(DeleteSamplers)
                PASSGRAPH_SPY_ROW(DeleteVertexArrays) PASSGRAPH_SPY_ROW(DeleteBuffers) PASSGRAPH_SPY_ROW(DeleteQueries)
                    PASSGRAPH_SPY_ROW(CreateProgram) PASSGRAPH_SPY_ROW(CreateShader) PASSGRAPH_SPY_ROW(DeleteProgram)
                        PASSGRAPH_SPY_ROW(DeleteShader) PASSGRAPH_SPY_ROW(UseProgram) PASSGRAPH_SPY_ROW(LinkProgram) PASSGRAPH_SPY_ROW(BindTexture)
                            PASSGRAPH_SPY_ROW(Viewport) PASSGRAPH_SPY_ROW(Uniform1fv) PASSGRAPH_SPY_ROW(BufferSubData)
                                PASSGRAPH_SPY_ROW(GetUniformLocation) PASSGRAPH_SPY_ROW(GetIntegerv)
                                    PASSGRAPH_SPY_ROW(CheckFramebufferStatus) PASSGRAPH_SPY_ROW(TexImage2D)
                                        PASSGRAPH_SPY_ROW(GetError) PASSGRAPH_SPY_ROW(DrawArrays)};
    const auto row = rows.find(name);
    return row == rows.end() ? nullptr : row->second;
}

void* load_spied(const char* name)
{
    if (spy().hidden.contains(name))
        return nullptr;
    void* const spied = spy_function(name);
    return spied != nullptr ? spied : real_loader()(name);
}

} // namespace

GlLoader test_loader()
{
    static const std::unique_ptr<Context> context = [] {
        auto made = create_headless_context();
        if (!made)
            FAIL(made.error().message);
        return std::move(*made);
    }();
    return context->loader();
}

Spy& spy()
{
    static Spy the_spy;
    return the_spy;
}

Spy& reset_spy()
{
    error_is_due = false;
    return spy() = {};
}

GlLoader spying_loader()
{
    test_loader();
    return &load_spied;
}

Renderer make_renderer(Plan plan, RendererOptions options)
{
    if (options.loader == nullptr)
        options.loader = test_loader();
    Result<Renderer> renderer = Renderer::create(std::move(plan), options);
    if (!renderer)
        FAIL(to_text(renderer.error()));
    return std::move(*renderer);
}

void require_ok(const Result<void>& result)
{
    if (!result)
        FAIL(to_text(result.error()));
}

Picture render_and_read(Renderer& renderer, const std::string& output, const Frame& frame)
{
    require_ok(renderer.render(frame));
    Result<Picture> picture = renderer.read(output);
    if (!picture)
        FAIL(to_text(picture.error()));
    return std::move(*picture);
}

int PlanBuilder::slot(Format format, const std::string& image)
{
    return slot(format, image, plan.extent);
}

int PlanBuilder::slot(Format format, const std::string& image, Extent extent)
{
    plan.slots.push_back({format, extent, {image}});
    return static_cast<int>(plan.slots.size()) - 1;
}

int PlanBuilder::import(Plan::Import::Kind kind, const std::string& name, Signal signal, Extent extent)
{
    plan.imports.push_back({kind, name, signal, extent});
    return static_cast<int>(plan.imports.size()) - 1;
}

Plan::Step& PlanBuilder::draw(const std::string& name, const std::string& body, const std::vector<int>& targets)
{
    Plan::Step step;
    step.name = name;
    step.passes = {name};
    step.extent = targets.empty() ? plan.extent : plan.slots[static_cast<size_t>(targets[0])].extent;
    for (const int slot : targets)
        step.targets.push_back({slot, plan.slots[static_cast<size_t>(slot)].images[0]});
    step.sources = {name + ".glsl"};
    step.vertex = "#version 330 core\nout vec2 uv;\nvoid main()\n{\n"
                  "    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
                  "    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);\n}\n";
    step.fragment = "#version 330 core\nin vec2 uv;\n#line 1 0\n" + body;
    plan.steps.push_back(std::move(step));
    return plan.steps.back();
}

Plan::Step& PlanBuilder::geometry(const std::string& name, const std::string& body, const std::vector<int>& targets,
                                  int depth)
{
    Plan::Step& step = draw(name, body, targets);
    step.kind = Plan::Step::Kind::geometry;
    step.depth_slot = depth;
    step.host = {.camera = true, .lights = false, .frame = false, .elements = true};
    // Names and layouts are those of core/glsl_interface.hpp.
    step.vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_uv;
uniform vec4 passgraph_element[7];
layout(std140) uniform passgraph_camera_block { mat4 clip_from_view; mat4 view_from_world; mat4 world_from_view; vec4 ray; vec4 range; };
out vec3 view_position;
out vec3 view_normal;
out vec2 uv;
vec4 texel(int i) { return passgraph_element[i]; }
void main()
{
    vec4 p = vec4(position, 1.0);
    view_position = vec3(dot(texel(0), p), dot(texel(1), p), dot(texel(2), p));
    view_normal = vec3(dot(texel(3).xyz, normal), dot(texel(4).xyz, normal), dot(texel(5).xyz, normal));
    uv = texture_uv;
    gl_Position = clip_from_view * vec4(view_position, 1.0);
}
)";
    step.fragment = "#version 330 core\nin vec3 view_position;\nin vec3 view_normal;\nin vec2 uv;\n"
                    "uniform vec4 passgraph_element[7];\n"
                    "uniform vec4 passgraph_atlas_levels[15];\n"
                    "uniform sampler2D passgraph_atlas_albedo;\nuniform sampler2D passgraph_atlas_material;\n"
                    "uniform sampler2D passgraph_atlas_emissive;\n"
                    "vec4 in_atlas(sampler2D atlas, vec2 inside)\n"
                    "{ return texture(atlas, passgraph_atlas_levels[0].xy + inside * passgraph_atlas_levels[0].zw); }\n"
                    "vec4 base_color() { return in_atlas(passgraph_atlas_albedo, vec2(0.5)); }\n"
                    "vec4 texel(int i) { return passgraph_element[i]; }\n"
                    "#line 1 0\n" +
                    body;
    return step;
}

void PlanBuilder::output(const std::string& name, int slot, Signal signal, const std::string& codec)
{
    const Codec* found = find_codec(signal, codec);
    REQUIRE(found != nullptr);
    const Plan::Slot& at = plan.slots[static_cast<size_t>(slot)];
    plan.outputs.push_back({name, at.images[0], Plan::Read::Source::slot, slot, signal, *found, at.extent});
}

void PlanBuilder::output_import(const std::string& name, int import)
{
    const Plan::Import& at = plan.imports[static_cast<size_t>(import)];
    plan.outputs.push_back({name, at.name, Plan::Read::Source::import, import, at.signal,
                            Codec{"rgba32f", Format::rgba32f, Packing::plain}, at.extent});
}

Plan::Read read_slot(int slot, const std::string& sampler)
{
    Plan::Read read;
    read.index = slot;
    read.sampler = sampler;
    return read;
}

Plan::Read load_slot(int slot, const std::string& image)
{
    Plan::Read read = read_slot(slot, image);
    read.is_loaded = true;
    return read;
}

void loads_images(Plan::Step& step)
{
    step.fragment.insert(step.fragment.find('\n') + 1, "#extension GL_ARB_shader_image_load_store : require\n");
}

Plan::Read read_import(int import, const std::string& sampler, bool has_levels)
{
    Plan::Read read = read_slot(import, sampler);
    read.source = Plan::Read::Source::import;
    read.has_levels = has_levels;
    return read;
}

Plan constant_plan(Extent extent, const std::string& color)
{
    PlanBuilder builder(extent);
    const int slot = builder.slot(Format::rgba32f, "fill.color");
    builder.draw("fill", "layout(location = 0) out vec4 color;\nvoid main() { color = " + color + "; }\n", {slot});
    builder.plan.steps.back().host.frame = true; // drawn each frame
    builder.output("color", slot, Signal::radiance, "rgba32f");
    return builder.plan;
}

} // namespace passgraph::test
