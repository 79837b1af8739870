// What this scene and these parameters make superfluous: passes that are their input, images that are black, inputs that
// make no difference.
//
// One forward sweep, producers first, carries an upper bound of every image's components: what is bounded to 0 is black, for
// no signal that has bounds is ever negative. A wire from a black image becomes the constant 0, and a wire from a pass that
// is its input leads to that input; what nothing reads any more is left to cull.  O(passes + wires).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

constexpr double kEndless = Facts::kUnknown;

/// Light, reflectance and coverage are never negative: the largest of their values says whether there is any.
bool is_bounded_below(Signal signal) { return domain_of(signal).lowest == 0.0; }

class Specialisation {
public:
    Specialisation(const TypedGraph& graph, const CompileOptions& options) : graph_(graph), options_(options) { result_.graph = graph; }

    Specialised run()
    {
        for (int index = 0; index < graph_.node_count(); ++index) {
            node_ = index;
            moved_.emplace_back(graph_.images[static_cast<size_t>(index)].size());
            bounds_.emplace_back(graph_.images[static_cast<size_t>(index)].size(), kEndless);
            if (!graph_.is_pass(index))
                bound_source();
            else
                visit_pass();
        }
        for (GraphOutput& output : result_.graph.outputs)
            if (const ImageRef source = source_of(output.from); may_stand_for(source, output.from))
                output.from = source;
        return std::move(result_);
    }

private:
    GraphNode& node() { return result_.graph.nodes[static_cast<size_t>(node_)]; }
    double& bound_of(int output) { return bounds_.back()[static_cast<size_t>(output)]; }
    double bound_of(ImageRef image) const { return bounds_[static_cast<size_t>(image.node)][static_cast<size_t>(image.output)]; }

    /// The image that an image is, through passes that are their input.
    ImageRef source_of(ImageRef image) const
    {
        const auto& moved = moved_[static_cast<size_t>(image.node)][static_cast<size_t>(image.output)];
        return moved.value_or(image);
    }

    /// An output is stored as it says, and what the host supplied is stored nowhere.
    bool may_stand_for(ImageRef source, ImageRef image) const
    {
        const auto codec = [&](ImageRef of) { return graph_.node(of.node).codecs[static_cast<size_t>(of.output)]; };
        return graph_.is_pass(source.node) && graph_.is_pass(image.node) && codec(source) == codec(image);
    }

    void bound_source()
    {
        const GraphNode& source = graph_.node(node_);
        for (int output = 0; output < static_cast<int>(bounds_.back().size()); ++output)
            bound_of(output) = domain_of(graph_.image({node_, output}).signal).highest;
        if (source.kind != GraphNode::Kind::scene)
            return;
        bound_of(static_cast<int>(ScenePort::sky)) = std::min(options_.facts.sky, bound_of(static_cast<int>(ScenePort::sky)));
        bound_of(static_cast<int>(ScenePort::atlas_emissive)) =
            std::min(options_.facts.emission, bound_of(static_cast<int>(ScenePort::atlas_emissive)));
    }

    void visit_pass()
    {
        for (size_t port = 0; port < node().inputs.size(); ++port)
            if (auto& wire = node().inputs[port])
                wire->from = source_of(wire->from);
        for (size_t port = 0; port < node().inputs.size(); ++port)
            drop_what_makes_no_difference(port);
        if (!becomes_its_input())
            bound_outputs();
    }

    void drop_what_makes_no_difference(size_t port)
    {
        const InputPort& input = node().pass->inputs[port];
        auto& wire = node().inputs[port];
        if (!wire || input.over == Over::scene)
            return;
        if (input.ignored_when && holds(*input.ignored_when)) {
            fix_parameters_of(*input.ignored_when);
            make_black(port, fmt::format("not read: {}", input.ignored_when->text()));
        } else if (bound_of(wire->from) == 0.0) {
            make_black(port, fmt::format("{} is black", graph_.name(wire->from)));
        }
    }

    void make_black(size_t port, std::string reason)
    {
        auto& wire = node().inputs[port];
        const Extent extent = graph_.image(wire->from).extent; // a table's is known when it is bound
        result_.black_inputs[{node_, static_cast<int>(port)}] = extent.width > 0 ? extent : Extent{1, 1};
        result_.decisions.push_back({fmt::format("{}.{}", node().name, node().pass->inputs[port].name), std::move(reason)});
        wire.reset();
    }

    /// A pass whose needs are not met, or whose identity holds, is its input; without one, black.
    bool becomes_its_input()
    {
        const PassDeclaration& pass = *node().pass;
        std::string reason;
        const Identity* identity = nullptr;
        for (const Identity& candidate : pass.identities)
            if (identity == nullptr && holds(candidate.when)) {
                identity = &candidate;
                reason = candidate.when.text();
            }
        for (const std::string& fact : pass.needs)
            if (find_fact(fact)->get(options_.facts) == 0.0) {
                reason = fmt::format("the scene has no {}", fact);
                identity = identity != nullptr || pass.identities.empty() ? identity : &pass.identities.front();
                if (identity == nullptr) {
                    result_.decisions.push_back({node().name, reason + ": black"});
                    for (int output = 0; output < static_cast<int>(bounds_.back().size()); ++output)
                        bound_of(output) = 0.0;
                    return true;
                }
            }
        return identity != nullptr && becomes(*identity, reason);
    }

    bool becomes(const Identity& identity, const std::string& reason)
    {
        const auto port = static_cast<size_t>(node().pass->find_input(identity.is));
        const auto black = result_.black_inputs.find({node_, static_cast<int>(port)});
        const TypedImage& own = graph_.image({node_, 0});
        const bool is_constant = !node().inputs[port];
        if (is_constant && black == result_.black_inputs.end())
            return false; // an input that nobody wired: its default is a constant of this pass
        if (!(is_constant ? black->second == own.extent : same_image(node().inputs[port]->from, own)))
            return false;
        // Somebody wants it rounded otherwise; what the host supplied is rounded nowhere.
        const auto codec = [&](ImageRef of) { return graph_.node(of.node).codecs[static_cast<size_t>(of.output)]; };
        const bool is_stored_alike = is_constant || !graph_.is_pass(node().inputs[port]->from.node)
                                         ? node().codecs.front().empty()
                                         : codec(node().inputs[port]->from) == node().codecs.front();
        if (!is_stored_alike)
            return false;
        result_.decisions.push_back({node().name, fmt::format("it is its `{}`: {}", identity.is, reason)});
        bound_of(0) = is_constant ? 0.0 : bound_of(node().inputs[port]->from);
        if (!is_constant)
            moved_.back().front() = node().inputs[port]->from;
        return true;
    }

    bool same_image(ImageRef image, const TypedImage& other) const
    {
        return graph_.image(image).extent == other.extent && graph_.image(image).signal == other.signal;
    }

    void bound_outputs()
    {
        const PassDeclaration& pass = *node().pass;
        for (size_t output = 0; output < pass.outputs.size(); ++output) {
            const Signal signal = graph_.image({node_, static_cast<int>(output)}).signal;
            if (!is_bounded_below(signal) || info(signal).has_alpha)
                continue;
            double bound = domain_of(signal).highest;
            if (const auto& formula = pass.outputs[output].bound)
                if (const double stated = formula->value(lookup()); !std::isnan(stated))
                    bound = std::clamp(stated, 0.0, bound);
            if (is_black(pass, output) || (options_.skipping == Skipping::always && !pass.skip_when.empty()))
                bound = 0.0;
            if (bound == 0.0)
                result_.decisions.push_back({graph_.name({node_, static_cast<int>(output)}), "black"});
            bound_of(static_cast<int>(output)) = bound;
        }
    }

    /// Every input that makes the output black by being black is.
    bool is_black(const PassDeclaration& pass, size_t output)
    {
        const std::vector<int>& inputs = pass.black_inputs(static_cast<int>(output));
        return !inputs.empty() && std::all_of(inputs.begin(), inputs.end(), [&](int input) { return input_bound(static_cast<size_t>(input)) == 0.0; });
    }

    bool holds(const Formula& condition) { return condition.value(lookup()) != 0.0; }

    double input_bound(size_t port)
    {
        const InputPort& input = node().pass->inputs[port];
        if (const auto& wire = node().inputs[port])
            return is_bounded_below(graph_.image(wire->from).signal) ? bound_of(wire->from) : kEndless;
        if (result_.black_inputs.contains({node_, static_cast<int>(port)}))
            return 0.0;
        return *std::max_element(input.default_value.v.begin(), input.default_value.v.end());
    }

    /// The input of which `name`, IMAGE_behind, means the pixels that no surface covers; -1: none.
    int input_behind(std::string_view name)
    {
        return name.ends_with(kBehind) ? node().pass->find_input(name.substr(0, name.size() - kBehind.size())) : -1;
    }

    /// The input is 0 where the one geometry that this pass knows of covers nothing.
    bool is_dark_behind(size_t port)
    {
        const auto& wire = node().inputs[port];
        if (!wire)
            return input_bound(port) == 0.0;
        return graph_.is_pass(wire->from.node) && graph_.node(wire->from.node).pass->only_where == OnlyWhere::depth &&
               geometry_of(graph_, node_).size() == 1;
    }

    Formula::Lookup lookup()
    {
        return [this](std::string_view name) -> std::optional<Formula::Number> {
            if (const auto setting = find_setting(*node().pass, node().params, node().selections, name))
                return setting;
            if (const int port = node().pass->find_input(name); port >= 0)
                return Formula::Number{{input_bound(static_cast<size_t>(port))}, 1};
            if (const int port = input_behind(name); port >= 0)
                return Formula::Number{{is_dark_behind(static_cast<size_t>(port)) ? 0.0 : kEndless}, 1};
            if (const FactRow* fact = find_fact(name))
                return Formula::Number{{fact->get(options_.facts)}, 1};
            return std::nullopt;
        };
    }

    /// What was decided by their values can no longer follow a change of them.
    void fix_parameters_of(const Formula& condition)
    {
        for (size_t param = 0; param < node().pass->params.size(); ++param)
            if (condition.uses(node().pass->params[param].name))
                node().is_static[param] = true;
    }

    const TypedGraph& graph_; ///< as it came, for names, extents and signals
    const CompileOptions& options_;
    Specialised result_;
    int node_ = 0;
    std::vector<std::vector<std::optional<ImageRef>>> moved_; ///< by node and output: the image that it is
    std::vector<std::vector<double>> bounds_;                 ///< by node and output: no component is larger
};

} // namespace

Specialised specialise(const TypedGraph& graph, const CompileOptions& options)
{
    // Without guards a value may leave its signal's domain, and no bound holds.
    if (!options.specialise || !options.guards)
        return {graph, {}, {}};
    return Specialisation(graph, options).run();
}

} // namespace passgraph::compiler
