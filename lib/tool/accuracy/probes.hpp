// Small passes that measure what no pass of the library shows alone: a store and a load, one term of a BRDF.
#pragma once

#include <passgraph/core/error.hpp>
#include <passgraph/core/pass_library.hpp>

namespace passgraph::accuracy {

/// The library with the probes added. Errors: those of a probe that no longer fits the common functions it includes.
Result<PassLibrary> with_probes(const PassLibrary& library, const std::string& common_folder);

} // namespace passgraph::accuracy
