// What a scene calls for.
#pragma once

#include <vector>

#include <passgraph/core/facts.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph {

/// Upper bounds of everything a compiled plan may rely on; `facts_of` of a scene keep every promise of its own facts.
///
/// Shape    one Facts, independent of any camera.
/// Units    counts; irradiance and radiance in the scene's own, in the largest channel; 1/sr (highlight).
/// Range    finite; irradiance is that of the point of an element's box that all lamps reach best; `highlight` bounds D G / (4 n.v)
///          of GGX and Beckmann with Smith's masking for the least roughness of any material in use, textures included.
/// Errors   none
/// Cost     one look at every texel of the textures and the sky, and at every vertex: about 10 ms for 20 000 triangles.
/// Source   own derivation, beside the code.
Facts facts_of(const Scene& scene);

/// Whether a lamp gives any light: it has a color, a place or a direction, and a radius, all of them finite in binary32. What a scene file
/// refuses, a host may still hand over.
bool shines(const Light& light);

/// What a lamp reaches.
struct LampReach {
    bool is_on = false;    ///< shines
    bool to_surface = false; ///< and comes near some element; a lamp that does not adds exactly nothing
    bool to_view = false;    ///< and may be seen to, from the scene's camera
};
/// Per light of the scene, for a view of this extent. Conservative: boxes stand for elements, spheres for cones.
std::vector<LampReach> lamp_reaches(const Scene& scene, Extent view = {16, 9});

} // namespace passgraph
