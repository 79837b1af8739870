// The project's own sources as lines of text.
#pragma once

#include <string>
#include <vector>

namespace passgraph::test {

struct SourceFile {
    std::string path;  ///< from the project's root
    std::string layer; ///< of include/passgraph/LAYER/ and lib/LAYER/; "" elsewhere
    std::vector<std::string> lines;
};

/// The files below a folder of the project whose names end so.
std::vector<SourceFile> source_files(const std::string& folder, const std::vector<std::string>& endings);

/// Sources and headers of include/ and lib/.
std::vector<SourceFile> library_files();

/// What a line includes, without its quotes or brackets; "" when it includes nothing.
std::string included_by(const std::string& line);

/// The layer an included path belongs to; "" when it is not the project's own.
std::string layer_of(const std::string& included);

/// The layers that `layer` may include, itself among them.
std::vector<std::string> allowed_layers(const std::string& layer);

} // namespace passgraph::test
