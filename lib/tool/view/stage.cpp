// The running plan, the coming plan, and the frame.
#include "tool/view/stage.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "tool/view/stack.hpp"

namespace passgraph::tool::view {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

/// The smallest and largest values of a component, those of `scale` beyond its limits left out.
template <class Scale> std::pair<float, float> range_of(const Picture& picture, size_t component, const Scale& scale)
{
    float low = kLargest;
    float high = -kLargest;
    for (size_t i = component; i < picture.texels.size(); i += static_cast<size_t>(picture.channels)) {
        const float value = scale(picture.texels[i]);
        if (value > -kLargest && value < kLargest) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    return low < high ? std::pair(low, high) : std::pair(low == kLargest ? 0.0f : low - 0.5f, low == kLargest ? 1.0f : low + 0.5f);
}

/// Positions and depths are lengths of any size: black to white is what the picture holds. Near is white.
void find_range(ShownImage& image, const Picture& values, const DepthRange& planes)
{
    if (image.signal == Signal::depth) {
        // d = n (f - z) / (z (f - n)); what is stored as a distance is shown as one.
        const float across = planes.far_plane - planes.near_plane;
        const auto scale = [&](float d) {
            if (!(d > 0.0f))
                return kLargest;
            return image.codec.packing == Packing::linear
                       ? planes.near_plane * planes.far_plane / (planes.near_plane + d * across)
                       : 1.0f / d;
        };
        const auto [near, far] = range_of(values, 0, scale);
        const float beyond = far + 0.15f * (far - near); // the farthest surface is told from nothing at all
        image.low.fill(beyond);
        image.high.fill(near);
    } else if (image.signal == Signal::position) {
        for (size_t c = 0; c < 3; ++c) {
            const auto [low, high] = range_of(values, c, [](float x) { return x; });
            image.low[c] = low;
            image.high[c] = high;
        }
    }
}

} // namespace

void copy_values(const Plan& from, Renderer& renderer)
{
    for (const Plan::Step& step : from.steps)
        for (const Plan::Uniform& uniform : step.uniforms)
            // A value that the compiler accepted is in range, and the plans run alike: this cannot fail.
            (void)renderer.set(uniform.place, uniform.value);
}

Result<Stage> Stage::create(GlLoader loader)
{
    Result<Renderer> renderer = Renderer::create(Plan{}, {.loader = loader, .is_timed = true});
    if (!renderer)
        return tl::unexpected(renderer.error());
    Result<Presenter> presenter = Presenter::create(loader);
    if (!presenter)
        return tl::unexpected(presenter.error());
    return Stage(std::move(*renderer), std::move(*presenter));
}

void Stage::want(Plan plan)
{
    if (has_plan_ && runs_alike(renderer_.plan(), plan)) {
        coming_.reset();
        copy_values(plan, renderer_);
        wanted_.reset();
        return;
    }
    if (!coming_ || !runs_alike(coming_->plan(), plan))
        coming_.reset();
    wanted_ = std::move(plan);
}

Errors Stage::work()
{
    if (!wanted_)
        return {};
    const auto give_up = [&](Errors errors) {
        coming_.reset();
        wanted_.reset();
        return errors;
    };
    if (!coming_) {
        Result<PreparedPlan> begun = renderer_.prepare(*wanted_);
        if (!begun)
            return give_up(begun.error());
        coming_ = std::move(*begun);
        // Programs that are known cost nothing: go on at once.
    }
    const auto start = std::chrono::steady_clock::now();
    while (!coming_->is_ready()) {
        if (const Result<void> made = renderer_.advance(*coming_); !made)
            return give_up(made.error());
        if (std::chrono::steady_clock::now() - start > std::chrono::milliseconds(20) && !coming_->is_ready())
            return {};
    }
    renderer_.exchange(*coming_);
    coming_.reset();
    copy_values(*wanted_, renderer_);
    wanted_.reset();
    has_plan_ = true;
    step_times_.clear();
    shown_.reset();
    return {};
}

float Stage::progress() const
{
    if (!coming_ || coming_->plan().steps.empty())
        return 0.0f;
    return static_cast<float>(coming_->steps_made()) / static_cast<float>(coming_->plan().steps.size());
}

Result<void> Stage::set_scene(std::shared_ptr<const Scene> scene, SceneImages images)
{
    if (Result<void> set = renderer_.set_scene(*scene, std::move(images)); !set)
        return set;
    scene_ = std::move(scene);
    return {};
}

Result<ShownImage> Stage::shown_output(const Plan::Output& output)
{
    Result<std::vector<StoredCodes>> codes = renderer_.codes(output.name);
    if (!codes)
        return tl::unexpected(codes.error());
    ShownImage image{.codes = std::move(*codes), .signal = output.signal, .codec = output.codec};
    if (output.signal == Signal::depth || output.signal == Signal::position) {
        const Result<Picture> values = renderer_.read(output.name);
        if (!values)
            return tl::unexpected(values.error());
        find_range(image, *values, range_);
    }
    return image;
}

/// A step that was not drawn this time keeps what it took the last time.
void Stage::keep_times(std::vector<StepTime> times)
{
    for (size_t i = 0; i < std::min(times.size(), step_times_.size()); ++i)
        if (!times[i].was_drawn && times[i].step == step_times_[i].step)
            times[i] = step_times_[i];
    for (const StepTime& time : times)
        if (time.was_drawn && !time.was_skipped)
            drawn_ms_[time.step] = time.milliseconds;
    step_times_ = std::move(times);
}

double Stage::last_drawn_ms(const std::string& step) const
{
    const auto found = drawn_ms_.find(step);
    return found == drawn_ms_.end() ? 0.0 : found->second;
}

Result<void> Stage::draw(const Frame& frame)
{
    const auto start = std::chrono::steady_clock::now();
    if (frame.camera != nullptr)
        range_ = {frame.camera->near_plane, frame.camera->far_plane};
    if (Result<void> drawn = renderer_.render(frame); !drawn)
        return drawn;
    keep_times(renderer_.step_times()); // waits for the frame
    frame_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    Result<ShownImage> image = shown_output(renderer_.plan().outputs.front());
    if (!image)
        return tl::unexpected(image.error());
    shown_ = std::move(*image);
    return {};
}

Result<void> Stage::come_back(const Frame& frame)
{
    if (!shown_)
        return {};
    if (Result<void> drawn = renderer_.render(frame); !drawn)
        return drawn;
    Result<std::vector<StoredCodes>> codes = renderer_.codes(renderer_.plan().outputs.front().name);
    if (!codes)
        return tl::unexpected(codes.error());
    shown_->codes = std::move(*codes);
    return {};
}

Result<void> Stage::show(Extent window)
{
    return shown_ ? presenter_.show(*shown_, window) : presenter_.clear();
}

} // namespace passgraph::tool::view
