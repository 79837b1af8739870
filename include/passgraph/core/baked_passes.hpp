// Passes as a build baked them: their texts, and what analysis derived, so that a start runs no GLSL compiler.
#pragma once

#include <span>

#include <passgraph/core/pass_library.hpp>

namespace passgraph {

struct BakedFile {
    const char* path; ///< as messages name it
    const char* family;
    const char* text;
    const char* derived; ///< of `derived_to_json`; "" for common files and composites
};

/// The library these files make. They were checked when they were baked, so a mistake in them is a bug (assert).
/// Cost     about 0.1 ms per pass.
PassLibrary unbake(std::span<const BakedFile> passes, std::span<const BakedFile> commons,
                   std::span<const BakedFile> composites);

} // namespace passgraph
