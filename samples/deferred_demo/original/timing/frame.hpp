// The original's frame: its targets, its draws and its habits, in raw OpenGL.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <GL/glcorearb.h>

#include <passgraph/scene/scene.hpp>

namespace original {

/// The functions that the original called.
#define ORIGINAL_FUNCTIONS(X)                                                                                          \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture) X(PFNGLATTACHSHADERPROC, AttachShader) X(PFNGLBINDBUFFERPROC, BindBuffer)  \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer) X(PFNGLBINDTEXTUREPROC, BindTexture)                                  \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray) X(PFNGLBLENDFUNCPROC, BlendFunc) X(PFNGLBUFFERDATAPROC, BufferData)    \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus) X(PFNGLCLEARPROC, Clear)                                \
    X(PFNGLCLEARCOLORPROC, ClearColor) X(PFNGLCOMPILESHADERPROC, CompileShader) X(PFNGLCREATEPROGRAMPROC, CreateProgram) \
    X(PFNGLCREATESHADERPROC, CreateShader) X(PFNGLDRAWARRAYSPROC, DrawArrays) X(PFNGLDRAWBUFFERSPROC, DrawBuffers)      \
    X(PFNGLENABLEPROC, Enable) X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray) X(PFNGLFINISHPROC, Finish)  \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D) X(PFNGLGENBUFFERSPROC, GenBuffers)                          \
    X(PFNGLGENERATEMIPMAPPROC, GenerateMipmap) X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                            \
    X(PFNGLGENTEXTURESPROC, GenTextures) X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays) X(PFNGLGETERRORPROC, GetError)    \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv) X(PFNGLGETSTRINGPROC, GetString)                                            \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation) X(PFNGLLINKPROGRAMPROC, LinkProgram)                            \
    X(PFNGLREADPIXELSPROC, ReadPixels) X(PFNGLSHADERSOURCEPROC, ShaderSource) X(PFNGLTEXIMAGE2DPROC, TexImage2D)        \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri) X(PFNGLUNIFORM1IPROC, Uniform1i) X(PFNGLUNIFORM3FPROC, Uniform3f)          \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv) X(PFNGLUSEPROGRAMPROC, UseProgram)                                  \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer) X(PFNGLVIEWPORTPROC, Viewport)

struct Functions {
#define ORIGINAL_MEMBER(type, name) type name = nullptr;
    ORIGINAL_FUNCTIONS(ORIGINAL_MEMBER)
#undef ORIGINAL_MEMBER
};

inline constexpr std::array<const char*, 5> kPasses = {"G-buffer", "lighting + luminance", "blur horizontally",
                                                       "blur vertically", "combine + tone map"};

/// Milliseconds of each pass, from glFinish to glFinish.
using PassTimes = std::array<double, kPasses.size()>;

/// Draws as the original did: four RGB16F targets and D24, then six more full-size RGB16F; blending and depth test on for
/// every pass; each mesh uploaded again before it is drawn; every uniform looked up by its name in every frame.
class Frame {
public:
    Frame(void* (*loader)(const char*), const passgraph::Scene& scene, passgraph::Extent extent);

    PassTimes draw();
    size_t vertices() const { return vertices_; }
    std::string device() const;
    /// The share of texels without geometry, from what the last frame left in its position target.
    double sky_share();
    /// The last frame's colors, RGBA, bottom row first.
    std::vector<unsigned char> pixels();

private:
    struct Target {
        GLuint framebuffer = 0;
        std::vector<GLuint> textures;
    };
    struct Drawn {
        std::vector<passgraph::Vertex> vertices; ///< three per triangle, not indexed
        glm::mat4 model{1.0f};
        GLuint color = 0;
        GLuint material = 0;
    };

    void add_elements(const passgraph::Scene& scene);
    GLuint texture_of(const passgraph::Scene& scene, int index, const glm::vec3& factor);
    GLuint program(const char* vertex, const char* fragment);
    Target target(GLenum format, int colors, bool has_depth);
    void begin(const Target& target, GLuint program);
    void set(GLuint program, const std::string& name, int value);
    void set(GLuint program, const std::string& name, const glm::vec3& value);
    void set(GLuint program, const std::string& name, const glm::mat4& value);
    void read(GLuint program, int unit, const std::string& name, GLuint texture);
    void draw_geometry();
    void light();
    void draw_screen();

    Functions gl_;
    passgraph::Extent extent_;
    const passgraph::Scene& scene_;
    glm::mat4 view_{1.0f};
    glm::mat4 projection_{1.0f};
    std::vector<Drawn> drawn_;
    size_t vertices_ = 0;
    GLuint vertex_array_ = 0;
    GLuint buffer_ = 0;
    GLuint geometry_ = 0, lighting_ = 0, blur_ = 0, combine_ = 0;
    Target g_buffer_, lit_, rows_, glow_, shown_;
};

} // namespace original
