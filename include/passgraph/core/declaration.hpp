// What a pass file says about itself, plus what analysis derived from its body.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/codec.hpp>
#include <passgraph/core/contract.hpp>
#include <passgraph/core/error.hpp>
#include <passgraph/core/formula.hpp>
#include <passgraph/core/signal.hpp>

namespace passgraph {

struct GraphDescription;

/// A parameter's value: up to four numbers, each exact in a double. Booleans are 0 or 1, enums the item's index.
struct Value {
    std::array<double, 4> v{};

    Value() = default;
    Value(double x) : v{x} {}
    Value(double x, double y, double z = 0.0, double w = 0.0) : v{x, y, z, w} {}
    friend bool operator==(const Value&, const Value&) = default;
};

using Vec2 = std::array<float, 2>;
using Vec3 = std::array<float, 3>;
using Vec4 = std::array<float, 4>;

enum class ParamType : std::uint8_t { float_, int_, bool_, enum_, color, vec2, vec3, vec4 };
std::string_view name(ParamType type);
int component_count(ParamType type);

/// A knob of a pass. Live parameters are uniforms; static ones are compile-time constants.
struct Param {
    std::string name;
    ParamType type = ParamType::float_;
    Value default_value;
    double lowest = -std::numeric_limits<double>::infinity(); ///< per component
    double highest = std::numeric_limits<double>::infinity();
    double step = 0.0; ///< 0: continuous
    std::string unit;
    std::string label;
    std::string group;
    std::optional<Formula> visible_if;
    bool is_logarithmic = false;
    bool is_static = false;
    std::vector<std::string> items; ///< of an enum
    Location where;
};

/// A static selection: a choice between models, or a ladder of approximations of one reference (rungs in its order).
struct Selection {
    enum class Kind : std::uint8_t { choice, ladder, layout };
    std::string name;
    Kind kind = Kind::choice;
    std::vector<std::string> items;
    int default_item = 0;
    std::string reference{}; ///< of a ladder: the exact computation its rungs approximate, by name; "": none is named
    Location where;
};

enum class Filter : std::uint8_t { nearest, linear };
enum class AddressMode : std::uint8_t { clamp, mirror, repeat };
/// What an input is a function of: a place in the picture, a direction (cube map) or a place in a table, which has an
/// extent of its own and is never fused; or the scene a geometry pass draws.
enum class Over : std::uint8_t { image, sphere, table, scene };

/// How a pass reads an input, derived from its syntax tree; the compiler trusts nothing else.
enum class AccessClass : std::uint8_t {
    size_only, ///< only its extent is asked for
    pointwise, ///< at the entry's own uv, unmodified, on every path
    warp,      ///< at one computed place
    gather,    ///< at several places; `radius` texels around uv, or unknown
};

struct Access {
    AccessClass kind = AccessClass::gather;
    int radius = kUnknownRadius; ///< texels, of a gather
    static constexpr int kUnknownRadius = -1;
    friend bool operator==(const Access&, const Access&) = default;
};

/// "pointwise", "warp", "gather(4)", "gather(radius unknown)".
std::string to_text(const Access& access);

struct InputPort {
    std::string name;
    Signal signal = Signal::color;
    Filter filter = Filter::nearest;
    std::string filter_by{}; ///< a selection whose items choose the filter; "": none
    std::vector<std::pair<std::string, Filter>> filter_of_item{}; ///< those that differ from `filter`
    Location filter_where{};
    AddressMode wrap = AddressMode::clamp;
    Over over = Over::image;
    bool has_levels = false;
    bool is_optional = false;
    bool is_visited_once = false; ///< each texel is looked at about once in all: computing it there costs no more than storing it
    Value default_value{}; ///< of an optional input that is not wired
    Access access{};       ///< derived
    std::optional<Formula> ignored_when{}; ///< then what is wired makes no difference
    Location where{};
};

struct Ratio {
    int p = 1;
    int q = 1;
    friend bool operator==(const Ratio&, const Ratio&) = default;
};

struct OutputPort {
    std::string name;
    Signal signal = Signal::color;
    std::string size_of;                      ///< an input whose extent is taken; "": the largest input
    Ratio scale;                              ///< of that extent
    std::optional<std::array<int, 2>> texels; ///< or a fixed extent
    std::optional<Formula> bound{}; ///< no component is larger; of inputs' bounds, parameters and facts
    Location where;
};

enum class PassKind : std::uint8_t { image, geometry };

/// Where in the picture a pass does anything: at pixels that geometry covers (its outputs are 0 elsewhere), or at those
/// it does not cover (elsewhere the pass is one of its inputs).
enum class OnlyWhere : std::uint8_t { everywhere, depth, no_depth };

/// What the frame offers a pass, beside its inputs.
struct Reads {
    bool camera = false;
    bool lights = false;
    bool frame = false;
    bool elements = false;
    bool materials = false;
    friend bool operator==(const Reads&, const Reads&) = default;
};
struct ReadRow {
    std::string_view name;
    bool Reads::*member;
};
inline constexpr std::array<ReadRow, 5> kReads = {{{"camera", &Reads::camera},
                                                   {"lights", &Reads::lights},
                                                   {"frame", &Reads::frame},
                                                   {"elements", &Reads::elements},
                                                   {"materials", &Reads::materials}}};

/// When a pass is one of its inputs, by parameters and by the inputs' largest components: `bloom == 0` is "bloom is black".
struct Identity {
    Formula when;
    std::string is; ///< the input
};

/// One layout of a geometry pass: what it draws into, and where each output stands there or what it is computed from.
struct Layout {
    struct Target {
        std::string name;
        Format format = Format::rgba8;
    };
    /// Channels of a target: "rg", "a".
    struct Place {
        int target = 0;
        std::string channels;
    };
    struct Output {
        std::string output;
        Codec codec{};               ///< how its codes are made
        std::vector<Place> places{}; ///< where they stand, in the order of the codes; empty when derived
        std::string derived_from{};  ///< or the pass that computes it from other outputs and the scene
        Location where{};
    };
    std::string name;
    std::vector<Target> targets; ///< in the order of the outputs that stand there
    std::vector<Output> outputs;

    const Output* find(std::string_view wanted) const;
};

/// GLSL text with the names it puts at global scope, so that each use can be renamed.
struct GlslText {
    std::string file; ///< for messages
    int first_line = 1;
    std::string text;                 ///< without `#include` lines (they are blank)
    std::vector<std::string> globals; ///< functions, constants, structs
    std::vector<std::string> macros;  ///< #define'd in the text
    std::vector<std::shared_ptr<const GlslText>> includes;
};

/// A pass: the header's content, the body, and what was derived from it.
struct PassDeclaration {
    std::string name;
    std::string family; ///< the folder it stands in
    std::string summary;
    std::string source; ///< where the idea comes from
    std::string file;
    PassKind kind = PassKind::image;
    std::vector<InputPort> inputs;
    std::vector<OutputPort> outputs;
    std::vector<Param> params;
    std::vector<Selection> selections;
    std::vector<Layout> layouts; ///< of a geometry pass; selected by the selection "layout"
    Reads reads;
    std::vector<Identity> identities;
    std::vector<std::string> needs; ///< facts of the scene that the pass is for: without one of them it is its input, or black
    OnlyWhere only_where = OnlyWhere::everywhere;
    std::string elsewhere; ///< the input that the pass is where only_where does not hold; "": its outputs are 0 there
    /// By output: the inputs that make it exactly 0 everywhere when all of them are; none: nothing does.
    std::vector<std::vector<int>> black;
    std::string skip_when; ///< a GLSL condition in the body's scope: where it holds the only output is exactly 0; or ""
    Location skip_where;   ///< of that condition
    Contract contract;
    GlslText body;
    std::shared_ptr<const GraphDescription> composite; ///< set when the pass is a graph file with ports

    int find_input(std::string_view wanted) const; ///< index or -1
    int find_output(std::string_view wanted) const;
    int find_param(std::string_view wanted) const;
    int find_selection(std::string_view wanted) const;
    /// The inputs that make an output black when all of them are; empty: nothing does.
    const std::vector<int>& black_inputs(int output) const;
};

/// "a.rg : octahedral_rg16", "from position_from_depth": where an output stands, as a header says it.
std::string to_text(const Layout& layout, const Layout::Output& output);
/// The filter of a port under these items of the pass's selections.
Filter filter_of(const PassDeclaration& pass, const InputPort& port, const std::vector<int>& selections);

/// IMAGE_behind in formulas: the input IMAGE where no surface is.
inline constexpr std::string_view kBehind = "_behind";

/// The parameters, selections and items (`taps_9`) of a pass under these settings, for formulas.
std::optional<Formula::Number> find_setting(const PassDeclaration& pass, const std::vector<Value>& params,
                                            const std::vector<int>& selections, std::string_view name);
/// The names that `find_setting` knows, for messages.
std::vector<std::string> formula_names(const PassDeclaration& pass);

using PassPtr = std::shared_ptr<const PassDeclaration>;

} // namespace passgraph
