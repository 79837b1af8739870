// The laws a contract may state, each checked as core/contract.hpp words it.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tool/contract/judge.hpp"
#include "tool/contract/scenes.hpp"
#include "tool/contract/suite.hpp"
#include "tool/contract/values.hpp"

namespace passgraph::tool::contract {
namespace {

enum class Axis { horizontal, vertical };

Picture mirrored(const Picture& picture, Axis axis)
{
    Picture result = picture;
    const auto [width, height] = picture.extent;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < picture.channels; ++c)
                result.at(x, y, c) = axis == Axis::horizontal ? picture.at(width - 1 - x, y, c) : picture.at(x, height - 1 - y, c);
    return result;
}

class LawChecks {
public:
    LawChecks(const Subject& subject, StageOptions options, Stage& stage)
        : subject_(subject), options_(std::move(options)), stage_(stage), random_(93)
    {
    }

    void run(Law law)
    {
        law_ = law;
        switch (law) {
        case Law::constant: return check_constant();
        case Law::black: return check_black();
        case Law::energy: return check_energy();
        case Law::monotone: return check_monotone();
        case Law::mirror: return check_mirror();
        case Law::scale: return check_scale();
        }
    }

private:
    Signal signal(Signal declared) const { return signal_of(declared, options_); }
    bool is_light_port(const InputPort& port) const { return port.over != Over::scene && is_light(port.signal); }

    /// Light bright enough to matter, dark enough that doubling it stays in the domain.
    double most_light(const InputPort& port) const
    {
        const Contract::Span span = span_of(subject_.contract().domain, port.name, signal(port.signal));
        return std::min(span.highest, 1000.0) / 2.0;
    }

    Feed random_feed()
    {
        Feed feed;
        for (const InputPort& port : subject_.pass->inputs) {
            if (port.over == Over::scene)
                continue;
            const Signal fed = signal(port.signal);
            const Extent extent = extent_of(port, options_);
            feed[port.name] = is_light_port(port) ? light(extent, info(fed).components, most_light(port), random_)
                                                  : picture_of(Filling::random, fed, span_of(subject_.contract().domain, port.name, fed), extent, random_);
        }
        return feed;
    }

    std::optional<Outputs> draw(const Feed& feed)
    {
        static const Scene scene = unlit_scene();
        const PassDeclaration& pass = *subject_.pass;
        const bool needs_scene = pass.composite || pass.reads.lights || pass.reads.camera;
        return run_stage(subject_, stage_, feed, needs_scene ? &scene : nullptr, options_);
    }

    /// `is_right(output, x, y, c, value)`; `expected` says what it should have been.
    template <class IsRight, class Expected>
    void judge(const Outputs& outputs, const std::string& fed, const IsRight& is_right, const Expected& expected, const std::string& hint)
    {
        const std::string check = fmt::format("law_{}", name(law_));
        subject_.findings.count_run(check);
        for (const OutputPort& port : subject_.pass->outputs) {
            if (law_ != Law::mirror && !is_light(port.signal))
                continue;
            const Picture& picture = outputs.at(port.name);
            for (int y = 0; y < picture.extent.height; ++y)
                for (int x = 0; x < picture.extent.width; ++x)
                    for (int c = 0; c < picture.channels; ++c) {
                        const float value = picture.at(x, y, c);
                        if (is_right(port.name, x, y, c, value))
                            continue;
                        subject_.findings.add({check, to_text(options_.settings), fed,
                                               fmt::format("`{}` at ({}, {}) of {}x{}, channel {}", port.name, x, y, picture.extent.width,
                                                           picture.extent.height, c),
                                               fmt::format("{:.9g}", value), expected(port.name, x, y, c), hint});
                        return;
                    }
        }
    }

    static bool is_close(float value, double wanted, double size) { return std::abs(static_cast<double>(value) - wanted) <= kRounding * size; }

    void check_constant()
    {
        for (const double share : {0.25, 1.0}) {
            Feed feed = random_feed();
            float level = 1.0f;
            for (const InputPort& port : subject_.pass->inputs)
                if (is_light_port(port)) {
                    level = static_cast<float>(share * std::min(most_light(port), 2.0));
                    std::fill(feed.at(port.name).texels.begin(), feed.at(port.name).texels.end(), level);
                }
            if (const auto outputs = draw(feed))
                judge(*outputs, fmt::format("{} everywhere", level),
                      [&](auto&&, int, int, int, float value) { return is_close(value, level, level); },
                      [&](auto&&, int, int, int) { return fmt::format("{}", level); },
                      "weights must sum to 1: is the middle one counted twice, or the sum not divided by?");
        }
    }

    void check_black()
    {
        Feed feed = random_feed();
        for (const InputPort& port : subject_.pass->inputs)
            if (is_light_port(port))
                std::fill(feed.at(port.name).texels.begin(), feed.at(port.name).texels.end(), 0.0f);
        if (const auto outputs = draw(feed))
            judge(*outputs, "no light",
                  [](auto&&, int, int, int c, float value) { return value == 0.0f || c == 3; }, // alpha is no light
                  [](auto&&, int, int, int) { return std::string("exactly 0"); }, "a compiler may leave out what black makes black");
    }

    void check_energy()
    {
        for (const InputPort& lit : subject_.pass->inputs) {
            if (!is_light_port(lit))
                continue;
            for (const bool is_even : {true, false}) {
                Feed feed = random_feed();
                const float level = static_cast<float>(std::min(most_light(lit), 1.0));
                for (const InputPort& port : subject_.pass->inputs)
                    if (is_light_port(port))
                        for (float& value : feed.at(port.name).texels)
                            value = port.name != lit.name ? 0.0f : is_even ? level : std::min(value, level);
                if (const auto outputs = draw(feed))
                    judge(*outputs, fmt::format("light of at most {} in `{}`, no other", level, lit.name),
                          [&](auto&&, int, int, int, float value) { return static_cast<double>(value) <= level * (1.0 + kRounding); },
                          [&](auto&&, int, int, int) { return fmt::format("at most {}", level); }, "more leaves than came: is a factor of pi or 4 misplaced?");
            }
        }
    }

    void check_monotone()
    {
        for (const InputPort& brighter : subject_.pass->inputs) {
            if (!is_light_port(brighter))
                continue;
            const Feed dark = random_feed();
            const auto before = draw(dark);
            Feed bright = dark;
            for (float& value : bright.at(brighter.name).texels)
                if (random_() % 2 == 0)
                    value *= 1.0f + static_cast<float>(random_() % 100) / 50.0f;
            for (float& value : bright.at(brighter.name).texels)
                value = std::min(value, static_cast<float>(2.0 * most_light(brighter)));
            const auto after = draw(bright);
            if (before && after)
                judge(*after, fmt::format("`{}` brighter in half of its values", brighter.name),
                      [&](const std::string& port, int x, int y, int c, float value) {
                          const auto least = static_cast<double>(before->at(port).at(x, y, c));
                          return static_cast<double>(value) >= least - kRounding * std::abs(least);
                      },
                      [&](const std::string& port, int x, int y, int c) { return fmt::format("no less than {:.9g}", before->at(port).at(x, y, c)); },
                      "more light in must not make less come out");
        }
    }

    void check_mirror()
    {
        for (const Axis axis : {Axis::horizontal, Axis::vertical}) {
            const Feed plain = random_feed();
            Feed turned;
            for (const auto& [port, picture] : plain) {
                const auto declared = static_cast<size_t>(subject_.pass->find_input(port));
                const auto& tables = subject_.contract().anywhere; // what is looked up has no left and right of the picture's
                const bool is_picture = subject_.pass->inputs[declared].over == Over::image &&
                                        std::find(tables.begin(), tables.end(), port) == tables.end();
                turned[port] = is_picture ? mirrored(picture, axis) : picture;
            }
            const auto before = draw(plain);
            const auto after = draw(turned);
            if (!before || !after)
                return;
            Outputs wanted;
            std::map<std::string, double> sizes;
            for (const auto& [port, picture] : *before) {
                wanted[port] = mirrored(picture, axis);
                for (const float value : picture.texels)
                    sizes[port] = std::max(sizes[port], static_cast<double>(std::abs(value)));
            }
            judge(*after, axis == Axis::horizontal ? "inputs turned left to right" : "inputs turned upside down",
                  [&](const std::string& port, int x, int y, int c, float value) {
                      return is_close(value, static_cast<double>(wanted.at(port).at(x, y, c)), sizes.at(port));
                  },
                  [&](const std::string& port, int x, int y, int c) { return fmt::format("{:.9g}", wanted.at(port).at(x, y, c)); },
                  "left and right, or up and down, are treated differently: is an offset's sign wrong?");
        }
    }

    void check_scale()
    {
        const Feed plain = random_feed();
        Feed twice = plain;
        for (const InputPort& port : subject_.pass->inputs)
            if (is_light_port(port))
                for (float& value : twice.at(port.name).texels)
                    value *= 2.0f;
        const auto before = draw(plain);
        const auto after = draw(twice);
        if (before && after)
            judge(*after, "every light twice as bright",
                  [&](const std::string& port, int x, int y, int c, float value) { return value == 2.0f * before->at(port).at(x, y, c); },
                  [&](const std::string& port, int x, int y, int c) { return fmt::format("exactly {:.9g}", 2.0f * before->at(port).at(x, y, c)); },
                  "a constant is added, or a power taken, on the way");
    }

    const Subject& subject_;
    StageOptions options_;
    Stage& stage_;
    std::mt19937 random_;
    Law law_ = Law::constant;
};

} // namespace

void check_laws(const Subject& subject)
{
    for (const Signal generic : generic_signals(*subject.pass))
        for (const Settings& settings : selection_variants(*subject.pass)) {
            const StageOptions options{.settings = settings, .generic = generic};
            std::optional<Stage> stage = subject.contract().laws.empty() ? std::nullopt : open_stage(subject, options);
            for (const Law law : subject.contract().laws)
                if (stage)
                    LawChecks(subject, options, *stage).run(law);
        }
}

} // namespace passgraph::tool::contract
