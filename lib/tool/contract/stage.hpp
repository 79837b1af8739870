// One pass alone on a device: every value stored in binary32, with or without the guards around it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <passgraph/core/compile.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph::tool::contract {

/// A value of a parameter or an item of a selection, and how people write it.
using Settings = std::vector<PassArguments::Setting>;
std::string to_text(const Settings& settings);

struct StageOptions {
    Settings settings{};
    Signal generic = Signal::radiance; ///< what inputs of signal `color` are fed with
    Extent extent{17, 13};
    bool is_guarded = false;                 ///< imports and stores bring values into their domains, as in any graph
    std::vector<std::string> hostile{};      ///< builtins that do their worst
    std::string forgiving{};                 ///< the one of them that does not
    std::string removed_bound{};             ///< min, max or clamp, replaced by its argument number `kept_argument`
    int kept_argument = 0;
    bool takes_codecs_of_layout = false;     ///< geometry: stored as its layout says, not in binary32
};

/// What goes in: by port. A port over a sphere takes six equal faces.
using Feed = std::map<std::string, Picture>;

class Stage {
public:
    /// Errors   those of compiling, and shader_failed.
    static Result<Stage> create(const PassLibrary& library, const PassPtr& pass, const StageOptions& options, GlLoader loader);

    /// Draws once. Errors: those of importing and drawing.
    Result<std::map<std::string, Picture>> run(const Feed& feed, const Scene* scene);

    const Plan& plan() const { return renderer_.plan(); }
    Renderer& renderer() { return renderer_; }

private:
    Stage(PassPtr pass, Renderer renderer) : pass_(std::move(pass)), renderer_(std::move(renderer)) {}

    PassPtr pass_;
    Renderer renderer_;
    const Scene* scene_ = nullptr;
};

/// The plan a stage would run: for checks that need no device.
Result<Plan> plan_of(const PassLibrary& library, const PassPtr& pass, const StageOptions& options);

/// The signal that a port has under these options.
Signal signal_of(Signal declared, const StageOptions& options);

/// The extent an input is fed with.
Extent extent_of(const InputPort& port, const StageOptions& options);

} // namespace passgraph::tool::contract
