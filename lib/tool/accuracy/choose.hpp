// Which ladders a run measures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <passgraph/core/error.hpp>
#include <passgraph/core/pass_library.hpp>

#include "tool/accuracy/ladder.hpp"

namespace passgraph::accuracy {

using Ladders = std::vector<std::shared_ptr<const Ladder>>;

/// The ladders that concern these passes; no passes: all of the table, and those of every other pass's header.
///
/// `words` are names of passes or of ladders. A header's ladder that the table does not measure is measured against the
/// reference it names, each item a rung.
/// Errors   unknown_pass; ladder_missing (a pass without any); ladder_without_reference and unknown_reference, at the
///          ladder's line; reference_mismatch where the pass has not the ports or parameters that the reference needs.
Result<Ladders> choose_ladders(const std::vector<std::string>& words, const PassLibrary& library);

/// A header's ladder, measured against the reference it names. Errors: as above.
Result<Ladder> header_ladder(const PassDeclaration& pass, const Selection& selection);

} // namespace passgraph::accuracy
