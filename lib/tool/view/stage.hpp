// Draws plans in the window: keeps one running while the next is made ready, and shows what it draws.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include <passgraph/gl/presenter.hpp>
#include <passgraph/gl/renderer.hpp>

namespace passgraph::tool::view {

/// Everything that draws. `want` says which plan should run; `work` brings it about bit by bit, one program each time.
class Stage {
public:
    static Result<Stage> create(GlLoader loader);

    /// The plan to run from now on. One that differs in live values alone runs at once.
    void want(Plan plan);
    /// Goes on making the wanted plan. Returns what went wrong: the plan is then given up, and the one before runs on.
    Errors work();
    bool is_building() const { return coming_.has_value(); }
    bool is_waiting() const { return wanted_.has_value(); } ///< there is something for `work`
    /// Share of the wanted plan that is made.
    float progress() const;
    /// The plan that runs may be drawn: there is one, and what it needs is there.
    bool is_ready() const { return has_plan_; }

    Result<void> set_scene(std::shared_ptr<const Scene> scene, SceneImages images);
    bool has_scene() const { return scene_ != nullptr; }

    Result<void> draw(const Frame& frame);
    /// The output of the last frame drawn, to be shown.
    const std::optional<ShownImage>& shown() const { return shown_; }
    /// Finds the output again after another plan ran in between; draws only what that one took away.
    Result<void> come_back(const Frame& frame);
    Result<void> show(Extent window);

    const Plan& plan() const { return renderer_.plan(); }
    Renderer& renderer() { return renderer_; }
    Presenter& presenter() { return presenter_; }
    const std::vector<StepTime>& step_times() const { return step_times_; }
    double frame_ms() const { return frame_ms_; }
    /// What a step took when it was last drawn, for one that the device leaves out; 0: it never was.
    double last_drawn_ms(const std::string& step) const;

    /// An output as it can be shown: with the range of its values where the signal has none of its own.
    Result<ShownImage> shown_output(const Plan::Output& output);

private:
    void keep_times(std::vector<StepTime> times);
    Stage(Renderer renderer, Presenter presenter) : renderer_(std::move(renderer)), presenter_(std::move(presenter)) {}

    std::shared_ptr<const Scene> scene_; ///< before the renderer, which reads it
    Renderer renderer_;
    Presenter presenter_;
    std::optional<PreparedPlan> coming_;
    std::optional<Plan> wanted_; ///< whose live values the coming plan gets
    bool has_plan_ = false;
    std::optional<ShownImage> shown_;
    DepthRange range_; ///< of the camera
    std::vector<StepTime> step_times_;
    std::map<std::string, double> drawn_ms_; ///< by step
    double frame_ms_ = 0.0;
};

/// Sets every live value of the plan that runs to those of one that runs alike.
void copy_values(const Plan& from, Renderer& renderer);

} // namespace passgraph::tool::view
