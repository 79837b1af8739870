// One square in front of a camera, drawn and lit: what the tests of hard scenes look at.
#pragma once

#include <map>
#include <string>

#include <passgraph/gl/renderer.hpp>

#include "scene/files.hpp"

namespace passgraph::test {

/// What a scene looks like: every value as the passes made it.
struct Shown {
    Picture albedo;   ///< as the layout stores it: sRGB codes of 8 bit, decoded
    Picture depth;    ///< 0: nothing there
    Picture radiance; ///< rgba32f
    Picture display;  ///< tone-mapped, rgba32f

    /// How many texels show a surface.
    int covered() const;
};

inline constexpr Extent kShownExtent{64, 64};

/// Draws a scene with gbuffer, pbr, sky and tone_map; one renderer serves all scenes, as in a program.
/// Fails the test when a value is NaN, infinite, negative or beyond the signal's domain.
Shown show(const Scene& scene);

/// A square of side 2 in the plane z = 0, facing +Z. `textured` names a picture beside the model, or is "".
std::string write_square(const Folder& folder, const std::string& textured = "");

/// The scene file of a model seen from (0, 0, 4), lit head-on by a white directional light of irradiance 2.
/// `more` is further JSON of the whole, with its comma: `, "sky": {…}`. Members can be replaced.
struct SceneText {
    std::string model = "model.gltf";
    std::string camera = R"("position": [0,0,4], "direction": [0,0,-1])";
    std::string lights = R"({"kind": "directional", "color": [2,2,2], "direction": [0,0,-1]})";
    std::string placed = "";
    std::string more = "";
    std::string text() const;
};

/// The scene, loaded; its mistakes fail the test.
Scene load(const Folder& folder, const SceneText& text);

} // namespace passgraph::test
