// One table of OpenGL functions, filled through the loader of whichever context is current.
#pragma once

#include <GL/glcorearb.h>

#include <passgraph/gl/renderer.hpp>

// Core 3.3: all of them must be there.
#define PASSGRAPH_GL_FUNCTIONS(X)                                                                                      \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                           \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                             \
    X(PFNGLBEGINCONDITIONALRENDERPROC, BeginConditionalRender)                                                         \
    X(PFNGLBEGINQUERYPROC, BeginQuery)                                                                                 \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                 \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                                         \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                                       \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                       \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                                               \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                               \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                       \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                                                 \
    X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                                                                           \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                                         \
    X(PFNGLCLAMPCOLORPROC, ClampColor)                                                                                 \
    X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                                                           \
    X(PFNGLCOLORMASKPROC, ColorMask)                                                                                   \
    X(PFNGLCOLORMASKIPROC, ColorMaski)                                                                                 \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                           \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                           \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                             \
    X(PFNGLCULLFACEPROC, CullFace)                                                                                     \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                           \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                                 \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                           \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries)                                                                           \
    X(PFNGLDELETESAMPLERSPROC, DeleteSamplers)                                                                         \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                             \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                                         \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                                 \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                                                   \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                                                                   \
    X(PFNGLDEPTHRANGEPROC, DepthRange)                                                                                 \
    X(PFNGLDETACHSHADERPROC, DetachShader)                                                                             \
    X(PFNGLDISABLEPROC, Disable)                                                                                       \
    X(PFNGLDISABLEIPROC, Disablei)                                                                                     \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                                 \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                                               \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                                                                             \
    X(PFNGLENABLEPROC, Enable)                                                                                         \
    X(PFNGLENABLEIPROC, Enablei)                                                                                       \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                                       \
    X(PFNGLENDCONDITIONALRENDERPROC, EndConditionalRender)                                                             \
    X(PFNGLENDQUERYPROC, EndQuery)                                                                                     \
    X(PFNGLFINISHPROC, Finish)                                                                                         \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                             \
    X(PFNGLFRONTFACEPROC, FrontFace)                                                                                   \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                 \
    X(PFNGLGENERATEMIPMAPPROC, GenerateMipmap)                                                                         \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                       \
    X(PFNGLGENQUERIESPROC, GenQueries)                                                                                 \
    X(PFNGLGENSAMPLERSPROC, GenSamplers)                                                                               \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                               \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                       \
    X(PFNGLGETBOOLEANI_VPROC, GetBooleani_v)                                                                           \
    X(PFNGLGETBOOLEANVPROC, GetBooleanv)                                                                               \
    X(PFNGLGETDOUBLEVPROC, GetDoublev)                                                                                 \
    X(PFNGLGETERRORPROC, GetError)                                                                                     \
    X(PFNGLGETINTEGER64I_VPROC, GetInteger64i_v)                                                                       \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                                           \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                               \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                                   \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                             \
    X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)                                                               \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                                                 \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                                     \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                                               \
    X(PFNGLGETSTRINGPROC, GetString)                                                                                   \
    X(PFNGLGETSTRINGIPROC, GetStringi)                                                                                 \
    X(PFNGLGETTEXLEVELPARAMETERIVPROC, GetTexLevelParameteriv)                                                         \
    X(PFNGLGETUNIFORMBLOCKINDEXPROC, GetUniformBlockIndex)                                                             \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                                 \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                                                   \
    X(PFNGLISENABLEDIPROC, IsEnabledi)                                                                                 \
    X(PFNGLISTEXTUREPROC, IsTexture)                                                                                   \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                               \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                               \
    X(PFNGLPOLYGONMODEPROC, PolygonMode)                                                                               \
    X(PFNGLQUERYCOUNTERPROC, QueryCounter)                                                                             \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                                                                 \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                                                 \
    X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri)                                                                   \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                             \
    X(PFNGLTEXBUFFERPROC, TexBuffer)                                                                                   \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                 \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                           \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                                                                           \
    X(PFNGLUNIFORM1FVPROC, Uniform1fv)                                                                                 \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                                   \
    X(PFNGLUNIFORM2FVPROC, Uniform2fv)                                                                                 \
    X(PFNGLUNIFORM3FVPROC, Uniform3fv)                                                                                 \
    X(PFNGLUNIFORM4FVPROC, Uniform4fv)                                                                                 \
    X(PFNGLUNIFORMBLOCKBINDINGPROC, UniformBlockBinding)                                                               \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                                 \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                                               \
    X(PFNGLVIEWPORTPROC, Viewport)

// KHR_debug, core since 4.3: all of them or none.
#define PASSGRAPH_GL_DEBUG_FUNCTIONS(X)                                                                                \
    X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback)                                                             \
    X(PFNGLGETPOINTERVPROC, GetPointerv)                                                                               \
    X(PFNGLPOPDEBUGGROUPPROC, PopDebugGroup)                                                                           \
    X(PFNGLPUSHDEBUGGROUPPROC, PushDebugGroup)

namespace passgraph::gl {

struct Functions {
#define PASSGRAPH_GL_MEMBER(type, name) type name = nullptr;
    PASSGRAPH_GL_FUNCTIONS(PASSGRAPH_GL_MEMBER)
    PASSGRAPH_GL_DEBUG_FUNCTIONS(PASSGRAPH_GL_MEMBER)
    PASSGRAPH_GL_MEMBER(PFNGLCLIPCONTROLPROC, ClipControl) ///< nullptr without ARB_clip_control
    PASSGRAPH_GL_MEMBER(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture) ///< nullptr below 4.2 without ARB_shader_image_load_store
#undef PASSGRAPH_GL_MEMBER
    bool has_debug = false;
    bool has_conservative_queries = false; ///< 4.3 or ARB_ES3_compatibility
    bool has_inverted_conditions = false; ///< may draw only if a query counted nothing: 4.5 or ARB_conditional_render_inverted
};

/// Every function the executor calls, of the current context.
/// Errors   gl_too_old (below 3.3), gl_function_missing (naming each), both lacks of the machine.
Result<Functions> load_functions(GlLoader loader);

} // namespace passgraph::gl
