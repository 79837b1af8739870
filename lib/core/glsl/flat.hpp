// Values that are the same for a whole picture, handed from the vertex stage to the fragment stage of full-screen steps.
//
// Software rasterisers load a uniform for every few pixels, but a flat output of the vertex stage once for every 4 x 4: 16 numbers
// of two lamps are a seventh of the lighting's time on llvmpipe.
#pragma once

#include <string>
#include <vector>

#include "core/glsl/assemble.hpp"

namespace passgraph::glsl {

/// A uniform that the fragment stage reads as the flat value `flat_name(uniform)`.
struct FlatUniform {
    std::string type;
    std::string uniform;
    int count = 0; ///< of an array; 0: none
};

struct Flats {
    bool has_camera = false; ///< what the camera's accessors read
    std::vector<FlatUniform> uniforms{};

    bool has(const std::string& uniform) const;
};

/// The values of a step that fit into its device's varyings: none in geometry steps, whose varyings are their own.
Flats flats_of(const StepSource& step);

std::string flat_name(const std::string& uniform);

/// The declaration in the fragment stage, and the name it is read by there: flat, or the uniform itself.
std::string declared(const Flats& flats, const std::string& type, const std::string& uniform, int count = 0);
std::string name_in(const Flats& flats, const std::string& uniform);

/// The vertex stage of a full-screen step: one triangle that covers the target.
std::string full_screen_vertex(const Flats& flats);

} // namespace passgraph::glsl
