// The compiled result: steps in order, memory, formats, programs, and the reason for every decision. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <passgraph/core/codec.hpp>
#include <passgraph/core/declaration.hpp>
#include <passgraph/core/facts.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/core/signal.hpp>

namespace passgraph {

struct Plan {
    /// One texture of memory, shared over time by images that never live together.
    struct Slot {
        Format format = Format::rgba16f;
        Extent extent;
        std::vector<std::string> images; ///< who lives here, in order of time
    };

    /// A picture or cube map the host supplies, or the scene's sky or atlas, by name. `extent` is that the plan was
    /// compiled for (pictures only).
    struct Import {
        enum class Kind : std::uint8_t { picture, cube, sky, atlas };
        Kind kind = Kind::picture;
        std::string name;
        Signal signal = Signal::radiance;
        Extent extent;

        /// The scene's own stands in where the host supplies none.
        bool is_of_scene() const { return kind == Kind::sky || kind == Kind::atlas; }
    };

    /// A texture bound to a sampler of the step's program.
    struct Read {
        enum class Source : std::uint8_t { slot, import };
        Source source = Source::slot;
        int index = 0;       ///< into `slots` or `imports`
        std::string sampler; ///< the uniform's name: sampler2D, image2D if `is_loaded`, or samplerCube for cube and sky imports
        Filter filter = Filter::nearest;
        AddressMode wrap = AddressMode::clamp;
        bool has_levels = false; ///< sampled with mip levels (imports only)
        bool is_loaded = false;  ///< bound to an image unit: whole texels are loaded, nothing is filtered or wrapped
        std::string image;       ///< whose value it is, for people
    };

    /// A live parameter: `place` ("lit.exposure") is how people name it.
    struct Uniform {
        std::string name;
        std::string place;
        ParamType type = ParamType::float_;
        Value value;
        double lowest = 0.0;
        double highest = 0.0;
    };

    /// A color attachment, at the location of its position in `targets`.
    struct Target {
        int slot = 0;
        std::string image; ///< or several, joined with " + "
        std::array<float, 4> black{}; ///< what 0 is stored as
    };

    /// One draw of a full-screen triangle, or one traversal of the scene's elements.
    struct Step {
        enum class Kind : std::uint8_t { draw, geometry };
        Kind kind = Kind::draw;
        std::string name;                ///< the passes joined with " + "
        std::vector<std::string> passes; ///< node names
        Extent extent;
        std::vector<Read> reads;
        std::vector<Uniform> uniforms;
        std::vector<Target> targets;
        int depth_slot = -1; ///< geometry: the depth attachment; -1 for draws
        /// A draw in two parts: `fragment` where this depth buffer holds a surface, `background` where it holds none. Without a
        /// background the targets are cleared to black before the surfaces are drawn.
        int tested_depth_slot = -1;
        std::string background;
        int counts = -1;     ///< the query that asks whether any pixel of this step is not black; black ones are not drawn
        /// Not "": after a frame in which the query of `counts` counted no pixel, this fragment stage looks first, over
        /// `scout_extent`, and the step is drawn only if a pixel of that is drawn.
        std::string scout;
        Extent scout_extent;
        int skipped_by = -1; ///< nothing is drawn, and the targets are black, if this query counted no pixel
        /// Not "": if `skipped_by` counted no pixel this fragment stage is drawn instead; it takes what is black for 0.
        std::string when_skipped;
        bool is_cleared = true; ///< left out by `skipped_by`, its images are 0, as somebody may look at them
        std::string black_images; ///< that it takes for 0, for people
        Reads host;          ///< camera, lights, frame, elements: which blocks and buffers are bound
        std::string vertex;  ///< complete GLSL 3.30 sources
        std::string fragment;
        std::vector<std::string> sources; ///< file of each `#line` source number, for messages

        std::vector<int> written_slots() const; ///< of the targets, then of the depth
        bool writes(int slot) const;
    };

    struct Output {
        std::string name;
        std::string image;
        Read::Source source = Read::Source::slot;
        int index = 0; ///< into `slots` or `imports`; holds nothing but this image
        Signal signal = Signal::radiance;
        Codec codec;
        Extent extent;
    };

    /// Asks the device whether any pixel of a step's images is not black. `index` of `counts` and `skipped_by`.
    struct Query {
        int step = 0;
        std::string images; ///< for people
    };

    /// An edge that stayed a texture, and why.
    struct Boundary {
        std::string image;
        std::string reader;
        std::string reason;
    };

    /// What the scene's facts or the parameters' values made superfluous.
    struct Decision {
        std::string what; ///< a pass, an input or an image
        std::string reason;
    };

    struct Culled {
        std::string pass;
        std::string reason;
    };

    Extent extent;
    std::vector<Import> imports;
    std::vector<Slot> slots;
    std::vector<Step> steps;
    std::vector<Query> queries;
    std::vector<Output> outputs;
    std::vector<Boundary> boundaries;
    std::vector<Culled> culled;
    std::vector<Decision> decisions;
    Facts facts; ///< that the plan is for
    std::vector<std::string> inlined; ///< images that need no memory
    std::int64_t bytes = 0;           ///< of all slots
    std::int64_t bytes_unshared = 0;  ///< had every stored image its own texture
};

/// Why the device left a step out, or drew its variant; "" when it did neither.
std::string why_skipped(const Plan& plan, std::size_t step, bool was_skipped);
/// The plan for people: steps, memory, boundaries with reasons.
std::string to_text(const Plan& plan);
/// The plan as a JSON object (`"passgraph": 1`), schema in lib/core/plan.schema.json; `with_glsl` adds the sources.
std::string to_json(const Plan& plan, bool with_glsl);
/// The plan as a Graphviz digraph.
std::string to_dot(const Plan& plan);

} // namespace passgraph
