// The loop of the window.
#include "tool/view/session.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <passgraph/scene/bounds.hpp>

namespace passgraph::tool::view {
namespace {

constexpr double kLookEvery = 0.05;      // seconds between looks at the files
constexpr double kClickWay = 4.0;        // pixels that a hand trembles
constexpr double kSlowestStep = 0.25;    // seconds: a machine that slept is not flown on
constexpr double kFast = 4.0;            // with Shift

/// Crosses the scene in seven seconds.
double speed_for(const Scene& scene)
{
    const Bounds box = bounds(scene);
    const double across = box.is_empty() ? 2.0 : static_cast<double>(glm::length(box.high - box.low));
    return std::max(across / 7.0, 1e-3);
}

} // namespace

Session::Session(const ViewOptions& options, Opening opening, std::unique_ptr<Window> window, Stage stage, const Device& device)
    : options_(options), device_(device), window_(std::move(window)), stage_(std::move(stage)),
      inspector_(stage_), loader_(std::move(opening.loader)), watch_(watched_paths(options_))
{
    state_.stacks = std::move(opening.stacks);
    state_.library = std::move(opening.library);
    state_.mistakes.passes = std::move(opening.pass_errors);
    tell({}, state_.mistakes.passes);
    // A panel would hide most of a small window.
    state_.shows_panel = !options_.hides_panel && window_->width() >= 720;
    if (opening.scene)
        take_scene({std::move(opening.scene), {}});
    pick_stack(0);
}

Session::~Session() = default;

double Session::now() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

Extent Session::wanted_extent() const
{
    const auto side = [&](int pixels) {
        return std::clamp(static_cast<int>(std::lround(pixels * options_.render_scale)), 1, device_.max_texture_size);
    };
    return {side(window_extent_.width), side(window_extent_.height)};
}

CompileOptions Session::compile_options() const
{
    CompileOptions options = options_.compiler;
    options.extent = planned_extent_;
    options.device = device_;
    options.facts = facts_;
    return options;
}

Frame Session::frame() const
{
    return {.time = drawn_time_, .delta = 1.0 / 60.0, .index = frames_, .is_cut = false, .camera = nullptr};
}

Inspected Session::inspected(const Camera* camera, const CompileOptions& options) const
{
    Frame inspected_frame = frame();
    inspected_frame.camera = camera;
    return {state_.stack(), *state_.library, options, inspected_frame};
}

double Session::seconds_to_wait() const
{
    if (window_->is_minimised())
        return 0.1;
    const bool is_flying = flight_ && (flight_->is_moving() || keys_.is_any_held());
    if (is_flying || needs_frame_ || (stage_.is_waiting() && !is_awaiting_scene()) || inspector_.is_asked())
        return 0.0;
    if (presents_ > 0 || window_->is_interface_active())
        return 0.012;
    return kLookEvery;
}

void Session::run()
{
    while (!is_ended_ && !window_->wants_to_close()) {
        const bool was_still = !flight_ || !(flight_->is_moving() || keys_.is_any_held());
        const std::vector<WindowEvent> events = window_->wait(seconds_to_wait());
        const double time = now();
        // A key that was just pressed has not been held while the window slept.
        const double step = was_still ? 1.0 / 60.0 : std::min(time - last_step_, kSlowestStep);
        last_step_ = time;
        take_events(events);
        if (time - last_look_ >= kLookEvery) {
            last_look_ = time;
            watch_files();
        }
        take_loaded();
        take_saved();
        if (window_->is_minimised())
            continue;
        if (window_->take_damage())
            presents_ = std::max(presents_, 2);
        move_camera(step);
        work_on_plans();
        const bool is_animated = stage_.is_ready() && std::any_of(stage_.plan().steps.begin(), stage_.plan().steps.end(),
                                                                  [](const Plan::Step& s) { return s.host.frame; });
        if (needs_frame_ || is_animated)
            draw_frame();
        if (presents_ > 0 || window_->is_interface_active() || time < state_.notice_until + 0.1)
            present();
    }
}

void Session::take_events(const std::vector<WindowEvent>& events)
{
    if (!events.empty())
        presents_ = 3;
    for (const WindowEvent& event : events) {
        keys_.take(event);
        if (const std::optional<Order> order = order_of(event))
            obey(*order);
        take_left_button(event);
    }
}

void Session::take_left_button(const WindowEvent& event)
{
    switch (event.kind) {
    case WindowEvent::Kind::left_down:
        is_dragging_ = true;
        has_dragged_ = false;
        press_x_ = drag_x_ = event.x;
        press_y_ = drag_y_ = event.y;
        break;
    case WindowEvent::Kind::pointer:
        if (!is_dragging_)
            break;
        has_dragged_ |= std::hypot(event.x - press_x_, event.y - press_y_) > kClickWay;
        if (has_dragged_ && flight_) {
            flight_->turn(event.x - drag_x_, event.y - drag_y_, window_extent_.height);
            needs_frame_ = true;
        }
        if (has_dragged_) {
            drag_x_ = event.x;
            drag_y_ = event.y;
        }
        break;
    case WindowEvent::Kind::left_up:
        if (std::exchange(is_dragging_, false) && !has_dragged_ && stage_.is_ready())
            ask_at(event.x, event.y);
        break;
    case WindowEvent::Kind::focus_lost: is_dragging_ = false; break;
    default: break;
    }
}

void Session::reset_camera()
{
    speed_ = speed_for(*scene_);
    flight_.emplace(scene_->camera, speed_);
    needs_frame_ = true;
}

void Session::ask_at(double x, double y)
{
    const Presenter::Place place = Presenter::place_of(stage_.plan().extent, window_extent_);
    // The pointer's place is a pixel's corner; its middle is half a pixel on.
    const double u = (x + 0.5 - place.x) / place.extent.width;
    const double v = (window_extent_.height - y - 0.5 - place.y) / place.extent.height;
    if (u < 0.0 || u >= 1.0 || v < 0.0 || v >= 1.0)
        return;
    state_.probed = {u, v};
    inspector_.forget_answer();
    inspector_.ask(u, v);
}

void Session::move_camera(double seconds)
{
    if (!flight_)
        return;
    const bool is_flying = flight_->is_moving() || keys_.is_any_held();
    if (!is_flying)
        return;
    flight_->set_speed(speed_ * (keys_.is_fast() ? kFast : 1.0));
    flight_->advance(seconds, keys_.take_wish());
    needs_frame_ = true;
}

void Session::draw_frame()
{
    needs_frame_ = false;
    if (!stage_.is_ready() || is_awaiting_scene())
        return;
    Frame next = frame();
    drawn_time_ = now();
    next.delta = drawn_time_ - next.time;
    next.time = drawn_time_;
    const Camera camera = flight_ ? flight_->camera() : Camera{};
    next.camera = flight_ ? &camera : nullptr;
    Errors before = std::exchange(state_.mistakes.frame, {});
    if (const Result<void> drawn = stage_.draw(next); !drawn)
        state_.mistakes.frame = drawn.error();
    else
        ++frames_;
    tell(before, state_.mistakes.frame);
    last_change_ = now();
    inspector_.frame_changed();
    presents_ = std::max(presents_, 1);
    if (state_.probed && !inspector_.is_asked())
        state_.probed.reset(); // those were the values of another picture
}

void Session::present()
{
    presents_ = std::max(presents_ - 1, 0);
    if (const Result<void> shown = stage_.show(window_extent_); !shown)
        state_.mistakes.frame = shown.error();
    window_->begin_interface();
    const PanelOrders orders = draw_interface(state_, stage_, inspector_, {window_extent_.width, window_extent_.height, now()});
    window_->draw_interface();
    window_->show();
    if (change_ && !stage_.is_waiting() && !needs_plan_ && !loader_->is_busy() && !needs_frame_)
        tell_how_long();
    obey(orders);
}

} // namespace passgraph::tool::view
