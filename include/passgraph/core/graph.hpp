// Passes wired together, plus inputs and outputs. A graph only grows, holds no GL, and is checked when it is compiled.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <passgraph/core/declaration.hpp>
#include <passgraph/core/pass_library.hpp>
#include <passgraph/core/picture.hpp>

namespace passgraph {

/// One output of one node of a graph.
struct ImageRef {
    int node = -1;
    int output = 0;
    friend bool operator==(const ImageRef&, const ImageRef&) = default;
};

/// An image whose signal is known to the C++ compiler. There is no default: a forgotten wire does not compile.
template <class SignalTag>
class Image {
public:
    ImageRef ref() const { return ref_; }

private:
    friend class Graph;
    explicit Image(ImageRef ref) : ref_(ref) {}
    ImageRef ref_;
};

/// A cube map of a signal.
template <class SignalTag>
class Cube {
public:
    ImageRef ref() const { return ref_; }

private:
    friend class Graph;
    explicit Cube(ImageRef ref) : ref_(ref) {}
    ImageRef ref_;
};

/// An image whose signal is checked when the graph is compiled.
class AnyImage {
public:
    explicit AnyImage(ImageRef ref) : ref_(ref) {}
    template <class Tag>
    AnyImage(const Image<Tag>& image) : ref_(image.ref())
    {
    }
    template <class Tag>
    AnyImage(const Cube<Tag>& cube) : ref_(cube.ref())
    {
    }
    ImageRef ref() const { return ref_; }

private:
    ImageRef ref_;
};

/// The scene a graph draws: its elements and its sky.
struct SceneInput {
    AnyImage elements;
    Cube<Radiance> sky;
};

/// Where an input of a node comes from, and where the file says so.
struct Wire {
    ImageRef from;
    Location where;
};

struct GraphNode {
    enum class Kind { pass, picture, cube, scene };
    Kind kind = Kind::pass;
    std::string name;
    Signal signal = Signal::radiance; ///< of a picture or cube
    PassPtr pass;
    std::vector<std::optional<Wire>> inputs; ///< as pass->inputs
    std::vector<Value> params;               ///< as pass->params
    std::vector<bool> is_static;             ///< as pass->params
    std::vector<int> selections;             ///< as pass->selections
    std::vector<std::string> codecs;         ///< as pass->outputs; "": the default
    std::optional<Ratio> scale;
    std::optional<ImageRef> size_of;
    Location where;
    std::vector<std::string> public_places; ///< inside a composite, as pass->params: under whose name people set it

    /// The name people know a parameter by: "lit.environment", inside a composite its own, else "node.param".
    std::string place_of(size_t param) const;
};

/// The ports of a scene, by their output number: what it draws, the sky around it, and the textures of its surfaces.
enum class ScenePort : std::uint8_t { elements, sky, atlas_albedo, atlas_material, atlas_emissive };
inline constexpr int kScenePorts = 5;
/// "sky"; "" for the elements.
std::string_view name(ScenePort port);

/// "node.port", or "node" when it has one output: for messages and plans.
std::string image_name(const std::vector<GraphNode>& nodes, ImageRef image);

struct GraphOutput {
    std::string name;
    ImageRef from;
    Location where;
};

/// A public parameter of the graph: one name for one or several places inside.
struct GraphParam {
    std::string name;
    std::vector<std::string> places; ///< "node.param"
    Location where;
};

/// What a caller of the run-time `add` gives: everything by name. Unknown names are reported when compiling.
struct PassArguments {
    struct Setting {
        std::string name;
        std::vector<double> numbers; ///< of a parameter
        std::string item;            ///< of a selection or an enum
        Location where;
    };
    struct Input {
        std::string name;
        AnyImage image;
        Location where{};
    };
    std::string name; ///< of the node; "": the pass's own, numbered when taken
    std::vector<Input> inputs;
    std::vector<Setting> settings;                         ///< parameters, choices, rungs
    std::vector<std::pair<std::string, Location>> statics; ///< parameters to fold into the code
    std::vector<PassArguments::Setting> codecs;            ///< output -> codec (`item`)
    std::optional<Ratio> scale;
    std::optional<AnyImage> size_of;
    Location where;
};

/// What a node may say beside its parameters and wires.
struct NodeOptions {
    std::string name{};                                        ///< "": the pass's own, numbered when taken
    std::optional<Ratio> scale{};                              ///< of the largest input's extent
    std::optional<AnyImage> size_of{};                         ///< or the extent of this image
    std::vector<std::string> statics{};                        ///< parameters to fold into the code
    std::vector<std::pair<std::string, std::string>> codecs{}; ///< output -> codec
};

class Graph;

/// A node just added; its outputs by name.
class AddedPass {
public:
    /// The output called `output`; the only one when the name is empty. Unknown names are reported when compiling.
    AnyImage operator[](std::string_view output) const;

private:
    friend class Graph;
    AddedPass(Graph& graph, std::vector<std::pair<std::string, ImageRef>> outputs, std::string name)
        : graph_(&graph), outputs_(std::move(outputs)), name_(std::move(name))
    {
    }
    Graph* graph_;
    std::vector<std::pair<std::string, ImageRef>> outputs_;
    std::string name_;
};

/// The passes of the build's own `passes` folder.
const PassLibrary& builtin_passes();

class Graph {
public:
    explicit Graph(const PassLibrary& library = builtin_passes()) : library_(&library) {}

    /// The scene: elements for geometry passes, the sky as a cube map.
    SceneInput scene(std::string name = "scene", Location where = {});
    /// A picture the host supplies for each frame or once.
    template <class Tag>
    Image<Tag> picture(std::string name)
    {
        return Image<Tag>(picture(std::move(name), Tag::signal).ref());
    }
    AnyImage picture(std::string name, Signal signal, Location where = {});
    AnyImage cube(std::string name, Signal signal, Location where = {});

    /// Adds a pass by name. Mistakes are kept and come back from `compile`, all at once.
    AddedPass add(std::string_view pass, PassArguments arguments);

    /// Adds a pass by its generated type: a wrong or forgotten wire does not compile.
    template <class Pass>
    typename Pass::Outputs add(const Pass& pass, const typename Pass::Inputs& inputs, NodeOptions options = {})
    {
        PassArguments arguments = pass.arguments();
        inputs.append_to(arguments);
        arguments.name = std::move(options.name);
        arguments.scale = options.scale;
        arguments.size_of = options.size_of;
        for (std::string& name : options.statics)
            arguments.statics.emplace_back(std::move(name), Location{});
        for (auto& [output, codec] : options.codecs)
            arguments.codecs.push_back({std::move(output), {}, std::move(codec), {}});
        return Pass::Outputs::from(add(Pass::name, std::move(arguments)));
    }

    /// Names an image as a result.
    void output(std::string name, AnyImage image, Location where = {});
    /// Makes inner settings settable under one name of the graph's own.
    void param(GraphParam param) { params_.push_back(std::move(param)); }

    /// For generated code: an untyped image that is known to have the tag's signal.
    template <class Tag>
    static Image<Tag> typed(AnyImage image)
    {
        return Image<Tag>(image.ref());
    }

    void report(Error error) { errors_.push_back(std::move(error)); }

    const PassLibrary& library() const { return *library_; }
    const std::vector<GraphNode>& nodes() const { return nodes_; }
    const std::vector<GraphOutput>& outputs() const { return outputs_; }
    const std::vector<GraphParam>& params() const { return params_; }
    const Errors& errors() const { return errors_; }

    int find_node(std::string_view name) const; ///< index or -1
    /// The image called NODE, NODE.PORT or INPUT; nullopt when there is none. `why` then says what is wrong.
    std::optional<ImageRef> find_image(std::string_view name, Error* why = nullptr) const;
    std::string image_name(ImageRef image) const { return passgraph::image_name(nodes_, image); }

    /// The settings of plain passes ("node.name") that a name stands for: one of the graph's own params, one of a composite's,
    /// or the name itself. Empty when there is none.
    std::vector<std::string> places_of(std::string_view name) const;
    /// Sets a parameter, choice or rung: "node.name" (split at the last dot) or one of the graph's own params.
    /// Errors   unknown_image, unknown_param, wrong_type, param_out_of_range, unknown_item.
    Result<void> set(std::string_view place, const PassArguments::Setting& setting);
    /// Stores an output of a node with another codec. Errors: unknown_image, unknown_codec.
    Result<void> set_codec(std::string_view image, std::string_view codec);

private:
    AddedPass add_composite(const PassPtr& pass, PassArguments arguments);
    AddedPass add_plain(const PassPtr& pass, PassArguments arguments);
    std::string free_name(std::string wanted, const Location& where, bool is_chosen);

    const PassLibrary* library_;
    std::vector<GraphNode> nodes_;
    std::vector<GraphOutput> outputs_;
    std::vector<GraphParam> params_;
    std::vector<std::pair<std::string, std::vector<std::pair<std::string, ImageRef>>>> composites_;
    Errors errors_;
};

} // namespace passgraph
