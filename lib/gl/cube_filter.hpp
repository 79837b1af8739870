// A sky's cube map, filtered for rough surfaces: a level per roughness for reflections, nine numbers for diffuse light.
#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include <passgraph/core/glsl_interface.hpp>
#include <passgraph/core/picture.hpp>

namespace passgraph::gl {

/// Six square faces of RGBA in OpenGL's order and orientation, row 0 first.
using CubeFaces = std::array<Picture, 6>;

/// Coefficients of a cosine-weighted sky, as the generated `NAME_irradiance(direction)` reads them.
using Harmonics = std::array<glm::vec3, glsl::kHarmonics>;

/// How many levels a prefiltered cube of faces of `size` texels has, the faces themselves being the first.
/// The smallest faces are 4 texels wide, which a lobe of roughness 1 still fills; small cubes keep up to four levels.
int prefiltered_levels(int size);

/// The levels after the first: level k of n + 1 is the sky as a GGX lobe of roughness k / n, seen along its axis, sees it.
///
/// Shape    prefiltered_levels(size) - 1 cubes; faces half as wide from level to level, rounded down.
/// Range    finite texels. A constant cube stays constant within 200 roundings of binary32; no level leaves the range of the
///          faces' values by more.
/// Errors   none.
/// Cost     18 million samples for faces of 512 texels: about 0.1 s on two cores. The same bits on every machine.
/// Source   Karis 2013, "Real Shading in Unreal Engine 4" (n = v = r, weights n.l); Krivanek and Colbert 2008, "Real-time
///          Shading with Filtered Importance Sampling" (a sample reads the level whose texel is as wide as it is).
std::vector<CubeFaces> prefiltered(const CubeFaces& faces);

/// The same faces with every value the nearest that binary16 has, so that no driver's own rounding takes part.
CubeFaces rounded_to_half(CubeFaces faces);

/// Irradiance under the sky, for a plane facing d, projected onto harmonics of degree 2.
///
/// Range    for a constant sky of radiance L exactly pi L, within binary32's rounding, whatever the size of its faces.
///          Even degrees from 4 on are left out: a sky that is one small lamp of irradiance E comes out within 0.094 E, one
///          of clouds and ground within 1 % of its brightest side.
/// Errors   none.
/// Cost     one visit per texel of faces reduced to at most 64.
/// Source   Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", eq. 10 to 13.
Harmonics irradiance_harmonics(const CubeFaces& faces);

} // namespace passgraph::gl
