// GL state: only changes are issued, a dirty host does no harm, and its state comes back when asked for.
#include <functional>

#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

void enable(GLenum capability, bool is_on)
{
    gl_function<PFNGLENABLEPROC>(is_on ? "glEnable" : "glDisable")(capability);
}

constexpr GLenum kCapabilities[] = {GL_BLEND,
                                    GL_SCISSOR_TEST,
                                    GL_STENCIL_TEST,
                                    GL_DEPTH_TEST,
                                    GL_CULL_FACE,
                                    GL_DITHER,
                                    GL_COLOR_LOGIC_OP,
                                    GL_DEPTH_CLAMP,
                                    GL_POLYGON_OFFSET_FILL,
                                    GL_RASTERIZER_DISCARD,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE,
                                    GL_SAMPLE_COVERAGE,
                                    GL_SAMPLE_MASK,
                                    GL_PRIMITIVE_RESTART,
                                    GL_CLIP_DISTANCE0,
                                    GL_FRAMEBUFFER_SRGB,
                                    GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                    GL_DEBUG_OUTPUT,
                                    GL_DEBUG_OUTPUT_SYNCHRONOUS};

constexpr GLenum kIntegers[] = {GL_CURRENT_PROGRAM,
                                GL_DRAW_FRAMEBUFFER_BINDING,
                                GL_READ_FRAMEBUFFER_BINDING,
                                GL_VERTEX_ARRAY_BINDING,
                                GL_ACTIVE_TEXTURE,
                                GL_ARRAY_BUFFER_BINDING,
                                GL_TEXTURE_BUFFER,
                                GL_UNIFORM_BUFFER_BINDING,
                                GL_PIXEL_PACK_BUFFER_BINDING,
                                GL_PIXEL_UNPACK_BUFFER_BINDING,
                                GL_DEPTH_FUNC,
                                GL_CULL_FACE_MODE,
                                GL_FRONT_FACE,
                                GL_CLAMP_READ_COLOR,
                                GL_CLIP_ORIGIN,
                                GL_CLIP_DEPTH_MODE,
                                GL_DEPTH_WRITEMASK,
                                GL_PACK_ALIGNMENT,
                                GL_PACK_ROW_LENGTH,
                                GL_UNPACK_ALIGNMENT,
                                GL_UNPACK_ROW_LENGTH,
                                GL_UNPACK_SKIP_ROWS};

/// Everything a renderer may touch, as one list of numbers.
std::vector<GLint> snapshot()
{
    std::vector<GLint> found;
    const auto get = gl_function<PFNGLGETINTEGERVPROC>("glGetIntegerv");
    const auto add = [&](GLenum name, size_t count) {
        std::vector<GLint> values(count + 4); // some names write more than one asks for
        get(name, values.data());
        found.insert(found.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (const GLenum capability : kCapabilities)
        found.push_back(gl_function<PFNGLISENABLEDPROC>("glIsEnabled")(capability));
    for (const GLenum name : kIntegers)
        add(name, 1);
    add(GL_VIEWPORT, 4);
    add(GL_POLYGON_MODE, 1);
    add(GL_DEPTH_RANGE, 2);
    for (GLuint i = 0; i < 2; ++i) {
        GLboolean mask[4] = {};
        gl_function<PFNGLGETBOOLEANI_VPROC>("glGetBooleani_v")(GL_COLOR_WRITEMASK, i, mask);
        found.insert(found.end(), mask, mask + 4);
        found.push_back(gl_function<PFNGLISENABLEDIPROC>("glIsEnabledi")(GL_BLEND, i));
        GLint64 range[2] = {};
        gl_function<PFNGLGETINTEGER64I_VPROC>("glGetInteger64i_v")(GL_UNIFORM_BUFFER_START, i, &range[0]);
        gl_function<PFNGLGETINTEGER64I_VPROC>("glGetInteger64i_v")(GL_UNIFORM_BUFFER_SIZE, i, &range[1]);
        GLint buffer = 0;
        gl_function<PFNGLGETINTEGERI_VPROC>("glGetIntegeri_v")(GL_UNIFORM_BUFFER_BINDING, i, &buffer);
        found.insert(found.end(), {static_cast<GLint>(range[0]), static_cast<GLint>(range[1]), buffer});
    }
    GLint active = 0;
    get(GL_ACTIVE_TEXTURE, &active);
    for (GLenum unit = 0; unit < 6; ++unit) {
        gl_function<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + unit);
        for (const GLenum name :
             {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_BINDING_BUFFER, GL_SAMPLER_BINDING})
            add(name, 1);
    }
    gl_function<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(static_cast<GLenum>(active));
    for (GLuint unit = 0; unit < 3; ++unit)
        for (const GLenum name : {GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED, GL_IMAGE_BINDING_LAYER,
                                  GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT}) {
            GLint value = -1;
            gl_function<PFNGLGETINTEGERI_VPROC>("glGetIntegeri_v")(name, unit, &value);
            found.push_back(value);
        }
    void* callback = nullptr;
    gl_function<PFNGLGETPOINTERVPROC>("glGetPointerv")(GL_DEBUG_CALLBACK_FUNCTION, &callback);
    found.push_back(callback != nullptr);
    return found;
}

void APIENTRY ignore_message(GLenum, GLenum, GLuint, GLenum, GLsizei, const GLchar*, const void*) {}

/// Sets all of it to something a renderer would stumble over, and back to OpenGL's defaults at the end.
class DirtyHost {
public:
    DirtyHost()
    {
        test_loader();
        for (size_t i = 0; i < std::size(kCapabilities); ++i)
            was_enabled_.push_back(gl_function<PFNGLISENABLEDPROC>("glIsEnabled")(kCapabilities[i]) == GL_TRUE);
        gl_function<PFNGLGENBUFFERSPROC>("glGenBuffers")(1, &buffer_);
        gl_function<PFNGLGENTEXTURESPROC>("glGenTextures")(1, &texture_);
        gl_function<PFNGLGENSAMPLERSPROC>("glGenSamplers")(1, &sampler_);
        gl_function<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays")(1, &vertex_array_);
        gl_function<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer_);
        gl_function<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_ARRAY_BUFFER, buffer_);
        gl_function<PFNGLBUFFERDATAPROC>("glBufferData")(GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
        set(true);
    }
    ~DirtyHost()
    {
        set(false);
        gl_function<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(1, &buffer_);
        gl_function<PFNGLDELETETEXTURESPROC>("glDeleteTextures")(1, &texture_);
        gl_function<PFNGLDELETESAMPLERSPROC>("glDeleteSamplers")(1, &sampler_);
        gl_function<PFNGLDELETEVERTEXARRAYSPROC>("glDeleteVertexArrays")(1, &vertex_array_);
        gl_function<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers")(1, &framebuffer_);
    }

private:
    void set(bool is_dirty)
    {
        for (size_t i = 0; i < std::size(kCapabilities); ++i)
            enable(kCapabilities[i], is_dirty ? kCapabilities[i] != GL_TEXTURE_CUBE_MAP_SEAMLESS : was_enabled_[i]);
        const GLuint bound = is_dirty ? 1u : 0u;
        const auto bind_buffer = gl_function<PFNGLBINDBUFFERPROC>("glBindBuffer");
        if (is_dirty)
            gl_function<PFNGLBINDBUFFERRANGEPROC>("glBindBufferRange")(GL_UNIFORM_BUFFER, 1, buffer_, 256, 512);
        else
            gl_function<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase")(GL_UNIFORM_BUFFER, 1, 0);
        for (const GLenum target :
             {GL_ARRAY_BUFFER, GL_TEXTURE_BUFFER, GL_UNIFORM_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
            bind_buffer(target, bound * buffer_);
        for (GLuint unit = 0; unit < 6; ++unit) {
            gl_function<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + unit);
            gl_function<PFNGLBINDTEXTUREPROC>("glBindTexture")(GL_TEXTURE_2D, bound * texture_);
            gl_function<PFNGLBINDSAMPLERPROC>("glBindSampler")(unit, bound * sampler_);
        }
        for (GLuint unit = 0; unit < 3; ++unit)
            gl_function<PFNGLBINDIMAGETEXTUREPROC>("glBindImageTexture")(unit, bound * texture_, static_cast<GLint>(bound), GL_FALSE, static_cast<GLint>(bound),
                                                                         is_dirty ? GL_READ_WRITE : GL_READ_ONLY, is_dirty ? GL_R32F : GL_R8);
        gl_function<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + 5 * bound);
        gl_function<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray")(bound * vertex_array_);
        gl_function<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, bound * framebuffer_);
        gl_function<PFNGLVIEWPORTPROC>("glViewport")(1, 2, is_dirty ? 3 : 64, is_dirty ? 4 : 64);
        gl_function<PFNGLPOLYGONMODEPROC>("glPolygonMode")(GL_FRONT_AND_BACK, is_dirty ? GL_LINE : GL_FILL);
        gl_function<PFNGLDEPTHRANGEPROC>("glDepthRange")(is_dirty ? 0.25 : 0.0, is_dirty ? 0.5 : 1.0);
        gl_function<PFNGLDEPTHMASKPROC>("glDepthMask")(is_dirty ? GL_FALSE : GL_TRUE);
        gl_function<PFNGLDEPTHFUNCPROC>("glDepthFunc")(is_dirty ? GL_NEVER : GL_LESS);
        gl_function<PFNGLCULLFACEPROC>("glCullFace")(is_dirty ? GL_FRONT_AND_BACK : GL_BACK);
        gl_function<PFNGLFRONTFACEPROC>("glFrontFace")(is_dirty ? GL_CW : GL_CCW);
        gl_function<PFNGLCOLORMASKIPROC>("glColorMaski")(0, GL_FALSE, !is_dirty, GL_FALSE, !is_dirty);
        gl_function<PFNGLCLIPCONTROLPROC>("glClipControl")(is_dirty ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                                                           GL_NEGATIVE_ONE_TO_ONE);
        gl_function<PFNGLCLAMPCOLORPROC>("glClampColor")(GL_CLAMP_READ_COLOR, is_dirty ? GL_TRUE : GL_FIXED_ONLY);
        for (const GLenum name : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
            gl_function<PFNGLPIXELSTOREIPROC>("glPixelStorei")(name, is_dirty ? 8 : 4);
        for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS})
            gl_function<PFNGLPIXELSTOREIPROC>("glPixelStorei")(name, is_dirty ? 7 : 0);
        gl_function<PFNGLDEBUGMESSAGECALLBACKPROC>("glDebugMessageCallback")(is_dirty ? &ignore_message : nullptr,
                                                                             nullptr);
        if (!is_dirty)
            gl_function<PFNGLCOLORMASKPROC>("glColorMask")(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }

    std::vector<bool> was_enabled_;
    GLuint buffer_ = 0, texture_ = 0, sampler_ = 0, vertex_array_ = 0, framebuffer_ = 0;
};

/// An import, a geometry step, a full-screen step that samples both, and one that loads what that makes.
Plan busy_plan()
{
    PlanBuilder builder({5, 3});
    const int picture = builder.import(Plan::Import::Kind::picture, "picture", Signal::radiance, {1, 3});
    const int color = builder.slot(Format::srgb8_a8, "surface.color");
    const int depth = builder.slot(Format::depth32f, "surface.depth");
    const int mixed = builder.slot(Format::rgba32f, "mix.color");
    const int out = builder.slot(Format::rgba32f, "copy.color");
    builder.geometry("surface", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(1.0); }\n", {color}, depth);
    builder.draw("mix",
                 "uniform sampler2D picture;\nuniform sampler2D surface;\nlayout(location = 0) out vec4 c;\n"
                 "void main() { c = texture(picture, uv) + texture(surface, uv); }\n",
                 {mixed});
    builder.plan.steps[1].reads = {read_import(picture, "picture"), read_slot(color, "surface")};
    builder.draw("copy",
                 "layout(rgba32f) readonly uniform image2D mixed;\nlayout(location = 0) out vec4 c;\n"
                 "void main() { c = imageLoad(mixed, ivec2(gl_FragCoord.xy)); }\n",
                 {out});
    builder.plan.steps[2].reads = {load_slot(mixed, "mixed")};
    loads_images(builder.plan.steps[2]);
    builder.output("color", out, Signal::radiance, "rgba32f");
    builder.output("depth", depth, Signal::depth, "depth32f");
    return builder.plan;
}

Scene wall()
{
    Scene scene;
    scene.materials = {Material{}};
    Mesh mesh;
    for (const glm::vec3 corner : {glm::vec3(-9, -9, -1), glm::vec3(9, -9, -1), glm::vec3(0, 9, -1)})
        mesh.vertices.push_back({corner, {0, 0, 1}, {0, 0}});
    mesh.indices = {0, 1, 2};
    scene.meshes = {mesh};
    scene.elements = {Element{}};
    return scene;
}

/// What each texel of `busy_plan` must be with `wall`: the picture's row, plus 1.
void check_busy(const Picture& picture)
{
    for (int y = 0; y < 3; ++y)
        CHECK(picture.at(2, y) == static_cast<float>(y + 2));
}

Picture constant_picture(Extent extent, float value)
{
    Picture picture(extent, 1);
    picture.texels.assign(picture.texels.size(), value);
    return picture;
}

Picture rows()
{
    Picture picture({1, 3}, 1);
    picture.texels = {1, 2, 3};
    return picture;
}

} // namespace

TEST_CASE("whatever state the host left, the picture is the same", "[gl][state]")
{
    const Scene scene = wall();
    const DirtyHost dirty;
    Renderer renderer = make_renderer(busy_plan());
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.import_picture("picture", rows()));
    check_busy(render_and_read(renderer));
    // near (far - d) / (d (far - near)) at d = 1
    CHECK(renderer.read("depth")->at(2, 1) == Approx(0.1 * 999.0 / 999.9).epsilon(1e-5));
}

TEST_CASE("whatever state the host leaves between two frames, the picture is the same", "[gl][state]")
{
    const Scene scene = wall();
    Renderer renderer = make_renderer(busy_plan());
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.import_picture("picture", rows()));
    check_busy(render_and_read(renderer));
    const DirtyHost dirty;
    require_ok(renderer.import_picture("picture", constant_picture({1, 3}, 7.0f)));
    const Picture later = render_and_read(renderer, "color", {.redraws = true});
    for (int y = 0; y < 3; ++y)
        CHECK(later.at(2, y) == 8.0f);
}

TEST_CASE("the host's state comes back after every call when asked for", "[gl][state]")
{
    const Scene scene = wall();
    const DirtyHost dirty;
    const std::vector<GLint> before = snapshot();
    {
        Renderer renderer = make_renderer(busy_plan(), {.is_timed = true, .restores_state = true});
        CHECK(snapshot() == before);
        require_ok(renderer.set_scene(scene));
        CHECK(snapshot() == before);
        require_ok(renderer.import_picture("picture", rows()));
        CHECK(snapshot() == before);
        require_ok(renderer.render());
        CHECK(snapshot() == before);
        check_busy(*renderer.read("color"));
        CHECK(snapshot() == before);
        require_ok(renderer.replace(busy_plan()));
        CHECK(snapshot() == before);
        renderer.step_times();
    }
    CHECK(snapshot() == before);
    CHECK(gl_function<PFNGLGETERRORPROC>("glGetError")() == GL_NO_ERROR);
}

TEST_CASE("a plan that is prepared uses more of the host's units than the one that runs, and gives them back", "[gl][state]")
{
    const DirtyHost dirty;
    const std::vector<GLint> before = snapshot();
    {
        Renderer renderer = make_renderer(constant_plan({2, 2}), {.restores_state = true});
        PlanBuilder builder({2, 2});
        const int first = builder.slot(Format::rgba8, "first");
        const int second = builder.slot(Format::rgba8, "second");
        const int sum = builder.slot(Format::rgba8, "sum");
        const bool loads = GENERATE(false, true);
        Plan::Step& step = builder.draw(
            "sum",
            loads ? "layout(rgba8) readonly uniform image2D a;\nlayout(rgba8) readonly uniform image2D b;\nlayout(location = 0) out vec4 c;\n"
                    "void main() { ivec2 at = ivec2(gl_FragCoord.xy); c = imageLoad(a, at) + imageLoad(b, at); }\n"
                  : "uniform sampler2D a;\nuniform sampler2D b;\nlayout(location = 0) out vec4 c;\n"
                    "void main() { c = texture(a, uv) + texture(b, uv); }\n",
            {sum});
        if (loads)
            loads_images(step);
        step.reads = {loads ? load_slot(first, "a") : read_slot(first, "a"), loads ? load_slot(second, "b") : read_slot(second, "b")};
        Result<PreparedPlan> prepared = renderer.prepare(builder.plan);
        REQUIRE(prepared);
        require_ok(renderer.advance(*prepared));
        CHECK(prepared->is_ready());
        CHECK(snapshot() == before);
    }
    CHECK(snapshot() == before);
}

TEST_CASE("steps that share state do not set it again", "[gl][state]")
{
    const auto chain = [](int length) {
        PlanBuilder builder({4, 4});
        std::vector<int> slots = {builder.slot(Format::rgba8, "a"), builder.slot(Format::rgba8, "b")};
        const int source = builder.slot(Format::rgba8, "source");
        for (int i = 0; i < length; ++i)
            builder
                .draw("copy",
                      "uniform sampler2D s;\nlayout(location = 0) out vec4 c;\nvoid main() { c = texture(s, uv); }\n",
                      {slots[static_cast<size_t>(i % 2)]})
                .reads = {read_slot(source, "s")};
        return builder.plan;
    };
    const auto frame = [&](int length) {
        reset_spy();
        Renderer renderer = make_renderer(chain(length), {.loader = spying_loader()});
        require_ok(renderer.render());
        spy().calls.clear();
        const Renderer::Counters before = renderer.counters();
        require_ok(renderer.render({.redraws = true}));
        const Renderer::Counters after = renderer.counters();
        return std::tuple(spy().calls, after.state_changes - before.state_changes,
                          after.redundant_state_changes - before.redundant_state_changes);
    };
    const auto [calls_one, changes_one, redundant_one] = frame(1);
    const auto [calls_three, changes_three, redundant_three] = frame(3);
    // Two more steps change the framebuffer; the program, being of the same text, texture, sampler, viewport and the rest stay.
    CHECK(changes_three - changes_one == 2 * 1);
    CHECK(redundant_three > redundant_one);
    CHECK(calls_three.at("glBindTexture") == 1);
    CHECK(calls_three.at("glViewport") == 1);
    CHECK(calls_three.at("glUseProgram") == 1);
    CHECK(calls_three.at("glDrawArrays") == 3);
    CHECK_FALSE(calls_three.contains("glGetUniformLocation"));
    reset_spy();
}

TEST_CASE("values and blocks are sent when they change, not before", "[gl][state]")
{
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(Format::rgba32f, "image");
    builder
        .draw("fill", "uniform float gain;\nlayout(location = 0) out vec4 c;\nvoid main() { c = vec4(gain); }\n",
              {slot})
        .uniforms = {{"gain", "fill.gain", ParamType::float_, Value(1.0), 0.0, 4.0}};
    builder.plan.outputs.push_back({"color", "image", Plan::Read::Source::slot, slot, Signal::radiance,
                                    *find_codec(Signal::radiance, "rgba32f"), {2, 2}});
    reset_spy();
    Scene scene = wall();
    Renderer renderer = make_renderer(builder.plan, {.loader = spying_loader()});
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.render());
    const auto sent = [&](const std::function<void()>& change, const char* function) {
        require_ok(renderer.render()); // settles
        change();
        spy().calls.clear();
        require_ok(renderer.render());
        return spy().calls[function];
    };
    CHECK(sent([] {}, "glUniform1fv") == 0);
    CHECK(sent([&] { require_ok(renderer.set("fill.gain", 1.0)); }, "glUniform1fv") == 0);
    CHECK(sent([&] { require_ok(renderer.set("fill.gain", 2.0)); }, "glUniform1fv") == 1);
    CHECK(sent([] {}, "glBufferSubData") == 0);
    CHECK(sent([&] { scene.camera.position.x += 1.0f; }, "glBufferSubData") == 1); // the camera block
    reset_spy();
}
