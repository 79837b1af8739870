// Changes of files are noticed, whatever their kind.
#include "support/catch.hpp"
#include "tool/view/file_watch.hpp"
#include "tool/view/scene_files.hpp"
#include "view/scratch_folder.hpp"

#include <algorithm>

using namespace passgraph;
using namespace passgraph::tool::view;
using Files = std::vector<std::string>;

TEST_CASE("new, changed and lost files are noticed once", "[view][watch]")
{
    test::ScratchFolder folder;
    const std::string pass = folder.write("passes/a/one.glsl", "1");
    const std::string scene = folder.write("s.scene.json", "{}");
    folder.write("passes/a/notes.txt", "not a pass");
    FileWatch watch({{scene, folder.path("later.graph.json")}, {folder.path("passes")}});
    CHECK(watch.look().empty());
    folder.write("passes/a/one.glsl", "22");
    CHECK(watch.look() == Files{pass});
    CHECK(watch.look().empty());
    const std::string common = folder.write("passes/common/c.glsl", "c");
    CHECK(watch.look() == Files{common});
    folder.write("passes/a/notes.txt", "still not a pass");
    CHECK(watch.look().empty());
    const std::string later = folder.write("later.graph.json", "{}");
    CHECK(watch.look() == Files{later});
    std::filesystem::remove(scene);
    CHECK(watch.look() == Files{scene});
}

TEST_CASE("a file of the same size and time in the old one's place is another one", "[view][watch]")
{
    test::ScratchFolder folder;
    const std::string file = folder.write("a.glsl", "old");
    FileWatch watch({{file}, {}});
    const std::string other = folder.write("b.glsl", "new");
    std::filesystem::last_write_time(other, std::filesystem::last_write_time(file));
    std::filesystem::rename(other, file);
    CHECK(watch.look() == Files{file});
}

TEST_CASE("other paths keep what was seen of the old ones", "[view][watch]")
{
    test::ScratchFolder folder;
    const std::string a = folder.write("a.json", "a");
    const std::string b = folder.write("b.json", "b");
    FileWatch watch({{a}, {}});
    folder.write("a.json", "aa");
    watch.watch({{a, b}, {}});
    CHECK(watch.look() == Files{a});
    CHECK(FileWatch::latest({a, b, folder.path("none")}) == std::max(std::filesystem::last_write_time(a), std::filesystem::last_write_time(b)));
}

TEST_CASE("a scene's files are its models, their neighbours and its sky", "[view][watch]")
{
    test::ScratchFolder folder;
    const std::string scene = folder.write("scenes/s.scene.json", R"({ "elements": [ { "model": "../m/a.gltf" }, { "model": "../b.glb" } ], "sky": { "faces": "../sky" } })");
    folder.write("m/a.gltf", "{}");
    folder.write("m/a.bin", "");
    folder.write("sky/px.png", "");
    const Files files = files_of_scene(scene);
    const auto has = [&](const std::string& name) {
        return std::any_of(files.begin(), files.end(), [&](const std::string& file) { return file == scene || std::filesystem::path(file).filename() == name; });
    };
    for (const char* name : {"a.gltf", "a.bin", "b.glb", "px.png"})
        CHECK(std::any_of(files.begin(), files.end(), [&](const std::string& file) { return std::filesystem::path(file).filename() == name; }));
    CHECK(has("s.scene.json"));
    CHECK(files_of_scene(folder.path("none.json")) == Files{folder.path("none.json")});
}
