// Runs the built program in a folder of its own and looks at what it left there.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/json.hpp>
#include <passgraph/core/picture.hpp>

namespace passgraph::test {

struct Outcome {
    int code = -1;   ///< the exit code; -1: killed by a signal
    std::string out; ///< stdout
    std::string err; ///< stderr
};

/// A new empty folder, gone after the test, in which the program is run.
class Workplace {
public:
    Workplace();
    ~Workplace();
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    /// Runs `passgraph` with these words, the folder being the current one. `setting` is one more NAME=VALUE of its environment.
    Outcome run(const std::vector<std::string>& words, const std::string& setting = "") const;

    void write(const std::string& name, const std::string& text) const;
    void write_picture(const std::string& name, const Picture& picture) const;
    std::string read(const std::string& name) const;
    Picture read_picture(const std::string& name) const; ///< values of an .exr or .pfm, codes / 255 of a .png
    bool has(const std::string& name) const;
    std::vector<std::string> files() const; ///< sorted
    std::string path(const std::string& name) const { return folder_ + "/" + name; }

private:
    std::string folder_;
};

/// A picture of one value.
Picture flat(Extent extent, std::vector<float> value);

/// A graph that tone-maps its input `image` into its output `color`.
std::string tone_map_graph();

/// The JSON of a text; fails the test when it is none.
Json json_of(const std::string& text);

} // namespace passgraph::test
