// Runs a plan with OpenGL and owns every GL object it needs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/compile.hpp>
#include <passgraph/core/error.hpp>
#include <passgraph/core/plan.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph {

using GlLoader = void* (*)(const char* name);

/// What changes from frame to frame. Headless frames are 1/60 s apart.
struct Frame {
    double time = 0.0;         ///< seconds since the start
    double delta = 1.0 / 60.0; ///< seconds since the last frame
    int index = 0;
    bool is_cut = false;            ///< nothing of the last frame is to be trusted; the first frame always is a cut
    const Camera* camera = nullptr; ///< nullptr: the scene's own
    bool redraws = false; ///< draws steps anew whose images are there already; for measuring
};

/// A texture that belongs to the host: 2D or cube, of any color format, complete without mip levels unless it has them.
struct HostTexture {
    unsigned id = 0;
    Extent extent;
    std::uint64_t version = 0; ///< another one whenever its contents change; 0: they may have, each frame
};

/// A texture and those of its channels ("rg", "a") that hold codes of an image.
struct StoredCodes {
    HostTexture texture;
    std::string channels;
};

/// Milliseconds between the ends of neighbouring steps, as the GL clock saw them in the last finished frame.
struct StepTime {
    std::string step;
    double milliseconds = 0.0;
    bool was_drawn = true; ///< false: its images were there already
    bool was_skipped = false; ///< the device left it out, or drew its simpler variant, as what it reads is black
};

struct RendererOptions {
    GlLoader loader = nullptr;   ///< of the current context
    bool is_timed = false;       ///< a timestamp after each step
    bool restores_state = false; ///< leave the host's GL state as it was found
    bool scrubs_imports = true;  ///< false: pictures and cube maps are uploaded as they are, non-finite values included
    bool is_poisoned = false;    ///< textures to draw into start as NaN (1 where the format has none), to find what is read unwritten
    /// Called before each step of a frame; may leave any GL state behind, except the objects the renderer owns. For tests.
    std::function<void()> before_step{};
};

/// The limits of the current context. Errors: gl_too_old, gl_function_missing (lacks of the machine).
Result<Device> query_device(GlLoader loader);

/// A plan on its way to the device, made bit by bit while another one runs. Belongs to the renderer that prepares it, which
/// outlives it.
class PreparedPlan {
public:
    PreparedPlan(PreparedPlan&&) noexcept;
    PreparedPlan& operator=(PreparedPlan&&) noexcept;
    ~PreparedPlan(); ///< needs the same context current

    const Plan& plan() const;
    bool is_ready() const; ///< nothing is left to be made
    size_t steps_made() const;

private:
    friend class Renderer;
    class Impl;
    explicit PreparedPlan(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// What is computed of a scene before it is uploaded: its texture atlas, and its sky filtered for rough surfaces.
class SceneImages {
public:
    class Impl;
    explicit SceneImages(std::unique_ptr<Impl> impl);
    const Facts& facts() const; ///< of the scene
    SceneImages(SceneImages&&) noexcept;
    SceneImages& operator=(SceneImages&&) noexcept;
    ~SceneImages();

private:
    friend class Renderer;
    std::unique_ptr<Impl> impl_;
};

/// Executes a plan in the context that was current when it was created.
///
/// No GL object is created after a plan's first frame, no state is set twice, and any GL error becomes an error value
/// that names the step.
class Renderer {
public:
    /// Builds programs, textures and framebuffers.
    /// Errors   gl_too_old, gl_function_missing, shader_failed (with the pass file's own line), framebuffer_incomplete.
    static Result<Renderer> create(Plan plan, const RendererOptions& options);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer(); ///< needs the same context current

    /// Takes another plan, keeping imports and the scene; on an error the old plan stays.
    Result<void> replace(Plan plan);

    /// Starts to make another plan's objects; the one that runs is not touched.
    /// Errors   extent_too_large, extent_empty, out_of_memory.
    Result<PreparedPlan> prepare(Plan plan);
    /// Makes one more of its programs and draws one pixel with it, as drivers compile at the first draw. A program whose texts
    /// an earlier plan had is taken over, so that after an edit only the steps that changed cost anything.
    /// Errors   shader_failed (with the pass file's own line), framebuffer_incomplete, texture_units_exceeded, image_units_exceeded,
    ///          gl_error.
    /// Cost     one program: 40 to 180 ms on llvmpipe when it is new, else below 1 ms.
    Result<void> advance(PreparedPlan& prepared);
    /// Runs the prepared plan from the next frame on, and hands back the one before, as ready as it was. Images that both
    /// plans would draw alike are handed over with their textures: only what differs is drawn.
    void exchange(PreparedPlan& prepared);

    /// Uploads meshes, materials, lights and sky. The scene must outlive the renderer or the next call.
    Result<void> set_scene(const Scene& scene);
    /// The slower part of `set_scene`, which makes no GL call: it may run on another thread while frames are drawn.
    /// Errors   those of `set_scene` but for gl_error and out_of_memory.
    Result<SceneImages> images_of(const Scene& scene) const;
    /// The rest of it. `images` are those of this scene.
    Result<void> set_scene(const Scene& scene, SceneImages images);
    /// Uploads a picture as the import `name`; values are brought into the signal's domain first.
    /// Errors   unknown_import, import_extent (not the extent the plan was compiled for).
    Result<void> import_picture(std::string_view name, const Picture& picture);
    Result<void> import_cube(std::string_view name, const std::array<Picture, 6>& faces);
    /// Reads the host's own texture as the import `name`.
    Result<void> import_texture(std::string_view name, const HostTexture& texture);

    /// Sets a live parameter ("lit.exposure"). Errors: unknown_param (or one folded into the code), param_out_of_range.
    Result<void> set(std::string_view place, const Value& value);

    /// Draws what the outputs need and the textures do not hold yet: a step runs again when a parameter, the camera, the
    /// scene, an import or an image that it reads has changed; each frame when it reads the frame or a host's texture.
    /// Errors   import_missing, scene_missing, facts_unmet (the plan was compiled for a scene with less), gl_error (names the
    ///          step).
    Result<void> render(const Frame& frame = {});

    /// An output's values, decoded from its codec. Shape: the output's extent and its signal's components.
    /// Errors   unknown_output, gl_error.
    Result<Picture> read(std::string_view output);
    /// One texel of an output. Shape: 1 x 1 texel of the signal's components.
    Result<Picture> read_texel(std::string_view output, int x, int y);
    /// The GL texture of an output, for the host to draw or sample. It holds codes, not values.
    Result<HostTexture> texture(std::string_view output) const;

    /// Waits until all that was drawn is done: for timing by the wall clock.
    void finish();

    /// The textures and channels in which an output's codes stand, in the codes' order: a layout may spread them.
    /// Errors   unknown_output, import_missing.
    Result<std::vector<StoredCodes>> codes(std::string_view output) const;

    const Plan& plan() const;
    /// Per step of the last frame, when `is_timed`; waits for the frame to finish.
    std::vector<StepTime> step_times();
    /// GL objects created, and draws issued, since `create`: for tests and reports.
    struct Counters {
        std::int64_t objects_created = 0;
        std::int64_t draws = 0;
        std::int64_t state_changes = 0;
        std::int64_t redundant_state_changes = 0; ///< asked for and not issued
    };
    Counters counters() const;
    /// GL_RENDERER and GL_VERSION, for reports.
    std::string device_name() const;

private:
    class Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace passgraph
