// Graphs as JSON: the description a file holds, and the graph built from it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/graph.hpp>
#include <passgraph/core/json.hpp>

namespace passgraph {

/// A name in a file, with its place.
struct NamedPlace {
    std::string text;
    Location where;
};

/// What a graph file says, before names are resolved. A composite is one of these with ports.
struct GraphDescription {
    struct Input {
        std::string name;
        GraphNode::Kind kind = GraphNode::Kind::picture;
        Signal signal = Signal::radiance;
        Location where;
        bool is_optional = false; ///< of a composite: what reads it does without when it is not wired
    };
    struct Reference {
        std::string port; ///< of the reading pass
        NamedPlace image; ///< "lit", "lit.radiance", "scene.sky"
        Location where;   ///< of the port's name
    };
    struct Pass {
        std::string name;
        NamedPlace pass;
        std::vector<Reference> inputs;
        std::vector<PassArguments::Setting> settings; ///< params, choices and rungs
        std::vector<std::pair<std::string, Location>> statics;
        std::vector<PassArguments::Setting> codecs;
        std::optional<Ratio> scale;
        std::optional<NamedPlace> size_of;
        Location where;
    };
    struct Output {
        std::string name;
        NamedPlace image;
        Location where;
    };
    std::string file;
    std::string composite_name; ///< "pass": NAME, when the file is a composite
    std::string summary;
    std::string source;
    std::vector<Input> inputs;
    std::vector<Pass> passes;
    std::vector<GraphParam> params;
    std::vector<Output> outputs;
    std::optional<Json> contract{}; ///< of a composite, read once its ports are known
};

/// Reads the text of a graph file.
/// Errors   every mistake of form, located: json_*, unknown_field, wrong_type, field_missing, unknown_signal, duplicate_name.
Result<GraphDescription> read_graph_description(std::string_view text, const std::string& file);

/// Builds the graph: resolves names, sorts passes so that producers come first, expands composites.
///
/// Mistakes in names and values do not stop it: they are kept in the graph, and `compile` returns them with all others.
Graph build_graph(const GraphDescription& description, const PassLibrary& library);

/// Reads and builds. Errors: those of form; those of names come from `compile`.
Result<Graph> load_graph(const std::string& path, const PassLibrary& library);

/// A composite's declaration: its ports, and the parameters and selections it routes inwards.
/// Errors   unknown_pass, unknown_param, unknown_image, not_a_composite, cycle.
Result<PassPtr> declare_composite(std::shared_ptr<const GraphDescription> description, const std::string& family,
                                  const PassLibrary& library);

} // namespace passgraph
