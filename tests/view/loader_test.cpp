// Reading on another thread: what is good comes through, what is not stays as it was.
#include <chrono>
#include <thread>

#include "support/catch.hpp"
#include "tool/view/loader.hpp"
#include "view/scratch_folder.hpp"

using namespace passgraph;
using namespace passgraph::tool::view;

namespace {

std::string pass(const std::string& expression)
{
    return "/*{ \"pass\": \"mine\", \"summary\": \"s\", \"inputs\": { \"image\": \"display\" }, \"outputs\": { \"color\": \"display\" }, \"source\": \"own\" }*/\n"
           "#include \"half.glsl\"\nvec3 mine(vec2 uv) { return " +
           expression + "; }\n";
}

LoadedPasses load(Loader& loader)
{
    loader.request_passes();
    for (;;) {
        if (auto loaded = loader.take_passes())
            return std::move(*loaded);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

struct Files {
    test::ScratchFolder folder;
    std::string graph = folder.write("g.graph.json", R"({ "passgraph": 1, "inputs": { "a": "display" }, "passes": { "m": { "pass": "mine", "inputs": { "image": "a" } } }, "outputs": { "color": "m" } })");

    Files()
    {
        folder.write("passes/common/half.glsl", "// Half.\nfloat half_of(float x) { return 0.5 * x; }\n");
        folder.write("passes/screen/mine.glsl", pass("image(uv) * half_of(1.0)"));
    }
    LoaderFiles files() const { return {{folder.path("passes")}, {graph}, ""}; }
};

} // namespace

TEST_CASE("a pass that did not change is the same object, one that did is read again", "[view][loader]")
{
    Files files;
    Loader loader(files.files(), [] {});
    const LoadedPasses first = load(loader);
    REQUIRE(first.errors.empty());
    REQUIRE(first.library->find("mine"));
    REQUIRE(first.graphs.front());
    const LoadedPasses second = load(loader);
    CHECK(second.library->find("mine") == first.library->find("mine"));
    files.folder.write("passes/screen/mine.glsl", pass("image(uv) * half_of(0.5)"));
    const LoadedPasses third = load(loader);
    CHECK(third.library->find("mine") != first.library->find("mine"));
    files.folder.write("passes/common/half.glsl", "// Half.\nfloat half_of(float x) { return 0.4 * x; }\n");
    CHECK(load(loader).library->find("mine") != third.library->find("mine"));
}

TEST_CASE("a broken pass or graph stays the last good one, with its errors", "[view][loader]")
{
    Files files;
    Loader loader(files.files(), [] {});
    const LoadedPasses good = load(loader);
    files.folder.write("passes/screen/mine.glsl", pass("image(uv) * nothing"));
    files.folder.write("g.graph.json", "{ \"passgraph\": 1,\n \"passes\": }");
    const LoadedPasses broken = load(loader);
    REQUIRE(broken.errors.size() == 2);
    CHECK(broken.errors[0].where.file == files.folder.path("passes/screen/mine.glsl"));
    CHECK(broken.errors[0].where.line == 3);
    CHECK(broken.errors[1].code == "json_syntax");
    CHECK(broken.errors[1].where.line == 2);
    CHECK(broken.library->find("mine") == good.library->find("mine"));
    CHECK(broken.graphs.front() == good.graphs.front());
    files.folder.write("passes/screen/mine.glsl", pass("image(uv)"));
    CHECK(load(loader).library->find("mine") != good.library->find("mine"));
}

TEST_CASE("errors of a file that is still being written are not told", "[view][loader]")
{
    Files files;
    Loader loader(files.files(), [] {});
    REQUIRE(load(loader).errors.empty());
    const std::string whole = pass("image(uv) * 0.25");
    files.folder.write("passes/screen/mine.glsl", whole.substr(0, whole.size() / 2));
    std::thread writer([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        files.folder.write("passes/screen/mine.glsl", whole);
    });
    const LoadedPasses loaded = load(loader);
    writer.join();
    CHECK(loaded.errors.empty());
    CHECK(loaded.library->find("mine")->body.text.find("0.25") != std::string::npos);
}
