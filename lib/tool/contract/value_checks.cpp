// Finite, in range, replaced or contained, guarded: what becomes of values inside and outside the domain.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <passgraph/core/codec.hpp>

#include "tool/contract/feeds.hpp"
#include "tool/contract/hostile.hpp"
#include "tool/contract/judge.hpp"
#include "tool/contract/scenes.hpp"
#include "tool/contract/suite.hpp"
#include "tool/contract/values.hpp"

namespace passgraph::tool::contract {
namespace {

void replace_by_guard(Picture& picture, Texel texel, Signal signal)
{
    Picture one({1, 1}, picture.channels);
    const auto first = picture.texels.begin() + static_cast<std::ptrdiff_t>(picture.index(texel.x, texel.y));
    std::copy_n(first, picture.channels, one.texels.begin());
    apply_guard(one, signal);
    std::copy(one.texels.begin(), one.texels.end(), first);
}

/// The checks of one stage's values, under one way of being set up.
class ValueChecks {
public:
    ValueChecks(const Subject& subject, StageOptions options) : subject_(subject), options_(std::move(options)), random_(20171124) {}

    void run(bool with_injections)
    {
        options_.hostile = hostile_builtins();
        options_.is_guarded = false;
        std::optional<Stage> stage = open_stage(subject_, options_);
        if (!stage)
            return;
        for (const Scene* scene : scenes()) {
            for (const Filling filling : fillings()) {
                const Feed feed = fill(filling);
                if (const auto outputs = run_stage(subject_, *stage, feed, scene, options_)) {
                    judge_finite(*outputs, feed, scene, std::string(name(filling)));
                    judge_range(*outputs, feed, "range", std::string(name(filling)));
                }
            }
        }
        if (!with_injections)
            return;
        for (const InputPort& port : subject_.pass->inputs)
            if (port.over != Over::scene)
                inject(*stage, port);
        check_guarded();
    }

private:
    std::vector<Filling> fillings() const
    {
        if (subject_.pass->inputs.empty())
            return {Filling::random}; // nothing to be filled
        return {Filling::random, Filling::random, Filling::edges, Filling::edges, Filling::lowest, Filling::highest, Filling::alike};
    }

    const std::vector<const Scene*>& scenes() const { return scenes_for(*subject_.pass); }

    Signal signal(Signal declared) const { return signal_of(declared, options_); }
    Contract::Span range_of(const OutputPort& port) const { return span_of(subject_.contract().range, port.name, signal(port.signal)); }

    Feed fill(Filling filling) { return fill_inputs(subject_, options_, filling, random_); }

    void report(std::string check, std::string fed, std::string place, std::string got, std::string expected, std::string hint)
    {
        subject_.findings.add({std::move(check), to_text(options_.settings), std::move(fed), std::move(place), std::move(got),
                               std::move(expected), std::move(hint)});
    }

    void judge_finite(const Outputs& outputs, const Feed& feed, const Scene* scene, const std::string& fed)
    {
        subject_.findings.count_run("finite");
        for (const auto& [output, picture] : outputs) {
            const auto bad = find_texel(picture, [&](Texel texel) { return !is_finite(picture, texel); });
            if (!bad)
                continue;
            const std::string cause = subject_.findings.is_full("finite") ? "" : cause_of(feed, scene);
            report("finite", fed, place_text(output, *bad, picture.extent), texel_text(picture, *bad), "a finite value", cause);
            return;
        }
    }

    /// The builtin whose undefined results it comes from, or plain arithmetic.
    std::string cause_of(const Feed& feed, const Scene* scene)
    {
        StageOptions lenient = options_;
        for (const std::string& builtin : hostile_builtins()) {
            lenient.forgiving = builtin;
            if (!is_bad_under(lenient, feed, scene))
                return fmt::format("GLSL leaves `{}` undefined where {}: some drivers give NaN there, others hide it. Decide before, with an "
                                   "ordered select (x > 0.0 ? f(x) : 0.0)",
                                   builtin, undefined_when(builtin));
        }
        return "look for x / 0, 0 / 0 and Inf - Inf, and decide with an ordered select (d > 0.0 ? x / d : 0.0)";
    }

    bool is_bad_under(const StageOptions& options, const Feed& feed, const Scene* scene)
    {
        auto stage = Stage::create(subject_.library, subject_.pass, options, subject_.loader);
        const auto outputs = stage ? stage->run(feed, scene) : tl::unexpected(stage.error());
        return outputs && !is_all_finite(*outputs);
    }

    void judge_range(const Outputs& outputs, const Feed& feed, const std::string& check, const std::string& fed)
    {
        subject_.findings.count_run(check);
        double largest_fed = 1.0; // constants of a pass are no larger
        for (const auto& [port, picture] : feed)
            largest_fed = std::max(largest_fed, largest_of(picture));
        for (const OutputPort& port : subject_.pass->outputs) {
            const Picture& picture = outputs.at(port.name);
            const Contract::Span range = range_of(port);
            const double size = std::max(largest_fed, largest_of(picture));
            if (port.signal == Signal::depth && subject_.pass->kind == PassKind::geometry)
                continue; // the rasteriser's own
            const bool is_empty_ok = subject_.pass->kind == PassKind::geometry; // a pixel without geometry is 0
            const auto bad = find_texel(picture, [&](Texel texel) {
                const bool is_empty = is_empty_ok && is_zero(picture, texel);
                return !is_empty && (check == "replaced" || is_finite(picture, texel)) && !is_in_range(picture, texel, signal(port.signal), range, size);
            });
            if (!bad)
                continue;
            report(check, fed, place_text(port.name, *bad, picture.extent), texel_text(picture, *bad), range_text(signal(port.signal), range),
                   check == "replaced" ? "decide with an ordered select: a comparison with NaN is false, min, max and clamp of NaN are undefined"
                                       : "a store would cut it off unseen: scale the result, or state its range");
            return;
        }
    }

    /// How far a bad texel may reach, in texels of the input; nullopt after reporting that nobody says.
    std::optional<double> reach_of(const InputPort& port)
    {
        const std::vector<std::string>& anywhere = subject_.contract().anywhere;
        if (port.over != Over::image || std::find(anywhere.begin(), anywhere.end(), port.name) != anywhere.end())
            return HUGE_VAL; // a place in a table or a direction has no neighbourhood in the picture
        if (subject_.contract().within)
            return value_of(*subject_.contract().within, *subject_.pass, options_.settings);
        if (!subject_.contract().is_stated && port.access.radius == Access::kUnknownRadius)
            return HUGE_VAL; // nobody has promised anything
        const bool is_known = port.access.kind != AccessClass::warp && port.access.radius != Access::kUnknownRadius && !subject_.pass->composite;
        if (is_known)
            return port.access.radius + (port.filter == Filter::linear ? 1.0 : 0.0);
        report("contained", "", fmt::format("`{}`", port.name), fmt::format("read by {}", to_text(port.access)), "a bound",
               "say how far a bad texel may reach: \"contract\": { \"non_finite\": { \"contained\": TEXELS } }");
        return std::nullopt;
    }

    void inject(Stage& stage, const InputPort& port)
    {
        const std::optional<double> reach = reach_of(port);
        const Scene* scene = scenes().front();
        const Feed clean = fill(Filling::random);
        const auto before = run_stage(subject_, stage, clean, scene, options_);
        if (!reach || !before)
            return;
        const Contract::Span domain = span_of(subject_.contract().domain, port.name, signal(port.signal));
        const Extent extent = extent_of(port, options_);
        for (const Injection& injection : injections()) {
            // A corner, the middle, and one component alone in between.
            const std::array<Texel, 2> texels = {{{extent.width / 2, extent.height / 2}, {0, extent.height - 1}}};
            for (size_t i = 0; i < texels.size(); ++i) {
                Feed feed = clean;
                Picture& picture = feed.at(port.name);
                for (int c = 0; c < (i == 1 ? 1 : picture.channels); ++c)
                    picture.at(texels[i].x, texels[i].y, c) = injection.value;
                const std::string fed = fmt::format("{} in `{}` at ({}, {})", injection.name, port.name, texels[i].x, texels[i].y);
                const auto outputs = run_stage(subject_, stage, feed, scene, options_);
                if (!outputs)
                    return;
                if (is_in_domain(injection.value, signal(port.signal), domain)) {
                    judge_finite(*outputs, feed, scene, fed);
                    judge_range(*outputs, feed, "range", fed);
                } else if (subject_.contract().non_finite == Contract::NonFinite::replaced) {
                    judge_range(*outputs, feed, "replaced", fed);
                }
                judge_contained(*before, *outputs, port, texels[i], *reach, fed);
            }
        }
    }

    void judge_contained(const Outputs& before, const Outputs& after, const InputPort& port, Texel bad, double reach, const std::string& fed)
    {
        subject_.findings.count_run("contained");
        const Extent in = extent_of(port, options_);
        for (const auto& [output, picture] : after) {
            const Extent out = picture.extent;
            const auto distance = [&](int a, int sides, int b, int other_sides) {
                return std::abs((a + 0.5) * other_sides / sides - (b + 0.5));
            };
            const auto changed = find_texel(picture, [&](Texel texel) {
                const double away = std::max(distance(texel.x, out.width, bad.x, in.width), distance(texel.y, out.height, bad.y, in.height));
                return away > reach + 0.5 && !is_same(picture, before.at(output), texel);
            });
            if (!changed)
                continue;
            report("contained", fed, place_text(output, *changed, out), texel_text(picture, *changed),
                   fmt::format("{} as without it, {} texels away at most", texel_text(before.at(output), *changed), reach),
                   "the pass reads further than it says: correct \"contained\", or the offsets it reads at");
            return;
        }
    }

    /// With guards, a bad texel is as good as its replacement, and what comes out keeps to its signal.
    void check_guarded()
    {
        options_.is_guarded = true;
        std::optional<Stage> stage = open_stage(subject_, options_);
        if (!stage)
            return;
        const Scene* scene = scenes().front();
        for (const InputPort& port : subject_.pass->inputs) {
            if (port.over == Over::scene)
                continue;
            const Feed clean = fill(Filling::random);
            for (const Injection& injection : injections()) {
                Feed feed = clean;
                const Extent extent = extent_of(port, options_);
                for (int c = 0; c < feed.at(port.name).channels; ++c)
                    feed.at(port.name).at(extent.width / 2, extent.height / 2, c) = injection.value;
                const auto outputs = run_stage(subject_, *stage, feed, scene, options_);
                Feed scrubbed = feed;
                replace_by_guard(scrubbed.at(port.name), {extent.width / 2, extent.height / 2}, signal(port.signal));
                const auto expected = run_stage(subject_, *stage, scrubbed, scene, options_);
                if (outputs && expected)
                    judge_guarded(*outputs, *expected, port,
                                  fmt::format("{} in `{}` at ({}, {}), guards on", injection.name, port.name, extent.width / 2, extent.height / 2),
                                  std::isfinite(injection.value));
            }
        }
        options_.is_guarded = false;
    }

    void judge_guarded(const Outputs& outputs, const Outputs& expected, const InputPort& port, const std::string& fed, bool is_finite_value)
    {
        subject_.findings.count_run("guarded");
        // A filtered read is guarded behind the filter, which the bad texel has passed by then; and a vector that is made
        // to length 1 twice may differ in a last bit from one made so once.
        const bool is_exact = port.filter == Filter::nearest && port.filter_by.empty() && port.over == Over::image &&
                              !subject_.pass->composite && !(signal(port.signal) == Signal::normal && is_finite_value);
        for (const OutputPort& output : subject_.pass->outputs) {
            const Picture& picture = outputs.at(output.name);
            const Contract::Span domain = span_of({}, output.name, signal(output.signal));
            const auto bad = find_texel(picture, [&](Texel texel) {
                return !is_in_range(picture, texel, signal(output.signal), domain, HUGE_VAL) || !is_finite(picture, texel);
            });
            if (bad) {
                report("guarded", fed, place_text(output.name, *bad, picture.extent), texel_text(picture, *bad),
                       range_text(signal(output.signal), domain), "a guard lets it through: this is a mistake of passgraph's own");
                return;
            }
            const auto other = find_texel(picture, [&](Texel texel) { return is_exact && !is_same(picture, expected.at(output.name), texel); });
            if (!other)
                continue;
            report("guarded", fed, place_text(output.name, *other, picture.extent), texel_text(picture, *other),
                   fmt::format("{}, as with the guard's replacement", texel_text(expected.at(output.name), *other)), "");
            return;
        }
    }

    const Subject& subject_;
    StageOptions options_;
    std::mt19937 random_;
};

/// A geometry pass under each layout: what its places and derivations give back.
void check_layouts(const Subject& subject)
{
    static const Scene meshes = hard_meshes();
    for (const Layout& layout : subject.pass->layouts) {
        StageOptions options;
        options.is_guarded = true;
        options.takes_codecs_of_layout = true;
        PassArguments::Setting setting;
        setting.name = "layout";
        setting.item = layout.name;
        options.settings = {setting};
        std::optional<Stage> stage = open_stage(subject, options);
        const auto outputs = stage ? run_stage(subject, *stage, {}, &meshes, options) : std::nullopt;
        if (!outputs)
            continue;
        subject.findings.count_run("layouts");
        for (const OutputPort& port : subject.pass->outputs) {
            const Picture& picture = outputs->at(port.name);
            const Contract::Span domain = span_of({}, port.name, port.signal);
            const auto bad = find_texel(picture, [&](Texel texel) {
                return !is_finite(picture, texel) || (port.signal != Signal::normal && !is_in_range(picture, texel, port.signal, domain, HUGE_VAL));
            });
            if (bad)
                subject.findings.add({"layouts", to_text(options.settings), "hard meshes", place_text(port.name, *bad, picture.extent),
                                      texel_text(picture, *bad), range_text(port.signal, domain), ""});
        }
    }
}

} // namespace

void check_values(const Subject& subject)
{
    // What has no input has its extent from its header alone; a composite's passes are tested on their own besides.
    const bool is_plain = !subject.pass->composite && !subject.pass->inputs.empty();
    const std::vector<Extent> all = {{17, 13}, {1, 1}, {1, 9}, {9, 1}};
    const std::vector<Extent> usual = {all.front()};
    const auto run = [&](const Settings& settings, Signal generic, const std::vector<Extent>& extents, bool with_injections) {
        for (const Extent extent : extents)
            ValueChecks(subject, {.settings = settings, .generic = generic, .extent = extent}).run(with_injections && extent != all[1]);
    };
    for (const Signal generic : generic_signals(*subject.pass)) {
        for (const Settings& settings : selection_variants(*subject.pass)) {
            const bool is_default = settings.empty();
            run(settings, generic, is_plain || (is_default && subject.pass->composite) ? all : usual, is_plain || is_default);
        }
        for (const Settings& settings : parameter_variants(*subject.pass))
            run(settings, generic, is_plain ? std::vector<Extent>{all[0], all[1]} : usual, is_plain);
    }
    check_layouts(subject);
}

} // namespace passgraph::tool::contract
