// Evaluates a GLSL expression once per row of a table, in binary32: how shader functions get unit tests.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/error.hpp>
#include <passgraph/gl/renderer.hpp>

namespace passgraph {

/// What to evaluate: `declarations` (functions, constants) stand before `expression`, whose value has `components` components
/// and in which each column is a float variable.
struct Evaluation {
    std::string declarations;
    std::vector<std::string> sources; ///< file of each `#line` source number in `declarations`, for messages
    std::string expression;
    int components = 1;
    std::vector<std::string> columns;
    std::vector<std::vector<float>> rows; ///< each as long as `columns`
};

/// Shape    one row of `components` floats per row given.
/// Range    bits go in and come out as they are (R32F and RGBA32F textures), except that a driver may flush denormals.
/// Errors   shader_failed, gl_error, table_too_large (a lack of the machine).
Result<std::vector<std::vector<float>>> evaluate(const Evaluation& evaluation, GlLoader loader);

} // namespace passgraph
