// Linked programs by their texts, so that a plan made anew compiles only what has changed.
#pragma once

#include <algorithm>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <passgraph/core/plan.hpp>

#include "gl/cube_filter.hpp"
#include "gl/objects.hpp"

namespace passgraph::gl {

/// A linked program and the values it was last sent, so that several steps, of one plan or of several, may share it.
struct LinkedProgram {
    ProgramObject object;
    std::vector<std::optional<Value>> sent; ///< per uniform of the step
    std::vector<std::optional<Harmonics>> harmonics_sent; ///< per read of the step
};

/// Keeps programs alive beyond their plans: the latest kMostPrograms, and those that a plan uses anyway.
class ProgramPool {
public:
    /// Everything that tells one program from another: texts, and the names whose order gives units and locations.
    static std::string key_of(const Plan::Step& step);

    /// The program of this key, or nullptr.
    std::shared_ptr<LinkedProgram> find(const std::string& key);
    template <class Matches> bool holds(const Matches& matches) const
    {
        return std::any_of(entries_.begin(), entries_.end(),
                           [&](const Entry& entry) { return matches(entry.program->object.id()); });
    }
    void add(std::string key, std::shared_ptr<LinkedProgram> program);

private:
    /// A few stacks of a dozen steps, and the views of their images.
    static constexpr size_t kMostPrograms = 96;
    struct Entry {
        std::string key;
        std::shared_ptr<LinkedProgram> program;
    };
    std::list<Entry> entries_; ///< the latest used first
};

} // namespace passgraph::gl
