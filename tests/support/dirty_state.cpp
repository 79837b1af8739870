// Sets random OpenGL state.
#include "support/dirty_state.hpp"

#include <array>
#include <iterator>

#include <GL/glcorearb.h>

namespace passgraph::test {
namespace {

constexpr GLenum kSwitches[] = {GL_BLEND,
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
                                GL_PRIMITIVE_RESTART,
                                GL_CLIP_DISTANCE0,
                                GL_FRAMEBUFFER_SRGB,
                                GL_TEXTURE_CUBE_MAP_SEAMLESS};

constexpr GLenum kFunctions[] = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
constexpr GLenum kFactors[] = {GL_ZERO, GL_ONE, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_COLOR, GL_DST_ALPHA};
constexpr GLenum kTargets[] = {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BUFFER};
constexpr unsigned kUnits = 6;

template <class T, size_t N>
T any_of(const T (&items)[N], std::mt19937& random)
{
    return items[random() % N];
}

} // namespace

DirtyState::DirtyState(GlLoader loader, unsigned seed) : loader_(loader), random_(seed)
{
    get<PFNGLGENBUFFERSPROC>("glGenBuffers")(1, &buffer_);
    get<PFNGLGENTEXTURESPROC>("glGenTextures")(1, &texture_);
    get<PFNGLGENSAMPLERSPROC>("glGenSamplers")(1, &sampler_);
    get<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays")(1, &vertex_array_);
    get<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer_);
    get<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_ARRAY_BUFFER, buffer_);
    get<PFNGLBUFFERDATAPROC>("glBufferData")(GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
    get<PFNGLBINDTEXTUREPROC>("glBindTexture")(GL_TEXTURE_2D, texture_); // is a 2D texture from now on
}

DirtyState::~DirtyState()
{
    restore();
    get<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(1, &buffer_);
    get<PFNGLDELETETEXTURESPROC>("glDeleteTextures")(1, &texture_);
    get<PFNGLDELETESAMPLERSPROC>("glDeleteSamplers")(1, &sampler_);
    get<PFNGLDELETEVERTEXARRAYSPROC>("glDeleteVertexArrays")(1, &vertex_array_);
    get<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers")(1, &framebuffer_);
}

void DirtyState::operator()()
{
    set_switches();
    set_draws();
    bind_objects(true);
}

void DirtyState::set_switches()
{
    for (const GLenum name : kSwitches)
        get<PFNGLENABLEPROC>(coin() ? "glEnable" : "glDisable")(name);
    // Blending per target outlives the switch that all of them share.
    for (GLuint target = 0; target < 4; ++target)
        get<PFNGLENABLEIPROC>(coin() ? "glEnablei" : "glDisablei")(GL_BLEND, target);
}

void DirtyState::set_draws()
{
    get<PFNGLBLENDFUNCPROC>("glBlendFunc")(any_of(kFactors, random_), any_of(kFactors, random_));
    get<PFNGLBLENDEQUATIONPROC>("glBlendEquation")(coin() ? GL_FUNC_SUBTRACT : GL_MAX);
    get<PFNGLLOGICOPPROC>("glLogicOp")(GL_XOR);
    get<PFNGLSTENCILFUNCPROC>("glStencilFunc")(GL_NEVER, 1, 0xff);
    get<PFNGLDEPTHFUNCPROC>("glDepthFunc")(any_of(kFunctions, random_));
    get<PFNGLDEPTHMASKPROC>("glDepthMask")(coin() ? GL_TRUE : GL_FALSE);
    get<PFNGLCOLORMASKPROC>("glColorMask")(coin(), coin(), coin(), coin());
    get<PFNGLCULLFACEPROC>("glCullFace")(coin() ? GL_FRONT : GL_FRONT_AND_BACK);
    get<PFNGLFRONTFACEPROC>("glFrontFace")(coin() ? GL_CW : GL_CCW);
    get<PFNGLPOLYGONMODEPROC>("glPolygonMode")(GL_FRONT_AND_BACK, coin() ? GL_LINE : GL_POINT);
    get<PFNGLSCISSORPROC>("glScissor")(1, 1, 2, 2);
    get<PFNGLVIEWPORTPROC>("glViewport")(static_cast<GLint>(random_() % 4), 1, 3, 5);
    get<PFNGLDEPTHRANGEPROC>("glDepthRange")(0.75, 0.25);
    get<PFNGLCLEARCOLORPROC>("glClearColor")(0.5f, 0.25f, 0.125f, 0.0f);
    get<PFNGLCLEARDEPTHPROC>("glClearDepth")(0.5);
    if (const auto control = get<PFNGLCLIPCONTROLPROC>("glClipControl"))
        control(coin() ? GL_UPPER_LEFT : GL_LOWER_LEFT, coin() ? GL_NEGATIVE_ONE_TO_ONE : GL_ZERO_TO_ONE);
}

void DirtyState::bind_objects(bool is_dirty)
{
    const GLuint bound = is_dirty ? 1u : 0u;
    const auto bind_buffer = get<PFNGLBINDBUFFERPROC>("glBindBuffer");
    for (const GLenum target : {GL_ARRAY_BUFFER, GL_UNIFORM_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER, GL_TEXTURE_BUFFER})
        bind_buffer(target, bound * buffer_);
    for (GLuint binding = 0; binding < 3; ++binding)
        get<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase")(GL_UNIFORM_BUFFER, binding, bound * buffer_);
    for (GLuint unit = 0; unit < kUnits; ++unit) {
        get<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + unit);
        for (const GLenum target : kTargets)
            get<PFNGLBINDTEXTUREPROC>("glBindTexture")(target, target == GL_TEXTURE_2D ? bound * texture_ : 0);
        get<PFNGLBINDSAMPLERPROC>("glBindSampler")(unit, bound * sampler_);
    }
    get<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + 3 * bound);
    get<PFNGLUSEPROGRAMPROC>("glUseProgram")(0);
    get<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray")(bound * vertex_array_);
    get<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, bound * framebuffer_);
    for (const GLenum name : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
        get<PFNGLPIXELSTOREIPROC>("glPixelStorei")(name, is_dirty ? 8 : 4);
    for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS})
        get<PFNGLPIXELSTOREIPROC>("glPixelStorei")(name, is_dirty ? 3 : 0);
}

void DirtyState::restore()
{
    for (const GLenum name : kSwitches)
        get<PFNGLDISABLEPROC>("glDisable")(name);
    get<PFNGLENABLEPROC>("glEnable")(GL_DITHER);
    get<PFNGLDEPTHMASKPROC>("glDepthMask")(GL_TRUE);
    get<PFNGLDEPTHFUNCPROC>("glDepthFunc")(GL_LESS);
    get<PFNGLDEPTHRANGEPROC>("glDepthRange")(0.0, 1.0);
    get<PFNGLCOLORMASKPROC>("glColorMask")(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    get<PFNGLPOLYGONMODEPROC>("glPolygonMode")(GL_FRONT_AND_BACK, GL_FILL);
    bind_objects(false);
}

} // namespace passgraph::test
