// Passes written as text inside a test, files in a folder of their own, and what is asked of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "passgraph/core/error.hpp"
#include "passgraph/core/pass_library.hpp"

namespace passgraph::test {

/// A pass `probe` with the inputs `image` and `other` (color), one output, and more header members ("params": …).
/// Line 1 is the whole header: the body begins on line 2.
std::string probe(const std::string& body, const std::string& members = "");

/// The access of `image` in that pass, as text; the errors when it is refused.
std::string access_of(const std::string& body, const std::string& members = "");

/// The access of one input of a whole pass text.
std::string access_in(const std::string& text, const std::string& input);

/// The errors of a pass's text; none when it is fine.
Errors errors_of(const std::string& text, const std::vector<std::string>& common_folders = {});

/// The one error with that code; fails the test unless there is exactly one.
Error only(const Errors& errors, const std::string& code);

/// A new empty folder that is gone after the test.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string path() const { return path_.string(); }
    /// Writes a file, with the folders above it; returns its path.
    std::string write(const std::string& name, const std::string& text) const;

private:
    std::filesystem::path path_;
};

} // namespace passgraph::test
