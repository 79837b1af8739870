// Building of a plan's GL objects.
#include "gl/targets.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

void append(Errors& errors, Errors&& more)
{
    errors.insert(errors.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void check_extent(Extent extent, const std::string& subject, const Limits& limits, Errors& errors)
{
    if (extent.width <= 0 || extent.height <= 0)
        errors.push_back({.code = "extent_empty",
                          .message = fmt::format("{} has {} x {} texels", subject, extent.width, extent.height)});
    else if (extent.width > limits.texture_size || extent.height > limits.texture_size)
        errors.push_back({.code = "extent_too_large",
                          .message = fmt::format("{} has {} x {} texels, the device takes {}", subject, extent.width,
                                                 extent.height, limits.texture_size),
                          .hint = "render a smaller picture",
                          .fault = Fault::machine});
}

std::string subject_of(const Plan::Slot& slot)
{
    return fmt::format("the texture of `{}`", fmt::join(slot.images, "`, `"));
}

Errors find_extent_errors(const Plan& plan, const Limits& limits)
{
    Errors errors;
    for (const Plan::Slot& slot : plan.slots)
        check_extent(slot.extent, subject_of(slot), limits, errors);
    for (const Plan::Import& import : plan.imports)
        if (import.kind == Plan::Import::Kind::picture)
            check_extent(import.extent, fmt::format("import `{}`", import.name), limits, errors);
    return errors;
}

std::string_view status_name(GLenum status)
{
    switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: return "an attachment cannot be drawn into";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT: return "nothing is attached";
    case GL_FRAMEBUFFER_UNSUPPORTED: return "the driver does not support this combination of formats";
    default: return "the driver gives no reason";
    }
}

Error incomplete(const Plan& plan, const Plan::Step& step, GLenum status)
{
    std::vector<std::string> images;
    for (const Plan::Target& target : step.targets)
        images.push_back(
            fmt::format("{} ({})", target.image, name(plan.slots[static_cast<size_t>(target.slot)].format)));
    if (step.depth_slot >= 0)
        images.push_back(fmt::format("depth ({})", name(plan.slots[static_cast<size_t>(step.depth_slot)].format)));
    return {.code = "framebuffer_incomplete",
            .message = fmt::format("step `{}` cannot draw into {}: {}", step.name, fmt::join(images, ", "),
                                   status_name(status)),
            .hint = "choose other codecs for these images",
            .fault = Fault::machine};
}

/// Makes the step's slots the attachments of a framebuffer, which is bound then.
void attach(Upload& upload, const Plan::Step& step, GLuint framebuffer, const std::vector<TextureObject>& slots)
{
    upload.state.draw_framebuffer(framebuffer);
    const auto attach_slot = [&](GLenum attachment, int slot) {
        upload.driver.gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, attachment, GL_TEXTURE_2D,
                                              slots[static_cast<size_t>(slot)].id(), 0);
    };
    for (size_t i = 0; i < step.targets.size(); ++i)
        attach_slot(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), step.targets[i].slot);
    // A tested depth may be sampled by the same step: nothing writes it, so there is no feedback.
    if (const int depth = step.depth_slot >= 0 ? step.depth_slot : step.tested_depth_slot; depth >= 0)
        attach_slot(GL_DEPTH_ATTACHMENT, depth);
}

Result<FramebufferObject> create_framebuffer(Upload& upload, const Plan& plan, const Plan::Step& step,
                                             const std::vector<TextureObject>& slots)
{
    if (const int most = upload.driver.limits.color_targets; static_cast<int>(step.targets.size()) > most)
        return fail({.code = "too_many_targets",
                     .message = fmt::format("step `{}` draws into {} images, the device takes {}", step.name,
                                            step.targets.size(), most),
                     .hint = "choose a layout with fewer targets",
                     .fault = Fault::machine});
    const Functions& gl = upload.driver.gl;
    FramebufferObject framebuffer(upload.driver);
    attach(upload, step, framebuffer.id(), slots);
    std::vector<GLenum> buffers;
    for (size_t i = 0; i < step.targets.size(); ++i)
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    if (buffers.empty())
        buffers.push_back(GL_NONE);
    gl.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    const GLenum status = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return fail(incomplete(plan, step, status));
    return framebuffer;
}

/// The step's program, linked before or now.
Result<Program> obtain_program(Upload& upload, ProgramPool& pool, const Plan::Step& step)
{
    std::string key = ProgramPool::key_of(step);
    if (std::shared_ptr<LinkedProgram> linked = pool.find(key))
        return wire_program(upload.driver, upload.state, step, std::move(linked));
    Result<Program> program = create_program(upload.driver, upload.state, step);
    if (program)
        pool.add(std::move(key), program->linked);
    return program;
}

Result<StepObjects> create_step(Upload& upload, const Workshop& workshop, const PlanObjects& made)
{
    const Plan& plan = made.plan;
    const Plan::Step& step = plan.steps[made.steps.size()];
    Result<FramebufferObject> framebuffer = create_framebuffer(upload, plan, step, made.slots);
    Result<Program> program = obtain_program(upload, workshop.programs, step);
    Errors errors;
    if (!framebuffer)
        append(errors, std::move(framebuffer.error()));
    if (!program)
        append(errors, std::move(program.error()));
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    StepObjects objects{.framebuffer = std::move(*framebuffer), .program = std::move(*program)};
    for (const auto& [fragment, other] :
         {std::pair{&step.background, &objects.background}, {&step.when_skipped, &objects.when_skipped}, {&step.scout, &objects.scout}}) {
        if (fragment->empty())
            continue;
        Plan::Step variant = step;
        variant.fragment = *fragment;
        Result<Program> made_too = obtain_program(upload, workshop.programs, variant);
        if (!made_too)
            return tl::unexpected(std::move(made_too.error()));
        *other = std::move(*made_too);
    }
    for (const Plan::Read& read : step.reads) {
        if (read.is_loaded) {
            objects.bindings.push_back({.loaded_format = internal_format(plan.slots[static_cast<size_t>(read.index)].format)});
            continue;
        }
        const GLuint plain = workshop.samplers.get(read.filter, read.wrap, read.wrap, false);
        const bool may_have_levels =
            read.source == Plan::Read::Source::import &&
            (read.has_levels || plan.imports[static_cast<size_t>(read.index)].kind != Plan::Import::Kind::picture);
        objects.bindings.push_back(
            {.plain = plain, .with_levels = may_have_levels ? workshop.samplers.get(read.filter, read.wrap, read.wrap, true) : plain});
    }
    objects.has_srgb_target = std::any_of(step.targets.begin(), step.targets.end(), [&](const Plan::Target& target) {
        return plan.slots[static_cast<size_t>(target.slot)].format == Format::srgb8_a8;
    });
    return objects;
}

} // namespace

std::vector<Program*> StepObjects::programs()
{
    std::vector<Program*> all = {&program};
    for (std::optional<Program>* other : {&background, &when_skipped, &scout})
        if (*other)
            all.push_back(&**other);
    return all;
}

Result<PlanObjects> begin_plan_objects(Upload& upload, Plan plan, bool is_timed)
{
    if (Errors errors = find_extent_errors(plan, upload.driver.limits); !errors.empty())
        return tl::unexpected(std::move(errors));
    PlanObjects objects;
    for (const Plan::Slot& slot : plan.slots) {
        upload.watch.enter(subject_of(slot));
        objects.slots.push_back(create_target(upload, slot.format, slot.extent));
        upload.watch.check();
        upload.watch.leave();
    }
    // Framebuffers on textures that could not be allocated would only say the same again.
    if (Errors errors = upload.watch.take(); !errors.empty())
        return tl::unexpected(std::move(errors));
    if (is_timed)
        objects.timing = Timing(upload, plan.steps.size());
    for (size_t query = 0; query < plan.queries.size(); ++query)
        objects.queries.push_back({QueryObject(upload.driver)});
    objects.freshness = Freshness(plan);
    objects.plan = std::move(plan);
    return objects;
}

Errors add_step_objects(Upload& upload, const Workshop& workshop, PlanObjects& objects)
{
    assert(!objects.is_complete());
    Errors errors;
    upload.watch.enter(fmt::format("step `{}`", objects.plan.steps[objects.steps.size()].name));
    Result<StepObjects> made = create_step(upload, workshop, objects);
    if (made) {
        for (const Program* program : made->programs())
            objects.units = most(objects.units, program->units);
        objects.steps.push_back(std::move(*made));
        upload.watch.check();
    } else {
        append(errors, std::move(made.error()));
        objects.steps.emplace_back();
    }
    upload.watch.leave();
    append(errors, upload.watch.take());
    return errors;
}

void carry_over(Upload& upload, PlanObjects& from, PlanObjects& to, const Versions& versions)
{
    const Freshness::CarriedOver carried = to.freshness.carry_over(to.plan, versions, from.freshness);
    for (const Freshness::Carried& image : carried.slots)
        std::swap(from.slots[image.from], to.slots[image.to]);
    for (const Freshness::Carried& query : carried.queries)
        std::swap(from.queries[query.from], to.queries[query.to]);
    if (carried.slots.empty())
        return;
    for (PlanObjects* objects : {&from, &to})
        for (size_t i = 0; i < objects->steps.size(); ++i)
            attach(upload, objects->plan.steps[i], objects->steps[i].framebuffer.id(), objects->slots);
}

Result<PlanObjects> create_plan_objects(Upload& upload, const Workshop& workshop, Plan plan, bool is_timed)
{
    Result<PlanObjects> objects = begin_plan_objects(upload, std::move(plan), is_timed);
    if (!objects)
        return objects;
    Errors errors;
    while (!objects->is_complete())
        append(errors, add_step_objects(upload, workshop, *objects));
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return objects;
}

} // namespace passgraph::gl
