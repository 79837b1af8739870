// A ladder as data: what is drawn on each rung, with which inputs, what the exact result is, and how far off one may be.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <passgraph/core/picture.hpp>
#include <passgraph/scene/scene.hpp>

#include "tool/accuracy/metric.hpp"

namespace passgraph::accuracy {

/// What a ladder's graphs are fed with, the same for each of its rungs.
struct Inputs {
    std::map<std::string, Picture> pictures{}; ///< by the graph's input
    std::shared_ptr<const Scene> scene{};      ///< for graphs that draw one
};

/// What is exact, in double. Shape: the frame's extent, `components` interleaved numbers.
struct Truth {
    Extent extent;
    int components = 1;
    std::vector<double> values{};

    const double* at(int x, int y) const
    {
        return &values[static_cast<size_t>((y * extent.width + x) * components)];
    }
};

/// A further number about a rung that its ladder reports ("realised sigma").
struct Figure {
    std::string name;
    double value = 0.0;
};

using NamePairs = std::vector<std::pair<std::string, std::string>>;

struct Rung {
    std::string name;
    std::string what;     ///< one line for people
    std::string graph;    ///< text of a graph file; its output `result` is compared
    NamePairs settings{}; ///< "blurred.taps" = "13"
    NamePairs codecs{};   ///< "stored.kept" = "rgba16f"
    double bound = 0.0;   ///< the error is at most this, by derivation; infinite: none is derived
    bool is_default = false;
    std::string no_worse_than{}; ///< claimed: its error is not above this rung's; "": nothing is claimed
    bool has_guards = true;
};

/// How values become colors of a picture.
enum class Shown {
    direction,   ///< components of -1 to 1
    radiance,    ///< the part's brightest is white
    display,     ///< as it is
    distance,    ///< of a place from the eye's plane, logarithmic over the part's range
    logarithmic, ///< the last component, over the part's range
};

struct Ladder {
    std::string name;
    std::string title;
    std::string stage;               ///< of a frame: "G-buffer", "lighting", "bloom", "display"
    std::string about;               ///< what is approximated and how it is measured, a few sentences
    std::vector<std::string> passes; ///< whose users it concerns
    NamePairs measures{};            ///< ladders of headers it stands for: pass and ladder
    Metric metric{};
    std::vector<Rung> rungs{}; ///< roughly from coarse to exact
    std::function<Inputs(Extent)> make_inputs{};
    std::function<Truth(const Inputs&, Extent)> find_truth{};
    std::function<std::string(const Inputs&, int x, int y)> describe_input{};
    std::function<std::vector<Figure>(const Inputs&, const Picture& result)> find_figures{};
    Shown shown = Shown::radiance;
    std::array<double, 2> crop_center{0.5, 0.5}; ///< in uv
    Extent crop{84, 56};
};

/// Every ladder of the report, in its order. Errors: none; the table is ours.
const std::vector<Ladder>& all_ladders();

} // namespace passgraph::accuracy
