// What a pass is fed with, and the scenes it stands in.
#pragma once

#include "tool/contract/suite.hpp"
#include "tool/contract/values.hpp"

namespace passgraph::tool::contract {

/// The scenes a pass is drawn in, the plainest first; nullptr alone for a pass that reads none.
const std::vector<const Scene*>& scenes_for(const PassDeclaration& pass);

/// A picture for each input, within the contract's domain.
Feed fill_inputs(const Subject& subject, const StageOptions& options, Filling filling, std::mt19937& random);

} // namespace passgraph::tool::contract
