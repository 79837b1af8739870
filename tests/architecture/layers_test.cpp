// Layers: arrows point one way, and each foreign library is seen by the layers that wrap it alone.
#include <algorithm>

#include <fmt/format.h>

#include "architecture/source_files.hpp"
#include "support/catch.hpp"

using namespace passgraph::test;

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Every include in include/ and lib/ that `is_wrong(file, included)`, as "file:line includes it".
template <class Rule>
std::string offenders(const Rule& is_wrong)
{
    std::string text;
    for (const SourceFile& file : library_files())
        for (size_t i = 0; i < file.lines.size(); ++i)
            if (const std::string included = included_by(file.lines[i]); !included.empty() && is_wrong(file, included))
                text += fmt::format("{}:{} includes {}\n", file.path, i + 1, included);
    return text;
}

bool is_of(const std::string& included, const std::vector<std::string>& starts)
{
    return std::any_of(starts.begin(), starts.end(), [&](const std::string& start) { return included.starts_with(start); });
}

} // namespace

TEST_CASE("includes follow the arrows between the layers", "[architecture]")
{
    CHECK(offenders([](const SourceFile& file, const std::string& included) {
              const std::string layer = layer_of(included);
              return !layer.empty() && !is_in(allowed_layers(file.layer), layer);
          }) == "");
}

TEST_CASE("every source of include and lib belongs to a layer", "[architecture]")
{
    const auto files = library_files();
    CHECK(files.size() > 100);
    for (const SourceFile& file : files) {
        CAPTURE(file.path);
        CHECK_FALSE(allowed_layers(file.layer).empty());
    }
}

TEST_CASE("a public header includes public headers alone", "[architecture]")
{
    CHECK(offenders([](const SourceFile& file, const std::string& included) {
              return file.path.starts_with("include/") && !layer_of(included).empty() && !included.starts_with("passgraph/");
          }) == "");
}

TEST_CASE("only gl and context include graphics headers, and glfw and osmesa are context's own", "[architecture]")
{
    CHECK(offenders([](const SourceFile& file, const std::string& included) {
              return is_of(included, {"GL/", "GLES", "KHR/", "EGL/", "GLFW/"}) && !is_in({"gl", "context"}, file.layer);
          }) == "");
    CHECK(offenders([](const SourceFile& file, const std::string& included) {
              return is_of(included, {"EGL/", "GLFW/", "GL/osmesa"}) && file.layer != "context";
          }) == "");
    CHECK(offenders([](const SourceFile& file, const std::string& included) {
              return file.path.starts_with("include/") && is_of(included, {"GL/", "GLES", "EGL/", "GLFW/"});
          }) == "");
}

TEST_CASE("foreign libraries stay in the layers that wrap them", "[architecture]")
{
    CHECK(offenders([](const SourceFile& file, const std::string& included) { return is_of(included, {"glslang", "spirv"}) && file.layer != "shader"; }) == "");
    CHECK(offenders([](const SourceFile& file, const std::string& included) { return is_of(included, {"tiny_gltf", "tinygltf"}) && file.layer != "scene"; }) == "");
    CHECK(offenders([](const SourceFile& file, const std::string& included) { return is_of(included, {"tinyexr"}) && file.layer != "image"; }) == "");
    CHECK(offenders([](const SourceFile& file, const std::string& included) { return is_of(included, {"CLI/"}) && file.layer != "tool"; }) == "");
}

TEST_CASE("an include line is understood in each of its forms", "[architecture]")
{
    CHECK(included_by("#include <GL/gl.h>") == "GL/gl.h");
    CHECK(included_by("  #  include \"core/x.hpp\" // why") == "core/x.hpp");
    CHECK(included_by("int include;").empty());
    CHECK(layer_of("passgraph/core/error.hpp") == "core");
    CHECK(layer_of("shader/tree.hpp") == "shader");
    CHECK(layer_of("passgraph/passes.hpp").empty());
    CHECK(layer_of("vector").empty());
}
