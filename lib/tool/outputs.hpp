// Which images go to which files.
#pragma once

#include <string>
#include <vector>

#include <passgraph/gl/renderer.hpp>

#include "tool/options.hpp"

namespace passgraph::tool {

struct OutputFile {
    std::string output; ///< of the plan
    std::string file;   ///< `%04d` in it stands for the frame's number
    Location where;

    bool is_sequence() const;
    std::string file_of(int frame) const;
};

/// The files of `--out`; images that are no outputs of the graph yet (PASS, PASS.PORT) are made some.
///
/// Names that mean nothing are reported to the graph: `compile` returns them.
std::vector<OutputFile> name_outputs(Graph& graph, const std::vector<std::string>& words);

/// Errors   picture_format, radiance_to_png, values_to_png, duplicate_file, file_unwritable (no such folder).
Result<void> check_outputs(const Plan& plan, const std::vector<OutputFile>& outputs);

/// Renders frames 1/60 s apart; every frame of a sequence is written, of the others the last.
///
/// Nothing is written before the first frame is rendered and read.
Result<void> render_frames(Renderer& renderer, int frames, const std::vector<OutputFile>& outputs);

} // namespace passgraph::tool
