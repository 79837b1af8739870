// Complete GLSL programs from passes: each pass's names renamed for its place in the step.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "passgraph/core/codec.hpp"
#include "passgraph/core/declaration.hpp"
#include "passgraph/core/glsl_interface.hpp"
#include "passgraph/core/picture.hpp"

namespace passgraph::glsl {

/// Where a pass's input gets its values in this step.
struct InputSource {
    enum class Kind { value, call, texture, cube, constant, black };
    Kind kind = Kind::constant; ///< constant: the port's default; call: computed where it is looked at
    /// A sampler, and the channels in which it holds codes of the image.
    struct Piece {
        std::string sampler;
        std::string channels;
    };
    std::string name;                 ///< value: the file-scope variable; call: the function
    Filter filter = Filter::nearest;  ///< call
    std::vector<Piece> pieces;        ///< texture, cube: in the order of the codes
    Signal signal = Signal::radiance; ///< as wired
    Codec codec;                      ///< texture
    Extent extent;
    bool is_import = false; ///< guarded where read
    bool is_loaded = false; ///< texture, of a pass that `looks_at_texels`: the texel `passgraph_texel` is loaded
    bool is_tested_depth = false; ///< 0 in the background part
    bool is_black_when_skipped = false; ///< 0 in the variant for that
};

/// One pass of a step. `number` makes its names unique: functions pN_name, values vN_output.
struct Instance {
    const PassDeclaration* pass = nullptr;
    int number = 0;
    std::vector<InputSource> inputs; ///< as pass->inputs
    std::vector<Signal> signals;     ///< as pass->outputs, generic resolved
    std::vector<Value> params;       ///< as pass->params
    std::vector<bool> is_static;     ///< as pass->params
    std::vector<int> selections;     ///< as pass->selections
    bool is_black = false;           ///< its only output is taken to be 0
    bool is_called = false;          ///< computed where other passes look, by the function `called_name`
    bool looks_at_texels = false;    ///< at centers only, not at the draw's own pixel: sets `passgraph_texel` first
    bool may_skip = true;            ///< its only output is 0 where its "skip" says so
};

/// Codes of one value that stand in a target.
struct StoredValue {
    std::string value; ///< file-scope variable
    Signal signal = Signal::radiance;
    Codec codec;
    std::string channels; ///< of the target
    size_t first_code = 0;
};

struct SamplerDeclaration {
    std::string name;
    bool is_cube = false;
    std::string loaded_format{}; ///< of an image that texels are loaded from; "": it is a sampler
};

struct StepSource {
    std::vector<Instance> instances;
    std::vector<SamplerDeclaration> samplers;
    std::vector<std::vector<StoredValue>> targets; ///< by location: everything that stands there
    Reads reads;
    PassKind kind = PassKind::image;
    Extent extent; ///< of what is drawn
    int varying_components = 60; ///< that the device has
    bool has_background = false; ///< in two parts: where there are surfaces, and where there are none
    bool discards_black = false; ///< pixels whose stored values all are 0 are not drawn
    bool has_skipped_variant = false; ///< a second text for which inputs are black that may be
    Facts facts; ///< of the scenes that the program is for
    bool has_guards = true; ///< values are brought into their signal's domain
};

struct StepText {
    std::string vertex;
    std::string fragment;
    std::string background;           ///< the fragment stage where there is no surface; "" for draws of one part, or where that is black
    std::string when_skipped;         ///< the fragment stage for which inputs are black that may be; "" without such
    std::string scout;                ///< the fragment stage of another source, with the vertex stage of this one; "" without such
    std::vector<std::string> sources; ///< by #line source number
};

std::string value_name(const Instance& instance, size_t output);
/// A function of a texel's index, as a vec2.
std::string called_name(const Instance& instance);
std::string uniform_name(int instance_number, std::string_view param);

/// `scout`: a draw of part of the step's parameters, or nullptr.
StepText assemble(const StepSource& step, const StepSource* scout = nullptr);

/// What a target holds where all of its values are 0, all of them plain.
std::array<float, 4> black_codes(const std::vector<StoredValue>& values);

/// The condition of a pass's "skip" as a function `passgraph_skips(uv)` that stands in the scope of its body.
GlslText skip_text(const PassDeclaration& pass);
inline constexpr const char* kSkips = "passgraph_skips";

/// How many numbers a pass sees of an input, and what it sees of one to which nothing is wired.
int seen_components(const InputPort& port);
std::string constant_value(const InputPort& port);

/// GLSL that the accessors of inputs over a sphere call.
std::string_view sphere_functions();

/// Instead of an item's number in a standalone text: the selection is a number that nobody knows.
inline constexpr int kAnyItem = -1;

/// The declarations a pass's body sees: accessors, parameters, selections, includes, all under their own names, with its
/// body. `prototypes_only`: accessors have no body, so that an analysis sees which are called.
std::string standalone_text(const PassDeclaration& pass, const std::vector<int>& selections,
                            std::vector<std::string>& sources);

/// GLSL literal of a parameter's value, with its type: `vec3(0.4, 0.79, 0.11)`.
std::string literal(ParamType type, const Value& value);
std::string_view glsl_type_of(ParamType type);

} // namespace passgraph::glsl
