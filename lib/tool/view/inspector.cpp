// Plans of all images: made, run once, read.
#include "tool/view/inspector.hpp"

#include <algorithm>
#include <cmath>

namespace passgraph::tool::view {
namespace {

constexpr int kThumbnailWidth = 240; // of the whole picture: what a panel of 2 columns shows, one to one

Extent small_extent(Extent extent)
{
    const int width = std::min(extent.width, kThumbnailWidth);
    return {width, std::max(1, static_cast<int>(std::lround(static_cast<double>(extent.height) * width / std::max(extent.width, 1))))};
}

int texel_of(double share, int texels)
{
    return std::clamp(static_cast<int>(share * texels), 0, texels - 1);
}

} // namespace

void Inspector::plan_changed()
{
    small_.wanted.reset();
    whole_.wanted.reset();
    thumbnails_are_old_ = true;
}

/// True when the look's plan is ready to run.
bool Inspector::make(Look& look, const Inspected& inspected, Extent extent)
{
    if (!look.wanted) {
        CompileOptions options = inspected.options;
        options.extent = extent;
        Result<Plan> plan = plan_of_all_images(inspected.stack, inspected.library, options);
        if (!plan) {
            errors_ = plan.error();
            return false;
        }
        if (look.prepared && !runs_alike(look.prepared->plan(), *plan))
            look.prepared.reset();
        look.wanted = std::move(*plan);
    }
    Renderer& renderer = stage_.renderer();
    if (!look.prepared) {
        Result<PreparedPlan> begun = renderer.prepare(*look.wanted);
        if (!begun) {
            errors_ = begun.error();
            return false;
        }
        look.prepared = std::move(*begun);
    }
    if (look.prepared->is_ready())
        return true;
    if (const Result<void> made = renderer.advance(*look.prepared); !made) {
        errors_ = made.error();
        look.prepared.reset();
        return false;
    }
    return look.prepared->is_ready();
}

/// Draws one frame of the look's plan and reads its outputs, then lets the window's plan run again.
template <class Read> void Inspector::run(Look& look, const Frame& frame, const Read& read)
{
    Renderer& renderer = stage_.renderer();
    renderer.exchange(*look.prepared);
    copy_values(*look.wanted, renderer);
    errors_.clear();
    if (const Result<void> drawn = renderer.render(frame); !drawn)
        errors_ = drawn.error();
    else
        for (const Plan::Output& output : renderer.plan().outputs)
            read(output);
    renderer.exchange(*look.prepared);
    if (const Result<void> back = stage_.come_back(frame); !back)
        append(errors_, back.error());
}

bool Inspector::work_on_thumbnails(const Inspected& inspected)
{
    if (!thumbnails_are_old_ || !make(small_, inspected, small_extent(inspected.options.extent))) {
        if (!errors_.empty())
            thumbnails_are_old_ = false; // the same would go wrong again
        return false;
    }
    thumbnails_.clear();
    run(small_, inspected.frame, [&](const Plan::Output& output) {
        const Result<ShownImage> image = stage_.shown_output(output);
        if (!image)
            return;
        const Result<HostTexture> kept = stage_.presenter().keep(thumbnails_.size(), *image, small_extent(inspected.options.extent));
        if (kept)
            thumbnails_.push_back({output.name, output.signal, *kept});
    });
    thumbnails_are_old_ = false;
    return true;
}

void Inspector::ask(double u, double v)
{
    place_ = Place{std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)};
}

bool Inspector::work_on_answer(const Inspected& inspected)
{
    if (!place_)
        return false;
    errors_.clear();
    if (!make(whole_, inspected, inspected.options.extent)) {
        if (!errors_.empty())
            place_.reset();
        return false;
    }
    answer_.clear();
    run(whole_, inspected.frame, [&](const Plan::Output& output) {
        ProbedValue probed{output.name, output.signal, texel_of(place_->u, output.extent.width), texel_of(place_->v, output.extent.height),
                           output.extent, {}};
        if (const Result<Picture> texel = stage_.renderer().read_texel(output.name, probed.x, probed.y))
            probed.values = texel->texels;
        answer_.push_back(std::move(probed));
    });
    place_.reset();
    whole_.prepared.reset(); // its textures are many; its programs stay in the renderer's pool
    return true;
}

} // namespace passgraph::tool::view
