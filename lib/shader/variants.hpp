// The selections and static values under which a pass's body may differ.
#pragma once

#include <vector>

#include "passgraph/core/declaration.hpp"

namespace passgraph::shader {

/// Settings to check a body under, never none. `is_complete`: every one there is, so that what holds under all of them holds.
template <class Setting>
struct VariantList {
    std::vector<std::vector<Setting>> all;
    bool is_complete = true;
};

/// An item of each selection: every combination when there are few, else each varied alone around the defaults.
/// `leaves_open`: a selection that no preprocessor directive names is not varied but left open (glsl::kAnyItem), so that one
/// analysis holds for all its items; a body that needs it as a constant does not compile then.
VariantList<int> selections_of(const PassDeclaration& pass, bool leaves_open);

/// A value of each parameter: of numbers, the default and both ends of the range. Empty where the pass has no static one.
VariantList<Value> statics_of(const PassDeclaration& pass);

} // namespace passgraph::shader
