// Looks at images that the running plan does not keep: small copies of all of them, and every value at one pixel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tool/view/stack.hpp"
#include "tool/view/stage.hpp"

namespace passgraph::tool::view {

/// What the inspector draws with, the same as the window's frame.
struct Inspected {
    const Stack& stack;
    const PassLibrary& library;
    const CompileOptions& options;
    Frame frame;
};

struct Thumbnail {
    std::string image;
    Signal signal = Signal::radiance;
    HostTexture texture;
};

struct ProbedValue {
    std::string image;
    Signal signal = Signal::radiance;
    int x = 0; ///< the texel, in the image's own extent
    int y = 0;
    Extent extent;
    std::vector<float> values;
};

/// Runs plans of its own between the window's frames, whose outputs are all images of the graph. They are made when they are
/// first asked for, bit by bit, and share the window's programs as far as their texts are the same.
class Inspector {
public:
    explicit Inspector(Stage& stage) : stage_(stage) {}

    /// The graph, a setting or an extent changed: plans are out of date. What was made is thrown away only when it must be.
    void plan_changed();
    /// The camera moved, or time went on: thumbnails are out of date.
    void frame_changed() { thumbnails_are_old_ = true; }

    /// Goes on with thumbnails, one bit. True when they changed.
    bool work_on_thumbnails(const Inspected& inspected);
    const std::vector<Thumbnail>& thumbnails() const { return thumbnails_; }
    bool has_old_thumbnails() const { return thumbnails_are_old_; }

    /// Asks for every value at a place of the picture, (0, 0) being its bottom left and (1, 1) its top right corner.
    void ask(double u, double v);
    bool is_asked() const { return place_.has_value(); }
    /// Goes on with the answer, one bit; it is there when `is_asked` is false again.
    bool work_on_answer(const Inspected& inspected);
    const std::vector<ProbedValue>& answer() const { return answer_; }
    void forget_answer() { answer_.clear(); }
    const Errors& errors() const { return errors_; }
    /// Of the picture in the window, in texels.
    Extent picture_extent() const { return stage_.plan().extent; }

private:
    struct Place {
        double u;
        double v;
    };
    /// A plan of all images, and what is made of it.
    struct Look {
        std::optional<Plan> wanted;
        std::optional<PreparedPlan> prepared;
    };
    bool make(Look& look, const Inspected& inspected, Extent extent);
    template <class Read> void run(Look& look, const Frame& frame, const Read& read);

    Stage& stage_;
    Look small_;
    Look whole_;
    bool thumbnails_are_old_ = true;
    std::vector<Thumbnail> thumbnails_;
    std::optional<Place> place_;
    std::vector<ProbedValue> answer_;
    Errors errors_;
};

} // namespace passgraph::tool::view
