// The renderer: one context's objects, and the order in which a frame uses them.
#include <cmath>

#include <fmt/format.h>

#include "gl/renderer_impl.hpp"

namespace passgraph {
namespace {

constexpr double kTimeWrap = 3600.0; // seconds: single precision still tells 1/60 s apart

bool needs_scene(const Plan::Step& step)
{
    return step.kind == Plan::Step::Kind::geometry || step.host.lights || step.host.elements;
}

} // namespace

Renderer::Impl::~Impl()
{
    // A current program would outlive its deletion.
    GLint current = 0;
    driver_.gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
    const auto is_current = [&](GLuint program) { return program == static_cast<GLuint>(current); };
    if (programs_.holds(is_current) || std::any_of(objects_.steps.begin(), objects_.steps.end(),
                                                   [&](const auto& step) { return is_current(step.program.id()); }))
        driver_.gl.UseProgram(0);
}

Result<SceneImages::Impl> Renderer::Impl::images_of(const Scene& scene) const
{
    return gl::make_scene_images(scene, driver_.limits);
}

Result<void> Renderer::Impl::set_scene(const Scene& scene, SceneImages::Impl images)
{
    Call call(*this);
    Result<gl::SceneBuffers> made = gl::create_scene_buffers(call.upload, samplers_, scene, std::move(images));
    if (!made)
        return tl::unexpected(std::move(made.error()));
    if (scene_buffers_)
        std::swap(*scene_buffers_, *made);
    else
        scene_buffers_ = std::move(*made);
    scene_ = &scene;
    ++scene_version_;
    camera_.reset();
    return {};
}

template <class Take> Result<void> Renderer::Impl::import(const Take& take)
{
    Call call(*this);
    return take(call.upload, *imports_);
}

const Camera* Renderer::Impl::camera_of(const Frame& frame) const
{
    if (frame.camera != nullptr)
        return frame.camera;
    return scene_ != nullptr ? &scene_->camera : nullptr;
}

/// A plan for what one scene calls for would draw another scene wrongly.
Errors Renderer::Impl::find_broken_promises() const
{
    Facts facts = scene_buffers_ ? scene_buffers_->facts : objects_.plan.facts;
    for (int i = 0; i < static_cast<int>(objects_.plan.imports.size()); ++i)
        if (const gl::ImportTexture& import = (*imports_)[i]; import.import.kind == Plan::Import::Kind::sky && import.id != 0)
            facts.sky = import.brightest;
    Errors errors;
    for (std::string& broken : broken_promises(objects_.plan.facts, facts))
        errors.push_back({.code = "facts_unmet",
                          .message = std::move(broken),
                          .hint = "compile for this scene: CompileOptions::facts = facts_of(scene)"});
    return errors;
}

Errors Renderer::Impl::find_missing(const Frame& frame) const
{
    Errors errors = imports_->find_missing();
    append(errors, find_broken_promises());
    for (const Plan::Import& import : objects_.plan.imports)
        if (import.kind == Plan::Import::Kind::atlas && scene_ == nullptr)
            errors.push_back({.code = "scene_missing",
                              .message = fmt::format("`{}` is a scene's, and there is none", import.name),
                              .hint = "call set_scene before render"});
    for (const Plan::Step& step : objects_.plan.steps) {
        if (needs_scene(step) && scene_ == nullptr)
            errors.push_back({.code = "scene_missing",
                              .message = fmt::format("step `{}` draws or lights a scene, and there is none", step.name),
                              .hint = "call set_scene before render"});
        else if (step.host.camera && camera_of(frame) == nullptr)
            errors.push_back({.code = "scene_missing",
                              .message = fmt::format("step `{}` needs a camera, and there is none", step.name),
                              .hint = "call set_scene, or set Frame::camera"});
    }
    return errors;
}

void Renderer::Impl::update_camera(gl::Upload& upload, const Camera& camera)
{
    const bool is_same = camera_ && gl::same_camera(*camera_, camera);
    if (is_same && view_extent_ == objects_.plan.extent)
        return;
    if (!is_same) // another plan's extent is no change of what a plan holds
        ++camera_version_;
    camera_ = camera;
    view_extent_ = objects_.plan.extent;
    const gl::View view = gl::view_of(camera, objects_.plan.extent, driver_.gl.ClipControl != nullptr);
    blocks_->set_camera(driver_.gl, view.block);
    if (scene_buffers_)
        gl::upload_view(upload, *scene_buffers_, *scene_, view);
}

glsl::FrameBlock Renderer::Impl::frame_block(const Frame& frame) const
{
    return {.time = static_cast<float>(std::fmod(frame.time, kTimeWrap)),
            .delta = static_cast<float>(frame.delta),
            .index = frame.index,
            .is_cut = frame.is_cut || is_first_frame_ ? 1 : 0,
            .light_count = scene_ != nullptr ? static_cast<std::int32_t>(scene_->lights.size()) : 0};
}

gl::DrawInputs Renderer::Impl::draw_inputs(const std::vector<gl::TextureObject>& slots, const gl::Imports& imports)
{
    return {driver_.gl,
            state_,
            slots,
            imports,
            scene_buffers_ ? &*scene_buffers_ : nullptr,
            empty_vertex_array_.id(),
            black_cube_};
}

gl::Versions Renderer::Impl::versions() const
{
    gl::Versions versions{.camera = camera_version_, .scene = scene_version_, .frame = frame_version_};
    for (int i = 0; i < static_cast<int>(objects_.plan.imports.size()); ++i) {
        const gl::ImportTexture& import = (*imports_)[i];
        versions.imports.push_back(import.id == 0 ? scene_version_ : import.version != 0 ? import.version : frame_version_);
    }
    for (const gl::StepObjects& step : objects_.steps)
        versions.params.push_back(gl::version_of(step.program.uniforms));
    return versions;
}

Result<void> Renderer::Impl::render(const Frame& frame)
{
    if (Errors missing = find_missing(frame); !missing.empty())
        return tl::unexpected(std::move(missing));
    Call call(*this);
    if (const Camera* camera = camera_of(frame))
        update_camera(call.upload, *camera);
    blocks_->set_frame(driver_.gl, frame_block(frame));
    blocks_->bind(state_);
    const gl::DrawInputs inputs = draw_inputs(objects_.slots, *imports_);
    frame_version_ = (frame_version_ + 1) | std::uint64_t{1} << 62; // equal to no other kind of version
    const std::vector<bool> stale = objects_.freshness.stale(objects_.plan, versions(), frame.redraws);
    const bool counts = gl::may_count(driver_.gl, objects_.plan);
    const std::vector<bool> answers = objects_.freshness.answers(objects_.plan, stale, counts);
    std::vector<gl::StepQueries> queries(stale.size());
    objects_.timing.mark_start(driver_.gl, state_);
    for (size_t i = 0; i < objects_.steps.size(); ++i) {
        const Plan::Step& step = objects_.plan.steps[i];
        if (options_.before_step) {
            options_.before_step();
            state_.reset();
            blocks_->bind(state_);
        }
        call.watch.enter(fmt::format("step `{}`", step.name));
        if (stale[i]) {
            queries[i] = gl::queries_of(driver_.gl, objects_, i, answers, counts);
            draws_ += gl::draw_step(inputs, step, objects_.steps[i], queries[i]);
        }
        objects_.timing.mark_end_of(driver_.gl, i);
        if (checks_each_step_)
            call.watch.check();
        call.watch.leave();
    }
    Errors errors = call.watch.take();
    // After an error that only the frame's end noticed, the next frame finds the step.
    checks_each_step_ = !errors.empty();
    if (!errors.empty()) {
        objects_.freshness.forget();
        return tl::unexpected(std::move(errors));
    }
    objects_.freshness.have_run(objects_.plan, stale, counts);
    objects_.timing.frame_done();
    drawn_ = stale;
    queries_ = std::move(queries);
    is_first_frame_ = false;
    return {};
}

Result<const Plan::Output*> Renderer::Impl::find_output(std::string_view name) const
{
    std::vector<std::string> names;
    for (const Plan::Output& output : objects_.plan.outputs) {
        if (output.name == name)
            return &output;
        names.push_back(output.name);
    }
    return fail({.code = "unknown_output",
                 .message = fmt::format("the plan has no output `{}`", name),
                 .hint = suggest(name, names, "outputs")});
}

GLuint Renderer::Impl::texture_of(const Plan::Output& output) const
{
    if (output.source == Plan::Read::Source::slot)
        return objects_.slots[static_cast<size_t>(output.index)].id();
    return (*imports_)[output.index].id;
}

Result<HostTexture> Renderer::Impl::texture(std::string_view name) const
{
    const Result<const Plan::Output*> output = find_output(name);
    if (!output)
        return tl::unexpected(output.error());
    const GLuint id = texture_of(**output);
    if (id == 0)
        return fail({.code = "import_missing",
                     .message = fmt::format("output `{}` is an import, and nothing was imported", name),
                     .hint = "call import_picture or import_texture first"});
    return HostTexture{id, (*output)->extent};
}

Result<std::vector<StoredCodes>> Renderer::Impl::codes(std::string_view name) const
{
    const Result<HostTexture> first = texture(name);
    if (!first)
        return tl::unexpected(first.error());
    const Plan::Output& output = **find_output(name);
    std::vector<StoredCodes> codes;
    codes.push_back({{texture_of(output), output.extent}, "rgba"});
    return codes;
}

Result<Picture> Renderer::Impl::read(std::string_view name, gl::Rectangle window)
{
    const Result<HostTexture> texture = this->texture(name);
    if (!texture)
        return tl::unexpected(texture.error());
    const Plan::Output& output = **find_output(name);
    const bool is_slot = output.source == Plan::Read::Source::slot;
    Call call(*this);
    const gl::Rectangle part = window.extent == Extent{} ? gl::Rectangle{0, 0, output.extent} : window;
    const Format format = is_slot ? objects_.plan.slots[static_cast<size_t>(output.index)].format : Format::rgba32f;
    const Result<Picture> raw = reader_->read(call.upload, texture->id, format, part);
    if (!raw)
        return tl::unexpected(raw.error());
    // An import holds values as they are.
    const Codec codec = is_slot ? output.codec : Codec{"rgba32f", Format::rgba32f, Packing::plain};
    const DepthRange range = camera_ ? DepthRange{camera_->near_plane, camera_->far_plane} : DepthRange{};
    return decode_texels(*raw, output.signal, codec, range);
}

std::vector<StepTime> Renderer::Impl::step_times() const
{
    std::vector<StepTime> times = objects_.timing.read(driver_.gl, objects_.plan);
    for (size_t i = 0; i < std::min(times.size(), drawn_.size()); ++i) {
        times[i].was_drawn = drawn_[i];
        times[i].was_skipped = gl::was_skipped(driver_.gl, queries_[i]);
    }
    return times;
}

Renderer::Counters Renderer::Impl::counters() const
{
    return {.objects_created = driver_.objects_created,
            .draws = draws_,
            .state_changes = state_.issued(),
            .redundant_state_changes = state_.redundant()};
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(Plan plan, const RendererOptions& options)
{
    Result<gl::Driver> driver = gl::create_driver(options.loader);
    if (!driver)
        return tl::unexpected(std::move(driver.error()));
    auto impl = std::make_unique<Impl>(options, std::move(*driver));
    if (Result<void> built = impl->build(std::move(plan)); !built)
        return tl::unexpected(std::move(built.error()));
    return Renderer(std::move(impl));
}

Result<void> Renderer::set_scene(const Scene& scene)
{
    Result<SceneImages> images = images_of(scene);
    if (!images)
        return tl::unexpected(std::move(images.error()));
    return set_scene(scene, std::move(*images));
}

Result<SceneImages> Renderer::images_of(const Scene& scene) const
{
    Result<SceneImages::Impl> images = std::as_const(*impl_).images_of(scene);
    if (!images)
        return tl::unexpected(std::move(images.error()));
    return SceneImages(std::make_unique<SceneImages::Impl>(std::move(*images)));
}

Result<void> Renderer::set_scene(const Scene& scene, SceneImages images)
{
    return impl_->set_scene(scene, std::move(*images.impl_));
}

Result<void> Renderer::import_picture(std::string_view name, const Picture& picture)
{
    return impl_->import(
        [&](gl::Upload& upload, gl::Imports& imports) { return imports.set_picture(upload, name, picture); });
}

Result<void> Renderer::import_cube(std::string_view name, const std::array<Picture, 6>& faces)
{
    return impl_->import(
        [&](gl::Upload& upload, gl::Imports& imports) { return imports.set_cube(upload, name, faces); });
}

Result<void> Renderer::import_texture(std::string_view name, const HostTexture& texture)
{
    return impl_->import(
        [&](gl::Upload& upload, gl::Imports& imports) { return imports.set_host_texture(upload, name, texture); });
}

Result<void> Renderer::set(std::string_view place, const Value& value)
{
    return gl::set_parameter(impl_->objects(), place, value);
}

Result<void> Renderer::render(const Frame& frame)
{
    return impl_->render(frame);
}
Result<Picture> Renderer::read(std::string_view output)
{
    return impl_->read(output, {});
}
Result<Picture> Renderer::read_texel(std::string_view output, int x, int y)
{
    return impl_->read(output, {x, y, {1, 1}});
}
Result<HostTexture> Renderer::texture(std::string_view output) const
{
    return impl_->texture(output);
}
Result<std::vector<StoredCodes>> Renderer::codes(std::string_view output) const
{
    return impl_->codes(output);
}
const Plan& Renderer::plan() const
{
    return std::as_const(*impl_).plan();
}
std::vector<StepTime> Renderer::step_times()
{
    return impl_->step_times();
}
void Renderer::finish()
{
    impl_->finish();
}
Renderer::Counters Renderer::counters() const
{
    return impl_->counters();
}
std::string Renderer::device_name() const
{
    return impl_->device_name();
}

} // namespace passgraph
