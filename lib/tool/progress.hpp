// One line on a terminal that says what takes so long.
#pragma once

#include <string>

namespace passgraph::tool {

/// Shows what is being done, on stderr and only when that is a terminal, and wipes it at the end.
class Progress {
public:
    explicit Progress(const std::string& what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Replaces the text, at most ten times a second.
    void update(const std::string& what);

private:
    void show(const std::string& what) const;

    bool is_shown_;
    double last_ = 0.0; ///< seconds
};

} // namespace passgraph::tool
