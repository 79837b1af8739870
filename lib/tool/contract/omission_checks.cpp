// What a header lets a compiler leave out must not be missed: "identity", "ignores", "bound", "black", "skip",
// "only_where", "needs".
#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include <passgraph/core/facts.hpp>
#include <passgraph/scene/facts.hpp>

#include "tool/contract/scenes.hpp"
#include "tool/contract/suite.hpp"
#include "tool/contract/values.hpp"

namespace passgraph::tool::contract {
namespace {

/// One way in which a header's condition may be met: settings, and an input that is black.
struct Case {
    Settings settings;
    std::string black;
};

/// Settings around the defaults: each parameter at its ends, at 0 and at 1; each with no input black, and with each of them.
std::vector<Case> cases_of(const PassDeclaration& pass)
{
    std::vector<Settings> all = {{}};
    for (const Settings& settings : parameter_variants(pass))
        all.push_back(settings);
    for (const Param& param : pass.params)
        for (const double value : {0.0, 1.0})
            if (param.type != ParamType::enum_ && param.type != ParamType::bool_ && value >= param.lowest && value <= param.highest)
                all.push_back({number_setting(param, value)});
    std::vector<Case> cases;
    for (const Settings& settings : all) {
        cases.push_back({settings, ""});
        for (const InputPort& port : pass.inputs)
            if (port.over != Over::scene && is_light(port.signal))
                cases.push_back({settings, port.name});
    }
    return cases;
}

class OmissionChecks {
public:
    explicit OmissionChecks(const Subject& subject) : subject_(subject), pass_(*subject.pass), random_(5) {}

    void run()
    {
        for (const Identity& identity : pass_.identities)
            check_identity(identity);
        for (const InputPort& port : pass_.inputs)
            if (port.ignored_when)
                check_ignored(port);
        for (const OutputPort& port : pass_.outputs)
            if (port.bound)
                check_bound(port);
        for (size_t output = 0; output < pass_.outputs.size(); ++output)
            if (!pass_.black_inputs(static_cast<int>(output)).empty())
                check_black(static_cast<int>(output));
        if (!pass_.skip_when.empty())
            check_skip();
        for (const std::string& fact : pass_.needs)
            check_needs(fact);
        const auto depth = std::find_if(pass_.inputs.begin(), pass_.inputs.end(), [](const InputPort& port) { return port.signal == Signal::depth; });
        if (pass_.only_where != OnlyWhere::everywhere && depth != pass_.inputs.end())
            check_only_where(*depth);
    }

private:
    struct Drawing {
        StageOptions options;
        Feed feed;
        std::map<std::string, Picture> outputs;
    };

    Feed feed_of(const StageOptions& options, const std::string& black)
    {
        Feed feed;
        for (const InputPort& port : pass_.inputs) {
            if (port.over == Over::scene)
                continue;
            const Signal signal = signal_of(port.signal, options);
            Picture picture =
                picture_of(Filling::random, signal, span_of(subject_.contract().domain, port.name, signal), extent_of(port, options), random_);
            if (port.name == black)
                std::fill(picture.texels.begin(), picture.texels.end(), 0.0f);
            feed[port.name] = std::move(picture);
        }
        return feed;
    }

    std::optional<std::map<std::string, Picture>> draw(Stage& stage, const Feed& feed, const StageOptions& options) const
    {
        static const Scene scene = lit_scene();
        const bool has_scene = pass_.reads.lights || pass_.reads.camera || pass_.kind == PassKind::geometry;
        return run_stage(subject_, stage, feed, has_scene ? &scene : nullptr, options);
    }

    /// Calls `check` for every case under which the condition holds, with each item of each selection. Reports when none does.
    template <class Check> void for_each_case(const Formula& when, std::string_view rule, const Check& check)
    {
        bool is_met = false;
        for (const Case& one : cases_of(pass_)) {
            for (const Settings& selection : selection_variants(pass_)) {
                StageOptions options;
                options.settings = one.settings;
                options.settings.insert(options.settings.end(), selection.begin(), selection.end());
                if (value_of(when, pass_, options.settings, one.black) == 0.0)
                    continue;
                is_met = true;
                std::optional<Stage> stage = open_stage(subject_, options);
                if (!stage || !check(*stage, options, one.black))
                    return;
            }
        }
        const auto is_of_scene = [](const Formula::Name& name) { return find_fact(name.text) != nullptr; };
        if (!is_met && std::none_of(when.names().begin(), when.names().end(), is_of_scene))
            subject_.findings.add({std::string(rule), "", "", fmt::format("\"{}\"", when.text()), "no parameters within their ranges meet it",
                                   "a condition that can hold", "correct the condition, or the range"});
    }

    static std::string place_of(const Picture& picture, size_t component)
    {
        const auto texel = static_cast<int>(component) / picture.channels;
        return fmt::format("({}, {}) of {}x{}", texel % picture.extent.width, texel / picture.extent.width, picture.extent.width,
                           picture.extent.height);
    }

    void check_identity(const Identity& identity)
    {
        const InputPort& port = pass_.inputs[static_cast<size_t>(pass_.find_input(identity.is))];
        const bool is_filtered = port.filter == Filter::linear || !port.filter_by.empty();
        for_each_case(identity.when, "identity", [&](Stage& stage, const StageOptions& options, const std::string& black) {
            const Feed feed = feed_of(options, black);
            const auto outputs = draw(stage, feed, options);
            if (!outputs)
                return false;
            subject_.findings.count_run("identity");
            const Picture& out = outputs->begin()->second;
            const Picture& in = feed.at(identity.is);
            const float largest = is_filtered ? *std::max_element(in.texels.begin(), in.texels.end()) : 0.0f;
            for (size_t i = 0; i < out.texels.size(); ++i) {
                // A division is a product with a rounded reciprocal on many devices: x / x may miss 1 by a few last bits. And a
                // linear filter takes a rounding's share of the neighbors even at a texel's center.
                const float allowed = 4.0f / 16777216.0f * std::abs(in.texels[i]) + static_cast<float>(kRounding) * largest;
                if (std::abs(out.texels[i] - in.texels[i]) <= allowed)
                    continue;
                subject_.findings.add({"identity", to_text(options.settings), fed(black), place_of(out, i), fmt::format("{:.9g}", out.texels[i]),
                                       fmt::format("`{}` itself: {:.9g}", identity.is, in.texels[i]),
                                       "correct \"identity\", or the pass: a compiler leaves it out where the condition holds"});
                break;
            }
            return true;
        });
    }

    void check_ignored(const InputPort& port)
    {
        for_each_case(*port.ignored_when, "ignores", [&](Stage& stage, const StageOptions& options, const std::string& black) {
            Feed feed = feed_of(options, black);
            const auto with = draw(stage, feed, options);
            std::fill(feed.at(port.name).texels.begin(), feed.at(port.name).texels.end(), 0.0f); // as when it is left out
            const auto without = draw(stage, feed, options);
            if (!with || !without)
                return false;
            subject_.findings.count_run("ignores");
            for (const auto& [name, picture] : *with)
                for (size_t i = 0; i < picture.texels.size(); ++i)
                    if (const float other = without->at(name).texels[i]; std::memcmp(&other, &picture.texels[i], sizeof(float)) != 0) {
                        subject_.findings.add({"ignores", to_text(options.settings), fed(black), fmt::format("{} of `{}`", place_of(picture, i), name),
                                               fmt::format("{:.9g}", picture.texels[i]),
                                               fmt::format("as with `{}` black: {:.9g}", port.name, other),
                                               "correct \"ignores\", or the pass: a compiler does not compute what is ignored"});
                        return true;
                    }
            return true;
        });
    }

    void check_bound(const OutputPort& port)
    {
        for (const Case& one : cases_of(pass_)) {
            StageOptions options;
            options.settings = one.settings;
            std::optional<Stage> stage = open_stage(subject_, options);
            if (!stage)
                return;
            const Feed feed = feed_of(options, one.black);
            const auto outputs = draw(*stage, feed, options);
            if (!outputs)
                return;
            subject_.findings.count_run("bound");
            std::map<std::string, double, std::less<>> largest;
            for (const auto& [name, picture] : feed)
                largest[name] = static_cast<double>(*std::max_element(picture.texels.begin(), picture.texels.end()));
            const double bound = value_of(*port.bound, pass_, options.settings, largest);
            const Picture& out = outputs->at(port.name);
            for (size_t i = 0; i < out.texels.size(); ++i)
                if (static_cast<double>(out.texels[i]) > bound) {
                    subject_.findings.add({"bound", to_text(options.settings), fed(one.black), place_of(out, i), fmt::format("{:.9g}", out.texels[i]),
                                           fmt::format("`{}` at most {:.9g}", port.name, bound),
                                           "correct \"bound\", or the pass: what is bounded to nothing is left out"});
                    return;
                }
        }
    }

    /// Calls `check` with the stage of every set of parameters and of every item of each selection, until it says no.
    template <class Check> void for_each_setting(const Check& check)
    {
        std::vector<Settings> all = parameter_variants(pass_);
        const std::vector<Settings> selections = selection_variants(pass_);
        all.insert(all.end(), selections.begin(), selections.end());
        for (const Settings& settings : all) {
            StageOptions options;
            options.settings = settings;
            std::optional<Stage> stage = open_stage(subject_, options);
            if (!stage || !check(*stage, options))
                return;
        }
    }

    /// The first component that is not exactly 0 where `is_meant` says so; alpha is no light.
    template <class IsMeant> void judge_black(const Picture& out, const StageOptions& options, const std::string& rule, const std::string& fed,
                                              const std::string& hint, const IsMeant& is_meant)
    {
        subject_.findings.count_run(rule);
        for (size_t i = 0; i < out.texels.size(); ++i) {
            const auto channel = static_cast<int>(i % static_cast<size_t>(out.channels));
            if (channel == 3 || out.texels[i] == 0.0f || !is_meant(i / static_cast<size_t>(out.channels)))
                continue;
            subject_.findings.add({rule, to_text(options.settings), fed, place_of(out, i), fmt::format("{:.9g}", out.texels[i]), "exactly 0", hint});
            return;
        }
    }

    /// Inputs that are 0 everywhere make the output 0, whatever the others are.
    void check_black(int output)
    {
        const OutputPort& port = pass_.outputs[static_cast<size_t>(output)];
        for_each_setting([&](Stage& stage, const StageOptions& options) {
            Feed feed = feed_of(options, "");
            std::vector<std::string> names;
            for (const int input : pass_.black_inputs(output)) {
                names.push_back(pass_.inputs[static_cast<size_t>(input)].name);
                std::fill(feed.at(names.back()).texels.begin(), feed.at(names.back()).texels.end(), 0.0f);
            }
            const auto outputs = draw(stage, feed, options);
            if (outputs)
                judge_black(outputs->at(port.name), options, "black", fmt::format("random values, `{}` black", fmt::join(names, "` and `")),
                            "correct \"black\", or the pass: a compiler does not draw what black makes black", [](size_t) { return true; });
            return outputs.has_value();
        });
    }

    /// In a scene without what it needs the pass is the input of its first identity, or 0.  Of facts, those are tried that a scene without
    /// lamps lacks, and the sky.
    void check_needs(const std::string& fact)
    {
        static const Scene unlit = unlit_scene();
        static const Facts lacking = facts_of(unlit);
        const bool is_of_sky = fact == "sky";
        if (!is_of_sky && find_fact(fact)->get(lacking) != 0.0)
            return;
        for_each_setting([&](Stage& stage, const StageOptions& options) {
            Feed feed = feed_of(options, "");
            for (const InputPort& port : pass_.inputs)
                if (is_of_sky && port.over == Over::sphere)
                    std::fill(feed.at(port.name).texels.begin(), feed.at(port.name).texels.end(), 0.0f);
            const auto outputs = run_stage(subject_, stage, feed, &unlit, options);
            if (!outputs)
                return false;
            for (const auto& [name, picture] : *outputs)
                judge_needs(picture, fact, pass_.identities.empty() ? nullptr : &feed.at(pass_.identities.front().is), options);
            return true;
        });
    }

    void judge_needs(const Picture& out, const std::string& fact, const Picture* input, const StageOptions& options)
    {
        if (input && !(input->extent == out.extent))
            return; // a compiler does not take the one for the other then
        subject_.findings.count_run("needs");
        const auto channels = static_cast<size_t>(out.channels);
        for (size_t i = 0; i < out.texels.size(); ++i) {
            const float wanted = input ? input->texels[i / channels * static_cast<size_t>(input->channels) + i % channels] : 0.0f;
            if (out.texels[i] == wanted || i % channels == 3)
                continue;
            subject_.findings.add({"needs", to_text(options.settings), fmt::format("a scene without {}", fact), place_of(out, i),
                                   fmt::format("{:.9g}", out.texels[i]),
                                   input ? fmt::format("`{}` itself: {:.9g}", pass_.identities.front().is, wanted) : std::string("exactly 0"),
                                   "correct \"needs\", or the pass: a scene that lacks it does not draw it"});
            return;
        }
    }

    /// Where there is a surface, or none, the pass is the input it names, or 0. A depth of 0 is no surface.
    void check_only_where(const InputPort& depth)
    {
        for_each_setting([&](Stage& stage, const StageOptions& options) {
            Feed feed = feed_of(options, "");
            Picture& surfaces = feed.at(depth.name);
            for (size_t i = 0; i < surfaces.texels.size(); i += 2)
                surfaces.texels[i] = 0.0f;
            const auto outputs = draw(stage, feed, options);
            if (!outputs)
                return false;
            for (const auto& [name, picture] : *outputs)
                judge_only_where(picture, surfaces, pass_.elsewhere.empty() ? nullptr : &feed.at(pass_.elsewhere), options);
            return true;
        });
    }

    void judge_only_where(const Picture& out, const Picture& surfaces, const Picture* elsewhere, const StageOptions& options)
    {
        if (!(out.extent == surfaces.extent))
            return; // nothing is drawn in parts then
        subject_.findings.count_run("only_where");
        const auto channels = static_cast<size_t>(out.channels);
        for (size_t i = 0; i < out.texels.size(); ++i) {
            const size_t texel = i / channels;
            const bool is_surface = surfaces.texels[texel] > 0.0f;
            const bool does_nothing = is_surface == (pass_.only_where == OnlyWhere::no_depth);
            const float wanted = elsewhere ? elsewhere->texels[texel * static_cast<size_t>(elsewhere->channels) + i % channels] : 0.0f;
            if (!does_nothing || out.texels[i] == wanted)
                continue;
            subject_.findings.add({"only_where", to_text(options.settings), is_surface ? "a surface" : "no surface", place_of(out, i),
                                   fmt::format("{:.9g}", out.texels[i]),
                                   elsewhere ? fmt::format("`{}` itself: {:.9g}", pass_.elsewhere, wanted) : std::string("exactly 0"),
                                   "correct \"only_where\", or the pass: elsewhere a compiler does not draw it"});
            return;
        }
    }

    /// The pass's own condition as a pass of the same inputs.
    PassPtr condition_pass() const
    {
        PassDeclaration pass = pass_;
        pass.name = "passgraph_condition";
        OutputPort mask;
        mask.name = "mask";
        mask.signal = Signal::mask;
        mask.size_of = pass_.outputs.front().size_of;
        mask.scale = pass_.outputs.front().scale;
        mask.texels = pass_.outputs.front().texels;
        pass.outputs = {mask};
        pass.skip_when.clear();
        pass.identities.clear();
        pass.black.clear();
        pass.body.text += fmt::format("\n#line {0}\nfloat {1}(vec2 uv) {{ return ({2}\n#line {0}\n) ? 1.0 : 0.0; }}\n", pass_.skip_where.line,
                                      pass.name, pass_.skip_when);
        pass.body.globals.push_back(pass.name);
        return std::make_shared<const PassDeclaration>(std::move(pass));
    }

    /// Where the condition holds, the pass by itself is 0.
    void check_skip()
    {
        PassLibrary library = subject_.library;
        library.add(condition_pass());
        const Subject condition{library, library.find("passgraph_condition"), subject_.loader, subject_.findings};
        for_each_setting([&](Stage& stage, const StageOptions& options) {
            std::optional<Stage> asked = open_stage(condition, options);
            const Feed feed = feed_of(options, "");
            const auto outputs = draw(stage, feed, options);
            const auto holds = asked ? draw(*asked, feed, options) : std::nullopt;
            if (!outputs || !holds)
                return false;
            judge_black(outputs->begin()->second, options, "skip", "random values", "correct \"skip\", or the pass: where the condition holds nothing is drawn",
                        [&](size_t texel) { return holds->begin()->second.texels[texel] != 0.0f; });
            return true;
        });
    }

    static std::string fed(const std::string& black)
    {
        return black.empty() ? "random values" : fmt::format("random values, `{}` black", black);
    }

    const Subject& subject_;
    const PassDeclaration& pass_;
    std::mt19937 random_;
};

} // namespace

void check_omissions(const Subject& subject) { OmissionChecks(subject).run(); }

} // namespace passgraph::tool::contract
