// Runs one pass alone, on pictures made by a test, every output stored in binary32.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <passgraph/core/graph.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/core/signal.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph::test {

/// What a pass is fed with. `settings` are parameters, choices and rungs as on the command line ("sigma" = "2").
struct PassRun {
    std::string pass;
    std::vector<std::pair<std::string, Picture>> inputs{};
    std::vector<std::pair<std::string, std::array<Picture, 6>>> cubes{};
    std::vector<std::pair<std::string, std::string>> settings{};
    Signal generic = Signal::radiance;  ///< the signal a generic input is fed with
    Extent extent{};                    ///< of the frame, when there are no inputs
    std::vector<std::string> folders{}; ///< of further passes
    const Scene* scene = nullptr;       ///< for geometry, camera and lights
    std::optional<Ratio> scale{};       ///< of the outputs, instead of the pass's own
};

/// The outputs by name. A failure to compile or render fails the test with the errors' text.
std::map<std::string, Picture> run_pass(const PassRun& run);

/// The one output of a pass that has one.
Picture run_for_output(const PassRun& run);

/// A picture whose every texel is `value`.
Picture constant(Extent extent, std::initializer_list<float> value);

/// Random texels in [lowest, highest], the same for a seed on every machine.
Picture noise(Extent extent, int channels, float lowest, float highest, unsigned seed);

/// Evaluates a GLSL expression once per row, the columns being float variables, on the test context in binary32.
/// `includes` are files of passes/common ("brdf.glsl"). Shape: rows x components of the expression.
std::vector<std::vector<float>> evaluate(const std::string& expression, const std::vector<std::string>& includes,
                                         const std::vector<std::string>& columns,
                                         const std::vector<std::vector<float>>& rows);

/// A CSV table of numbers (`nan`, `inf`, `-inf` included; text columns read as NaN), from tests/data.
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    std::vector<std::vector<std::string>> text;
    size_t column(const std::string& name) const;
};
Table read_table(const std::string& file_in_tests_data);

} // namespace passgraph::test
