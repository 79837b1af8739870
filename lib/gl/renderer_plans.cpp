// Taking in of plans: all at once, or bit by bit while another one runs.
#include <cassert>

#include <fmt/format.h>

#include "gl/renderer_impl.hpp"

namespace passgraph {

void Renderer::Impl::create_shared_objects(gl::Upload& upload)
{
    blocks_.emplace(driver_);
    reader_.emplace(upload);
    empty_vertex_array_ = gl::VertexArrayObject(driver_);
    std::array<Picture, 6> black;
    black.fill(Picture({1, 1}, 4));
    black_cube_ = gl::create_cube(upload, black);
}

/// Lets a plan run; `objects` is left holding the one before.
void Renderer::Impl::take_over(gl::Upload& upload, gl::PlanObjects&& objects, gl::Imports&& imports)
{
    if (imports_)
        imports.adopt(upload, std::move(*imports_));
    imports_ = std::move(imports);
    std::swap(objects_, objects);
    gl::carry_over(upload, objects, objects_, versions());
    is_first_frame_ = checks_each_step_ = true;
    drawn_.clear();
    queries_.clear();
}

Result<void> Renderer::Impl::build(Plan plan)
{
    Call call(*this);
    if (!reader_)
        create_shared_objects(call.upload);
    Result<gl::PlanObjects> made =
        gl::create_plan_objects(call.upload, {samplers_, programs_}, std::move(plan), options_.is_timed);
    if (!made)
        return tl::unexpected(std::move(made.error()));
    gl::Imports imports(made->plan);
    take_over(call.upload, std::move(*made), std::move(imports));
    return {};
}

Result<std::unique_ptr<PreparedPlan::Impl>> Renderer::Impl::prepare(Plan plan)
{
    Call call(*this);
    Result<gl::PlanObjects> begun = gl::begin_plan_objects(call.upload, std::move(plan), options_.is_timed);
    if (!begun)
        return tl::unexpected(std::move(begun.error()));
    gl::Imports imports(begun->plan);
    imports.borrow(*imports_);
    return std::make_unique<PreparedPlan::Impl>(PreparedPlan::Impl{std::move(*begun), std::move(imports)});
}

Result<void> Renderer::Impl::advance(PreparedPlan::Impl& prepared)
{
    if (prepared.objects.is_complete())
        return {};
    const size_t next = prepared.objects.steps.size();
    const Plan::Step& step = prepared.objects.plan.steps[next];
    const int reads = static_cast<int>(step.reads.size());
    const gl::Units units{std::min(reads + gl::kSceneUnits, driver_.limits.texture_units), std::min(reads, driver_.limits.image_units)};
    Call call(*this, most(objects_.units, units));
    prepared.imports.borrow(*imports_); // the host may have imported others meanwhile
    Errors errors = gl::add_step_objects(call.upload, {samplers_, programs_}, prepared.objects);
    const bool has_scene = scene_buffers_ || (step.kind != Plan::Step::Kind::geometry && !step.host.lights);
    if (errors.empty() && has_scene) {
        call.watch.enter(fmt::format("step `{}`", step.name));
        gl::DrawInputs inputs = draw_inputs(prepared.objects.slots, prepared.imports);
        inputs.only_warms_up = true;
        blocks_->bind(state_);
        gl::draw_step(inputs, step, prepared.objects.steps[next]);
        call.watch.check();
        call.watch.leave();
        errors = call.watch.take();
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

void Renderer::Impl::exchange(PreparedPlan::Impl& prepared)
{
    assert(prepared.objects.is_complete());
    Call call(*this);
    gl::Imports before(objects_.plan);
    take_over(call.upload, std::move(prepared.objects), std::move(prepared.imports));
    before.borrow(*imports_);
    prepared.imports = std::move(before);
}

Result<void> Renderer::replace(Plan plan)
{
    return impl_->build(std::move(plan));
}

Result<PreparedPlan> Renderer::prepare(Plan plan)
{
    Result<std::unique_ptr<PreparedPlan::Impl>> begun = impl_->prepare(std::move(plan));
    if (!begun)
        return tl::unexpected(std::move(begun.error()));
    return PreparedPlan(std::move(*begun));
}

Result<void> Renderer::advance(PreparedPlan& prepared)
{
    return impl_->advance(*prepared.impl_);
}

void Renderer::exchange(PreparedPlan& prepared)
{
    impl_->exchange(*prepared.impl_);
}

PreparedPlan::PreparedPlan(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PreparedPlan::PreparedPlan(PreparedPlan&&) noexcept = default;
PreparedPlan& PreparedPlan::operator=(PreparedPlan&&) noexcept = default;
PreparedPlan::~PreparedPlan() = default;

bool PreparedPlan::is_ready() const
{
    return impl_->objects.is_complete();
}
size_t PreparedPlan::steps_made() const
{
    return impl_->objects.steps.size();
}
const Plan& PreparedPlan::plan() const
{
    return impl_->objects.plan;
}

} // namespace passgraph
