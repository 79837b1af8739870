// The renderer's inside: one context's objects. Its files share this: renderer.cpp draws frames, renderer_plans.cpp changes plans.
#pragma once

#include <optional>

#include <passgraph/gl/renderer.hpp>

#include "gl/drawing.hpp"
#include "gl/parameters.hpp"
#include "gl/queries.hpp"
#include "gl/read_back.hpp"
#include "gl/state_guard.hpp"

namespace passgraph {

/// A plan's objects as far as they are made.
class PreparedPlan::Impl {
public:
    gl::PlanObjects objects;
    gl::Imports imports;
};

class Renderer::Impl {
public:
    Impl(const RendererOptions& options, gl::Driver&& driver)
        : options_(options), driver_(std::move(driver)), state_(driver_), samplers_(driver_)
    {
    }
    ~Impl();

    Result<void> build(Plan plan);
    Result<std::unique_ptr<PreparedPlan::Impl>> prepare(Plan plan);
    Result<void> advance(PreparedPlan::Impl& prepared);
    void exchange(PreparedPlan::Impl& prepared);
    Result<SceneImages::Impl> images_of(const Scene& scene) const;
    Result<void> set_scene(const Scene& scene, SceneImages::Impl images);
    Result<void> render(const Frame& frame);
    Result<Picture> read(std::string_view output, gl::Rectangle window);
    Result<HostTexture> texture(std::string_view output) const;
    Result<std::vector<StoredCodes>> codes(std::string_view output) const;
    std::vector<StepTime> step_times() const;
    template <class Take> Result<void> import(const Take& take);

    gl::PlanObjects& objects() { return objects_; }
    const Plan& plan() const { return objects_.plan; }
    gl::Imports& imports() { return *imports_; }
    const std::string& device_name() const { return driver_.device_name; }
    Counters counters() const;
    void finish() const { driver_.gl.Finish(); }

private:
    struct Call;

    void create_shared_objects(gl::Upload& upload);
    void take_over(gl::Upload& upload, gl::PlanObjects&& objects, gl::Imports&& imports);
    gl::DrawInputs draw_inputs(const std::vector<gl::TextureObject>& slots, const gl::Imports& imports);
    Errors find_missing(const Frame& frame) const;
    Errors find_broken_promises() const;
    const Camera* camera_of(const Frame& frame) const;
    void update_camera(gl::Upload& upload, const Camera& camera);
    glsl::FrameBlock frame_block(const Frame& frame) const;
    gl::Versions versions() const;
    Result<const Plan::Output*> find_output(std::string_view name) const;
    GLuint texture_of(const Plan::Output& output) const;

    RendererOptions options_;
    gl::Driver driver_; ///< before all objects, which are deleted through it
    gl::State state_;
    gl::Samplers samplers_;
    gl::ProgramPool programs_;
    gl::PlanObjects objects_;
    std::optional<gl::Imports> imports_;
    std::optional<gl::SceneBuffers> scene_buffers_;
    const Scene* scene_ = nullptr;
    std::optional<gl::FrameBlocks> blocks_;
    std::optional<gl::Reader> reader_;
    gl::VertexArrayObject empty_vertex_array_;
    gl::Cube black_cube_;
    std::optional<Camera> camera_; ///< that the camera block and the scene's buffers hold
    Extent view_extent_{}; ///< that they were made for
    std::uint64_t camera_version_ = 0;
    std::uint64_t scene_version_ = 0;
    std::uint64_t frame_version_ = 0;
    std::vector<bool> drawn_; ///< by step, in the last frame
    std::vector<gl::StepQueries> queries_; ///< by step, in the last frame
    bool is_first_frame_ = true;
    bool checks_each_step_ = true;
    std::int64_t draws_ = 0;
};

/// What each call that touches OpenGL starts and ends with.
struct Renderer::Impl::Call {
    std::optional<gl::StateGuard> guard; ///< first, so that it ends last
    gl::ErrorWatch watch;
    gl::Upload upload;

    explicit Call(Impl& impl) : Call(impl, impl.objects_.units) {}

    /// `units`: that it touches at most.
    Call(Impl& impl, gl::Units units)
        : guard(make_guard(impl, units)), watch(impl.driver_),
          upload{impl.driver_, impl.state_, watch, impl.options_.scrubs_imports, impl.options_.is_poisoned}
    {
        impl.state_.reset();
    }

    static std::optional<gl::StateGuard> make_guard(const Impl& impl, gl::Units units)
    {
        if (!impl.options_.restores_state)
            return std::nullopt;
        return std::optional<gl::StateGuard>(std::in_place, impl.driver_, units);
    }
};

} // namespace passgraph
