// A plan's GL objects: its slots, and per step a framebuffer, a program and the samplers it reads through.
#pragma once

#include <optional>
#include <vector>

#include <passgraph/core/plan.hpp>

#include "gl/freshness.hpp"
#include "gl/programs.hpp"
#include "gl/textures.hpp"
#include "gl/timing.hpp"

namespace passgraph::gl {

/// How a read's texture is bound.
struct ReadBinding {
    GLuint plain = 0; ///< which of the two samplers is used depends on the levels of the texture that the import turned out to be
    GLuint with_levels = 0;
    GLenum loaded_format = 0; ///< of an image that texels are loaded from, without any sampler
};

struct StepObjects {
    FramebufferObject framebuffer;
    Program program;
    std::optional<Program> background{};  ///< of a step in two parts
    std::optional<Program> when_skipped{}; ///< of a step that has a variant for what is black
    std::optional<Program> scout{};       ///< of a step that is to be looked for first
    std::vector<ReadBinding> bindings{}; ///< per read
    bool has_srgb_target = false;

    /// All there are.
    std::vector<Program*> programs();
};

/// A query of a plan.
struct CountingQuery {
    QueryObject object;
    bool has_counted = false;
};

struct PlanObjects {
    Plan plan;
    std::vector<TextureObject> slots;
    std::vector<StepObjects> steps;
    std::vector<CountingQuery> queries;
    Timing timing;
    Freshness freshness;
    Units units{.textures = 1}; ///< that steps use, and uploads: at least unit 0

    bool is_complete() const { return steps.size() == plan.steps.size(); }
};

/// What the making of objects takes them from.
struct Workshop {
    Samplers& samplers;
    ProgramPool& programs;
};

/// A plan's objects without any step yet.
/// Errors   extent_too_large, extent_empty, out_of_memory.
Result<PlanObjects> begin_plan_objects(Upload& upload, Plan plan, bool is_timed);

/// Makes the objects of the first step that has none; a program whose texts the pool knows is taken from it.
/// Errors   shader_failed, texture_units_exceeded, image_units_exceeded, framebuffer_incomplete; the step then has empty objects.
Errors add_step_objects(Upload& upload, const Workshop& workshop, PlanObjects& objects);

/// Gives a plan that is about to run the textures of another one that hold what it would draw, and the queries that have
/// counted it; `versions` are its own. After an edit only what changed is drawn.
void carry_over(Upload& upload, PlanObjects& from, PlanObjects& to, const Versions& versions);

/// Everything a plan's frames need.
/// Errors   those of both, all of them at once as far as they do not follow from each other.
Result<PlanObjects> create_plan_objects(Upload& upload, const Workshop& workshop, Plan plan, bool is_timed);

} // namespace passgraph::gl
