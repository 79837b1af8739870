// The catalogue of hard cases: complete, and every test it names exists.
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include <passgraph/core/json.hpp>

#include "support/catch.hpp"

using namespace passgraph;

namespace {

constexpr int kCases = 113;

const Json& table()
{
    static const Json json = [] {
        const std::string path = std::string(PASSGRAPH_SOURCE_DIR) + "/tests/data/catalogue.json";
        const auto text = read_text_file(path);
        REQUIRE(text);
        auto parsed = parse_json(*text, path);
        if (!parsed)
            FAIL(to_text(parsed.error()));
        return *parsed;
    }();
    return json;
}

/// The names of a test program's tests; empty when it is not there.
std::set<std::string> names_in(const std::string& program)
{
    std::set<std::string> names;
    const std::string path = std::string(PASSGRAPH_BINARY_DIR) + "/bin/tests_" + program;
    if (!std::filesystem::exists(path))
        return names;
    FILE* pipe = popen((path + " --list-test-names-only 2>/dev/null").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 1024> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) {
        std::string name = line.data();
        while (!name.empty() && (name.back() == '\n' || name.back() == ' '))
            name.pop_back();
        names.insert(name);
    }
    pclose(pipe);
    return names;
}

} // namespace

TEST_CASE("every case of the catalogue has tests or a reason why it concerns nothing that exists", "[catalogue]")
{
    std::set<int> numbers;
    for (const Json& entry : table().find("cases")->array) {
        const int number = static_cast<int>(entry.find("case")->number);
        INFO("case " << number);
        CHECK(numbers.insert(number).second);
        CHECK_FALSE(entry.find("input")->string.empty());
        const bool is_absent = entry.find("absent") != nullptr;
        CHECK(is_absent != (entry.find("tests") != nullptr));
        if (is_absent) {
            CHECK(entry.find("absent")->string.size() > 10);
            continue;
        }
        CHECK_FALSE(entry.find("tests")->array.empty());
        CHECK_FALSE(entry.find("expected")->string.empty());
        CHECK_FALSE(entry.find("oracle")->string.empty());
    }
    for (int number = 1; number <= kCases; ++number) {
        INFO("case " << number);
        CHECK(numbers.count(number) == 1);
    }
    CHECK(numbers.size() == kCases);
}

TEST_CASE("every test that the catalogue names exists in its program", "[catalogue]")
{
    std::map<std::string, std::set<std::string>> programs;
    for (const Json& entry : table().find("cases")->array) {
        const Json* tests = entry.find("tests");
        if (tests == nullptr)
            continue;
        for (const Json& test : tests->array) {
            INFO("case " << entry.find("case")->number << ": " << test.string);
            const size_t colon = test.string.find(": ");
            REQUIRE(colon != std::string::npos);
            const std::string program = test.string.substr(0, colon);
            if (programs.count(program) == 0)
                programs[program] = names_in(program);
            CHECK(programs[program].count(test.string.substr(colon + 2)) == 1);
        }
    }
    CHECK(programs.size() >= 6);
}
