// What is lost between a store and a load: normals, positions, radiance.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tool/accuracy/ladders/ladders.hpp"
#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::accuracy {
namespace {

/// A value stored by one draw and read by another.
std::string store_and_load(const std::string& signal)
{
    return fmt::format(R"({{ "passgraph": 1, "inputs": {{ "value": "{0}" }},
  "passes": {{ "stored": {{ "pass": "keep_{0}", "inputs": {{ "value": "value" }} }},
              "loaded": {{ "pass": "keep_{0}", "inputs": {{ "value": "stored" }}, "codecs": {{ "kept": "rgba32f" }} }} }},
  "outputs": {{ "result": "loaded" }} }})",
                       signal);
}

Rung codec_rung(const std::string& signal, const std::string& codec, const std::string& what, double bound,
                const std::string& no_worse_than)
{
    return {.name = codec,
            .what = what,
            .graph = store_and_load(signal),
            .codecs = {{"stored.kept", codec}},
            .bound = bound,
            .no_worse_than = no_worse_than};
}

Truth the_value_itself(const Inputs& inputs, Extent extent)
{
    const Picture& value = inputs.pictures.at("value");
    return truth_of(extent, [&](int x, int y) { return texel(value, x, y); });
}

/// The whole sphere, equal areas to equal areas; the lowest sixteenth goes on to -Z, where projections stretch without end,
/// by equal steps of the angle's logarithm.
/// Source   Archimedes: a cylinder's height is the sphere's.
Inputs whole_sphere(Extent extent)
{
    return {{{"value", picture_of(extent, [&](int x, int y) {
                  const int low_rows = extent.height / 16;
                  const double height = 2.0 * (y - low_rows + 0.5) / (extent.height - low_rows) - 1.0;
                  const double from_below = y < low_rows ? 0.05 * std::pow(1e-3, 1.0 - (y + 0.5) / low_rows) : std::acos(-height);
                  const double around = 2.0 * std::numbers::pi * (x + 0.5) / extent.width;
                  return std::array<double, 3>{std::sin(from_below) * std::cos(around), std::sin(from_below) * std::sin(around), -std::cos(from_below)};
              })}},
            nullptr};
}

// The scene of the position ladder: upright strips, each four texels wide and at one distance from the eye, so that a
// texel's true place is known whatever the rasteriser does to a slope.
constexpr int kStripWidth = 4;
constexpr double kNearest = 0.2; ///< metres
constexpr double kFarthest = 900.0;

float strip_distance(int strip, int strips)
{
    return static_cast<float>(kNearest * std::pow(kFarthest / kNearest, strip / std::max(strips - 1.0, 1.0)));
}

Inputs strips_of_distance(Extent extent)
{
    auto scene = std::make_shared<Scene>();
    scene->camera.near_plane = 0.1f;
    scene->camera.far_plane = 1000.0f;
    scene->materials.emplace_back();
    Mesh mesh;
    const int strips = (extent.width + kStripWidth - 1) / kStripWidth;
    const double up = std::tan(0.5 * static_cast<double>(scene->camera.vertical_fov));
    const double right = up * extent.width / extent.height;
    for (int i = 0; i < strips; ++i) {
        const double distance = strip_distance(i, strips);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const int corner : {0, 1, 3, 2}) { // counter-clockwise; an eighth of the height beyond each edge
            const double x = (2.0 * kStripWidth * (i + corner % 2) / extent.width - 1.0) * right * distance;
            const double y = (corner / 2 == 0 ? -1.25 : 1.25) * up * distance;
            mesh.vertices.push_back({{static_cast<float>(x), static_cast<float>(y), static_cast<float>(-distance)}, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
        }
        for (const std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u})
            mesh.indices.push_back(first + index);
    }
    scene->meshes.push_back(std::move(mesh));
    scene->elements.push_back({"strips", 0, glm::mat4(1.0f)});
    return {{}, std::move(scene)};
}

Truth places_on_strips(const Inputs& inputs, Extent extent)
{
    const int strips = (extent.width + kStripWidth - 1) / kStripWidth;
    return truth_of(extent, [&](int x, int y) {
        return reference::place_at_distance(x, y, extent.width, extent.height, inputs.scene->camera.vertical_fov,
                                            strip_distance(x / kStripWidth, strips));
    });
}

Rung position_rung(const std::string& name, const std::string& what, const std::string& image, const std::string& codec,
                   double bound, const std::string& no_worse_than)
{
    const bool is_stored = image == "position";
    const std::string reader = is_stored ? R"("pass": "keep_position", "inputs": { "value": "surface.position" }, "codecs": { "kept": "rgba32f" })"
                                         : R"("pass": "position_from_depth", "inputs": { "depth": "surface.depth" }, "codecs": { "position": "rgba32f" })";
    return {.name = name,
            .what = what,
            .graph = fmt::format(R"({{ "passgraph": 1, "inputs": {{ "scene": {{ "kind": "scene" }} }},
  "passes": {{ "surface": {{ "pass": "gbuffer", "inputs": {{ "scene": "scene" }} }},
              "place": {{ {} }} }},
  "outputs": {{ "result": "place" }} }})",
                                 reader),
            .settings = {{"surface.layout", "four_target"}}, // the others pack or derive these outputs themselves
            .codecs = {{"surface." + image, codec}},
            .bound = bound,
            .no_worse_than = no_worse_than};
}

} // namespace

Ladder normal_codec()
{
    Ladder ladder{.name = "normal_codec",
                  .title = "Storing normals",
                  .stage = "G-buffer",
                  .about = "A unit vector is stored by one draw and read by the next. The picture covers the whole sphere, one direction "
                           "per texel; the error is the angle between what went in and what came out.",
                  .passes = {"gbuffer", "pbr", "pbr_surface"},
                  .metric = {"angle to the true normal, largest", "degrees", Distance::angle, Summary::largest},
                  .make_inputs = whole_sphere,
                  .find_truth = the_value_itself,
                  .describe_input = [](const Inputs& in, int x, int y) { return "normal " + vector_text(texel(in.pictures.at("value"), x, y)); },
                  .shown = Shown::direction,
                  .crop_center = {0.5, 0.5}};
    // Octahedral, largest error over the sphere: half a code each way, stretched at most 3-fold from square to sphere and
    // sqrt(2) across: 0.93 degrees for 255 codes (computed over 10 000 normals, Cigolle et al. 2014), and in proportion
    // to the codes: 0.93 * 255 / 1023 and / 65535; 2 % on top for texels between those normals. 16 bits keep 4e-3.
    // Plain binary16 truncates each component by 2^-10 of itself: at most 2^-10 / sqrt(2) rad across = 0.0396 degrees.
    // rgb10: half of 1/511 in each of three directions, sqrt(3) / 2 / 511 rad = 0.0971 degrees.
    // The sphere map's rim is -Z: there the angle is twice the root of what the radius of 2 is off. Half a code of 65535 each way,
    // four times enlarged, is 4.3e-5: 0.0132 rad = 0.76 degrees. In binary32 24 roundings are 1.5e-6: 0.14 degrees.
    // Plain binary32: the guards normalise before the store and at the end, 3 roundings each, which the angle's two sines share.
    ladder.rungs = {
        codec_rung("normal", "octahedral_rg8", "folded onto a square, 8 bits per axis", 0.95, ""),
        codec_rung("normal", "sphere_map_rg16", "Lambert's azimuthal projection, 16 bits per axis", 0.76, ""),
        codec_rung("normal", "octahedral_rg10", "folded onto a square, 10 bits per axis", 0.237, "octahedral_rg8"),
        codec_rung("normal", "sphere_map_rg32f", "Lambert's azimuthal projection, binary32", 0.14, "sphere_map_rg16"),
        codec_rung("normal", "rgb10_a2", "the three components, 10 bits each", 0.0972, "octahedral_rg10"),
        codec_rung("normal", "rgba16f", "the three components, binary16", 0.0396, "rgb10_a2"),
        codec_rung("normal", "octahedral_rg16", "folded onto a square, 16 bits per axis", 0.004, "rgba16f"),
        codec_rung("normal", "rgba32f", "the three components, binary32", 3e-5, "octahedral_rg16"),
    };
    ladder.rungs[6].is_default = true;
    return ladder;
}

Ladder position_source()
{
    Ladder ladder{.name = "position",
                  .title = "Knowing where a pixel is",
                  .stage = "G-buffer",
                  .about = "The G-buffer draws strips at known distances from 0.2 to 900 m (near plane 0.1 m, far plane 1000 m); the place of each "
                           "pixel is stored, or rebuilt from the depth buffer along the view ray. The time is that of both draws: the geometry and the reader.",
                  .passes = {"gbuffer", "position_from_depth", "pbr", "pbr_surface"},
                  .metric = {"distance from the true place over its distance from the eye, largest", "", Distance::relative, Summary::largest},
                  .make_inputs = strips_of_distance,
                  .find_truth = places_on_strips,
                  .describe_input =
                      [](const Inputs& in, int x, int) {
                          const int width = static_cast<int>(in.scene->meshes.front().vertices.size()) / 4;
                          return fmt::format("{:.4g} m away", strip_distance(x / kStripWidth, width));
                      },
                  .shown = Shown::distance,
                  .crop_center = {0.8, 0.5}};
    // binary16 truncates: 2^-10 of each component. Depth of 24 fixed bits: half a step of 2^-24 in d is z^2 (f - n) / (f n)
    // of it in z, so z / n * 2^-25 relative at 900 m: 900 / 0.1 * 2^-25 = 2.7e-4. Reversed binary32: half an ulp of d, 2^-24,
    // and the interpolated vertex' own 2^-24, times the ray and the quotient's 5 more: 1e-6 covers 16 of them.
    ladder.rungs = {
        position_rung("stored_rgba16f", "the place, binary16", "position", "rgba16f", 9.8e-4, ""),
        position_rung("from_depth24", "from a depth buffer of 24 fixed-point bits", "depth", "depth24", 2.9e-4, ""),
        position_rung("from_depth32f", "from a reversed binary32 depth buffer", "depth", "depth32f", 1e-6, "from_depth24"),
        position_rung("stored_rgba32f", "the place, binary32", "position", "rgba32f", 1e-6, "stored_rgba16f"),
    };
    ladder.rungs[2].is_default = true; // what the default layout, two_target, does
    return ladder;
}

Ladder radiance_codec()
{
    Ladder ladder{.name = "radiance_codec",
                  .title = "Storing radiance",
                  .stage = "lighting",
                  .about = "Colors from 2e-4 to 6e4 of all hues, stored by one draw and read by the next. The error is relative, per channel: "
                           "what one store and load loses. A software rasteriser truncates, so that each further pass darkens by the bias.",
                  .passes = {"pbr", "pbr_surface", "sky", "bloom_combine", "bright"},
                  .metric = {"relative error of a channel, largest", "", Distance::relative, Summary::largest, 0.0, true},
                  .make_inputs = [](Extent extent) { return Inputs{{{"value", radiance_field(extent, 1e-3, 6e4)}}, nullptr}; },
                  .find_truth = the_value_itself,
                  .describe_input = [](const Inputs& in, int x, int y) { return "radiance " + vector_text(texel(in.pictures.at("value"), x, y)); },
                  .shown = Shown::radiance,
                  .crop_center = {0.45, 0.4}};
    // Truncation loses up to one step: 2^-5 of blue's five bits and 2^-10 of binary16's ten; binary32 keeps what came in.
    ladder.rungs = {
        codec_rung("radiance", "r11f_g11f_b10f", "11, 11 and 10 bits without sign", 1.0 / 32.0, ""),
        codec_rung("radiance", "rgba16f", "binary16", 1.0 / 1024.0, "r11f_g11f_b10f"),
        codec_rung("radiance", "rgba32f", "binary32", 0.0, "rgba16f"),
    };
    ladder.rungs[1].is_default = true;
    return ladder;
}

} // namespace passgraph::accuracy
