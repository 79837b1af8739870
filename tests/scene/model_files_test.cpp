// Whole model files as exporters write them.
#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::data_file;
using test::load_model;

TEST_CASE("a .glb of a box becomes twelve triangles", "[scene][gltf]")
{
    const auto loaded = load_model(data_file("models/box01.glb"));
    REQUIRE(loaded.mistakes == "");
    REQUIRE(loaded.scene.meshes.size() == 1);
    CHECK(loaded.scene.meshes[0].indices.size() == 36);
    CHECK(loaded.scene.meshes[0].vertices.size() == 32);
    REQUIRE(loaded.scene.elements.size() == 1);
    CHECK(loaded.scene.elements[0].name == "thing");
    CHECK(loaded.scene.materials[0].base_color == glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
}

TEST_CASE("a .gltf finds its buffer and its pictures beside it", "[scene][gltf]")
{
    const auto loaded = load_model(data_file("models/cube/Cube.gltf"));
    REQUIRE(loaded.mistakes == "");
    const Scene& scene = loaded.scene;
    REQUIRE(scene.textures.size() == 2);
    CHECK(scene.meshes[0].indices.size() == 36);
    CHECK(scene.textures[0].extent == Extent{8, 8});
    CHECK(scene.textures[0].is_srgb);
    CHECK_FALSE(scene.textures[1].is_srgb);
    CHECK(scene.textures[0].rgba.size() == 8 * 8 * 4);
    CHECK(scene.textures[0].rgba[0] == 240);
    CHECK(scene.textures[0].rgba[3] == 255);
    CHECK(scene.materials[0].base_color_texture == 0);
    CHECK(scene.materials[0].metallic_roughness_texture == 1);
    for (const Vertex& vertex : scene.meshes[0].vertices)
        CHECK(glm::length(vertex.normal) == Approx(1.0f));
}

TEST_CASE("a second model's indices go on after the first's", "[scene][gltf]")
{
    Scene scene;
    REQUIRE(append_gltf(scene, data_file("models/box01.glb"), glm::mat4(1.0f), "box"));
    REQUIRE(append_gltf(scene, data_file("models/cube/Cube.gltf"), glm::mat4(1.0f), "cube"));
    CHECK(scene.elements[1].mesh == 1);
    CHECK(scene.meshes[1].material == 1);
    CHECK(scene.materials[1].base_color_texture == 0);
    REQUIRE(append_gltf(scene, data_file("models/cube/Cube.gltf"), glm::mat4(1.0f), "cube2"));
    CHECK(scene.materials[2].base_color_texture == 2);
}
