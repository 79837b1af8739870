// What every file of the project keeps to: its size, its first sentence, nothing left to do.
#include <algorithm>

#include <fmt/format.h>

#include "architecture/source_files.hpp"
#include "support/catch.hpp"

using namespace passgraph::test;

namespace {

constexpr size_t kMostLines = 400;

std::vector<SourceFile> written_by_hand()
{
    std::vector<SourceFile> all;
    for (const char* folder : {"include", "lib", "passes", "samples", "tests"})
        for (SourceFile& file : source_files(folder, {".hpp", ".cpp", ".glsl", ".graph.json", ".py", "CMakeLists.txt"}))
            if (!file.path.starts_with("tests/data/"))
                all.push_back(std::move(file));
    return all;
}

bool is_code(const SourceFile& file)
{
    return file.path.ends_with(".hpp") || file.path.ends_with(".cpp");
}

bool is_pass(const SourceFile& file)
{
    return file.path.starts_with("passes/") && file.path.find("/common/") == std::string::npos &&
           (file.path.ends_with(".glsl") || file.path.ends_with(".graph.json"));
}

/// "// Some words that end here.": the sentence may go on in the next lines, and may begin with a name as it is spelt.
bool starts_with_sentence(const SourceFile& file)
{
    for (const std::string& line : file.lines) {
        if (!line.starts_with("// ") || line.size() < 10)
            return false;
        if (line.find_first_of(".:;", 4) != std::string::npos)
            return true;
    }
    return false;
}

template <class Rule>
std::string offenders(const std::vector<SourceFile>& files, const Rule& is_wrong)
{
    std::string text;
    for (const SourceFile& file : files)
        if (is_wrong(file))
            text += fmt::format("{} ({} lines)\n", file.path, file.lines.size());
    return text;
}

} // namespace

TEST_CASE("no source written by hand is longer than 400 lines", "[architecture]")
{
    CHECK(written_by_hand().size() > 150);
    CHECK(offenders(written_by_hand(), [](const SourceFile& file) { return file.lines.size() > kMostLines; }) == "");
}

TEST_CASE("every source's first line says in a sentence what it is", "[architecture]")
{
    CHECK(offenders(written_by_hand(), [](const SourceFile& file) { return is_code(file) && !starts_with_sentence(file); }) == "");
    const auto commons = source_files("passes/common", {".glsl"});
    CHECK_FALSE(commons.empty());
    CHECK(offenders(commons, [](const SourceFile& file) { return !starts_with_sentence(file); }) == "");
}

TEST_CASE("every pass file has a summary and a source", "[architecture]")
{
    const auto has_member = [](const SourceFile& file, const std::string& key) {
        return std::any_of(file.lines.begin(), file.lines.end(), [&](const std::string& line) {
            const size_t at = line.find('"' + key + '"');
            const size_t open = at == std::string::npos ? at : line.find('"', at + key.size() + 2);
            return open != std::string::npos && open + 1 < line.size() && line[open + 1] != '"';
        });
    };
    std::vector<SourceFile> passes = source_files("passes", {".glsl", ".graph.json"});
    std::erase_if(passes, [](const SourceFile& file) { return !is_pass(file); });
    CHECK(passes.size() >= 12);
    CHECK(offenders(passes, [&](const SourceFile& file) { return !has_member(file, "summary"); }) == "");
    CHECK(offenders(passes, [&](const SourceFile& file) { return !has_member(file, "source"); }) == "");
}

TEST_CASE("nothing is marked as left to do", "[architecture]")
{
    const std::vector<std::string> marks = {"TO" "DO", "FIX" "ME", "XX" "X", "HA" "CK"}; // in halves: this file is read, too
    CHECK(offenders(written_by_hand(), [&](const SourceFile& file) {
              return std::any_of(file.lines.begin(), file.lines.end(), [&](const std::string& line) {
                  return std::any_of(marks.begin(), marks.end(), [&](const std::string& mark) { return line.find(mark) != std::string::npos; });
              });
          }) == "");
}

TEST_CASE("every header guards itself with pragma once", "[architecture]")
{
    CHECK(offenders(written_by_hand(), [](const SourceFile& file) {
              return file.path.ends_with(".hpp") && std::find(file.lines.begin(), file.lines.end(), "#pragma once") == file.lines.end();
          }) == "");
}
