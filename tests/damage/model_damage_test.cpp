// Damaged models: read into meshes whose indices stay inside, or refused; never a crash.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <passgraph/scene/bounds.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "damage/mutate.hpp"
#include "scene/files.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

std::string bytes_of_file(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    REQUIRE(stream);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// What every loaded scene promises to the renderer.
void check_scene(const Scene& scene)
{
    for (const Mesh& mesh : scene.meshes) {
        bool is_right = mesh.indices.size() % 3 == 0 && static_cast<size_t>(mesh.material) < scene.materials.size();
        for (const std::uint32_t index : mesh.indices)
            is_right = is_right && index < mesh.vertices.size();
        for (const Vertex& vertex : mesh.vertices)
            is_right = is_right && std::isfinite(vertex.position.x + vertex.uv.x) &&
                       std::abs(glm::length(vertex.normal) - 1.0f) < 1e-5f;
        if (!is_right)
            FAIL("a mesh that cannot be drawn");
    }
    for (const Texture& texture : scene.textures)
        if (texture.rgba.size() != static_cast<size_t>(texture.extent.width) * static_cast<size_t>(texture.extent.height) * 4)
            FAIL("a texture whose bytes do not fit its extent");
    for (const Element& element : scene.elements)
        if (static_cast<size_t>(element.mesh) >= scene.meshes.size())
            FAIL("an element without a mesh");
    bounds(scene);
}

/// Loads a damaged model; true when it was whole enough.
bool loads(const std::string& path, const std::string& content)
{
    Scene scene;
    const auto read = append_gltf(scene, path, glm::dmat4(1.0), "thing");
    if (!read) {
        check_errors(read.error(), content, path);
        return false;
    }
    check_scene(scene);
    return true;
}

} // namespace

TEST_CASE("a damaged .glb is read or refused", "[damage][gltf]")
{
    const Folder folder;
    const std::string whole = bytes_of_file(data_file("models/box01.glb"));
    Random random(21);
    int read = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string worse = damaged_bytes(whole, random);
        for (auto more = random() % 3; more > 0; --more)
            worse = damaged_bytes(std::move(worse), random);
        INFO("try " << i);
        read += loads(folder.write("m.glb", worse), worse);
    }
    CHECK(read > 100);
    CHECK(read < 1950);
}

TEST_CASE("a damaged .gltf is read or refused", "[damage][gltf]")
{
    const Folder folder;
    for (const char* file : {"Cube.bin", "Cube_BaseColor.png", "Cube_MetallicRoughness.png"})
        std::filesystem::copy(data_file(std::string("models/cube/") + file), folder.path(file));
    const std::string whole = bytes_of_file(data_file("models/cube/Cube.gltf"));
    Random random(22);
    int read = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string worse = damaged_text(whole, random);
        for (auto more = random() % 3; more > 0; --more)
            worse = damaged_text(std::move(worse), random);
        INFO(worse);
        read += loads(folder.write("m.gltf", worse), worse);
    }
    CHECK(read > 100);
    CHECK(read < 1950);
}

TEST_CASE("a model whose buffer or pictures are damaged is read or refused", "[damage][gltf]")
{
    const Folder folder;
    const std::vector<std::string> files = {"Cube.bin", "Cube_BaseColor.png", "Cube_MetallicRoughness.png"};
    const std::string text = bytes_of_file(data_file("models/cube/Cube.gltf"));
    const std::string path = folder.write("Cube.gltf", text);
    Random random(23);
    for (int i = 0; i < 1500; ++i) {
        for (const std::string& file : files) {
            std::string bytes = bytes_of_file(data_file("models/cube/" + file));
            folder.write(file, random() % 2 ? damaged_bytes(std::move(bytes), random) : bytes);
        }
        INFO("try " << i);
        loads(path, text);
    }
}
