// The build's own tool: checks the passes folder and bakes it into a C++ source and a header of typed structs.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "passgraph/core/graph_file.hpp"
#include "passgraph/core/json.hpp"
#include "passgraph/core/pass_header.hpp"
#include "passgraph/shader/pass_file.hpp"
#include "shader/bake/cpp_struct.hpp"

namespace fs = std::filesystem;

namespace passgraph::bake {
namespace {

std::string baked_row(const std::string& path, const std::string& family, const std::string& text,
                      const std::string& derived)
{
    // Adjacent raw literals: some compilers limit one literal's length.
    std::string literal;
    constexpr size_t kLongest = 8000;
    for (size_t start = 0; start < text.size(); start += kLongest)
        literal += fmt::format("R\"passgraph({})passgraph\"\n", text.substr(start, kLongest));
    return fmt::format("    {{\"{}\", \"{}\",\n{}, R\"passgraph({})passgraph\"}},\n", path, family,
                       literal.empty() ? "\"\"" : literal, derived);
}

std::string table(const std::string& name, const std::string& rows)
{
    return fmt::format("constexpr BakedFile {}[] = {{\n{}}};\n", name, rows);
}

bool write(const fs::path& path, const std::string& text)
{
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    return static_cast<bool>(stream.flush());
}

/// Composites after those they are made of.
std::vector<PassPtr> composites_in_order(const PassLibrary& library)
{
    std::vector<PassPtr> order;
    const auto visit = [&](const auto& self, const PassPtr& pass) -> void {
        if (!pass || !pass->composite || std::find(order.begin(), order.end(), pass) != order.end())
            return;
        for (const auto& inner : pass->composite->passes)
            self(self, library.find(inner.pass.text));
        order.push_back(pass);
    };
    for (const auto& [name, pass] : library.passes())
        visit(visit, pass);
    return order;
}

int run(const fs::path& folder, const fs::path& output)
{
    PassLibrary library;
    if (const auto loaded = load_pass_folder(folder.string(), library); !loaded) {
        std::fputs(to_text(loaded.error()).c_str(), stderr);
        return 1;
    }
    const auto shown = [&](const std::string& path) {
        return "passes/" + fs::path(path).lexically_relative(folder).generic_string();
    };
    std::string passes;
    std::string structs;
    for (const auto& [name, pass] : library.passes()) {
        if (!pass->composite)
            passes += baked_row(shown(pass->file), pass->family, *read_text_file(pass->file), derived_to_json(*pass));
        structs += cpp_struct(*pass) + "\n";
    }
    std::string composites;
    for (const PassPtr& pass : composites_in_order(library))
        composites += baked_row(shown(pass->file), pass->family, *read_text_file(pass->file), "");
    std::vector<fs::path> common_files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "common"))
        if (entry.is_regular_file())
            common_files.push_back(entry.path());
    std::sort(common_files.begin(), common_files.end());
    std::string commons;
    for (const fs::path& file : common_files)
        commons += baked_row(shown(file.string()), "common", *read_text_file(file.string()), "");

    const std::string source = "// Generated from the passes folder.\n#include "
                               "<passgraph/core/baked_passes.hpp>\n#include <passgraph/core/graph.hpp>\n\n"
                               "namespace passgraph {\nnamespace {\n\n" +
                               table("kPasses", passes) + table("kCommons", commons) +
                               table("kComposites", composites) +
                               "\n} // namespace\n\nconst PassLibrary& builtin_passes()\n{\n"
                               "    static const PassLibrary library = unbake(kPasses, kCommons, kComposites);\n    "
                               "return library;\n}\n\n} // namespace passgraph\n";
    const std::string header =
        "// Generated from the passes folder: a struct per pass, whose wires the C++ compiler checks.\n#pragma once\n\n"
        "#include <optional>\n\n#include <passgraph/core/graph.hpp>\n#include <passgraph/core/pass_settings.hpp>\n\n"
        "namespace passgraph::passes {\n\n" +
        structs + "} // namespace passgraph::passes\n";
    fs::create_directories(output / "passgraph");
    if (!write(output / "baked_passes.cpp", source) || !write(output / "passgraph" / "passes.hpp", header)) {
        fmt::print(stderr, "error[file_unwritable] {}\n", output.string());
        return 3;
    }
    return 0;
}

} // namespace
} // namespace passgraph::bake

int main(int argc, char** argv)
{
    if (argc != 3) {
        fmt::print(stderr, "usage: passgraph_bake PASSES_FOLDER OUTPUT_FOLDER\n");
        return 2;
    }
    return passgraph::bake::run(fs::path(argv[1]), fs::path(argv[2]));
}
