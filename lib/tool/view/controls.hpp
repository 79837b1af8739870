// What a panel offers to set: a control for each parameter, choice and ladder, made from the passes' headers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <passgraph/core/graph_file.hpp>

namespace passgraph::tool::view {

/// Settings that somebody changed, by place ("glow.sigma").
using Settings = std::map<std::string, PassArguments::Setting>;

/// One setting of one pass of the graph file, composites being one pass.
struct Control {
    enum class Kind { number, whole, flag, color, vector, item };
    Kind kind = Kind::number;
    std::string place; ///< "glow.sigma"
    std::string label;
    std::string group;
    std::string help; ///< for a tool tip: range, default, where it is from
    std::string unit;
    int components = 1;
    double lowest = 0.0; ///< may be infinite
    double highest = 0.0;
    double step = 0.0; ///< 0: continuous
    bool is_logarithmic = false;
    bool recompiles = false; ///< static, or a selection: a change makes another program
    bool is_visible = true;  ///< what the header's visible_if says
    std::vector<std::string> items;
    Value value;    ///< now; an item's index
    Value original; ///< what the graph file says
};

struct PassControls {
    std::string name; ///< of the pass in the graph
    std::string pass; ///< which pass it is
    std::string summary;
    std::vector<Control> controls;
};

/// Every control of a graph. Passes without any are left out.
///
/// Range    values of settings that do not fit (an older pass's) are as if they were not there.
std::vector<PassControls> controls_of(const GraphDescription& description, const PassLibrary& library, const Settings& settings);

/// The control's value as a setting that the graph understands.
PassArguments::Setting setting_of(const Control& control, const Value& value);

/// A value brought into the control's range: clamped, on a whole step from the lowest, whole where it must be.
Value fitted(const Control& control, Value value);

/// Applies those settings that fit the graph; the others are ignored and named in the result.
std::vector<std::string> apply_settings(const Settings& settings, Graph& graph);

} // namespace passgraph::tool::view
