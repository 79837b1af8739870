// Passes written as text inside a test, files in a folder of their own, and what is asked of them.
#include "shader/pass_text.hpp"

#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "passgraph/shader/pass_file.hpp"
#include "support/catch.hpp"

namespace passgraph::test {

std::string probe(const std::string& body, const std::string& members)
{
    return fmt::format(R"(/*{{ "pass": "probe", "inputs": {{ "image": "color", "other": {{ "signal": "color", "levels": true }} }}, )"
                       R"("outputs": {{ "result": {{ "signal": "color", "size": {{ "of": "other" }} }} }}{}{} }}*/)"
                       "\n{}\n",
                       members.empty() ? "" : ", ", members, body);
}

std::string access_of(const std::string& body, const std::string& members)
{
    return access_in(probe(body, members), "image");
}

std::string access_in(const std::string& text, const std::string& input)
{
    const auto pass = read_pass(text, "probe.glsl", "test", {});
    if (!pass)
        return to_text(pass.error());
    return to_text((*pass)->inputs[static_cast<size_t>((*pass)->find_input(input))].access);
}

Errors errors_of(const std::string& text, const std::vector<std::string>& common_folders)
{
    const auto pass = read_pass(text, "probe.glsl", "test", common_folders);
    return pass ? Errors{} : pass.error();
}

Error only(const Errors& errors, const std::string& code)
{
    INFO(to_text(errors));
    REQUIRE(errors.size() == 1);
    REQUIRE(errors.front().code == code);
    return errors.front();
}

Folder::Folder()
{
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() / fmt::format("passgraph_shader_{}_{}", ::getpid(), count++);
    std::filesystem::create_directories(path_);
}

Folder::~Folder()
{
    std::filesystem::remove_all(path_);
}

std::string Folder::write(const std::string& name, const std::string& text) const
{
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
}

} // namespace passgraph::test
