// Meshes of glTF models: every way to store triangles gives the same triangles.
#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::bytes_of;
using test::Folder;
using test::load_model;
using test::ModelBuilder;
using test::one_mesh;

namespace {

constexpr int kByte = 5120, kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125;
const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

std::vector<glm::vec3> corners(const Mesh& mesh)
{
    std::vector<glm::vec3> places;
    for (const std::uint32_t index : mesh.indices)
        places.push_back(mesh.vertices[index].position);
    return places;
}

Mesh only_mesh(const ModelBuilder& model, const std::string& primitive)
{
    const Folder folder;
    const auto loaded = load_model(model.write(folder, one_mesh(primitive)));
    REQUIRE(loaded.mistakes == "");
    REQUIRE(loaded.scene.meshes.size() == 1);
    return loaded.scene.meshes[0];
}

} // namespace

TEST_CASE("indices of 8, 16 and 32 bits and none at all give the same triangle", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    model.add(bytes_of<std::uint8_t>({0, 1, 2}), kUnsignedByte, 3, "SCALAR");
    model.add(bytes_of<std::uint16_t>({0, 1, 2}), kUnsignedShort, 3, "SCALAR");
    model.add(bytes_of<std::uint32_t>({0, 1, 2}), kUnsignedInt, 3, "SCALAR");
    const std::vector<glm::vec3> wanted{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (const char* indices : {"", ",\"indices\":1", ",\"indices\":2", ",\"indices\":3"})
        CHECK(corners(only_mesh(model, std::string("\"attributes\":{\"POSITION\":0}") + indices)) == wanted);
}

TEST_CASE("strips and fans become triangles that all face the same way", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats(kSquare, 3);
    model.add(bytes_of<std::uint16_t>({0, 1, 3, 2}), kUnsignedShort, 4, "SCALAR");
    const Mesh strip = only_mesh(model, "\"mode\":5,\"attributes\":{\"POSITION\":0}");
    const Mesh fan = only_mesh(model, "\"mode\":6,\"attributes\":{\"POSITION\":0},\"indices\":1");
    for (const Mesh& mesh : {strip, fan}) {
        REQUIRE(mesh.indices.size() == 6);
        for (const Vertex& vertex : mesh.vertices)
            CHECK(vertex.normal == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("points, lines and triangles without area by repeated corners are left out", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    model.add(bytes_of<std::uint16_t>({0, 0, 1}), kUnsignedShort, 3, "SCALAR");
    const Folder folder;
    for (const char* primitive : {"\"mode\":0,\"attributes\":{\"POSITION\":0}", "\"mode\":3,\"attributes\":{\"POSITION\":0}",
                                  "\"attributes\":{\"POSITION\":0},\"indices\":1", "\"attributes\":{}"}) {
        const auto loaded = load_model(model.write(folder, one_mesh(primitive)));
        CHECK(loaded.mistakes == "");
        CHECK(loaded.scene.meshes.empty());
        CHECK(loaded.scene.elements.empty());
    }
}

TEST_CASE("missing normals are flat and unshare the vertices", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
    model.add(bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3}), kUnsignedShort, 6, "SCALAR");
    const Mesh mesh = only_mesh(model, "\"attributes\":{\"POSITION\":0},\"indices\":1");
    REQUIRE(mesh.vertices.size() == 6);
    CHECK(mesh.vertices[0].normal == glm::vec3(0, 0, 1));
    CHECK(mesh.vertices[3].normal == glm::vec3(1, 0, 0));
    CHECK(mesh.vertices[0].uv == glm::vec2(0));
}

TEST_CASE("normals get length 1 and a zero one becomes its face's", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    model.add_floats({0, 0, 0, 0, 3, 0, 0, 0, -0.5f}, 3);
    const Mesh mesh = only_mesh(model, "\"attributes\":{\"POSITION\":0,\"NORMAL\":1}");
    CHECK(mesh.vertices[0].normal == glm::vec3(0, 0, 1));
    CHECK(mesh.vertices[1].normal == glm::vec3(0, 1, 0));
    CHECK(mesh.vertices[2].normal == glm::vec3(0, 0, -1));
}

TEST_CASE("huge positions do not overflow the computed normal", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats({0, 0, 0, 1e30f, 0, 0, 0, 1e30f, 0}, 3);
    CHECK(only_mesh(model, "\"attributes\":{\"POSITION\":0}").vertices[0].normal == glm::vec3(0, 0, 1));
}

TEST_CASE("normalized 8- and 16-bit texture coordinates reach exactly 1", "[scene][gltf]")
{
    ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    model.add(bytes_of<std::uint8_t>({0, 255, 51, 102, 255, 0}), kUnsignedByte, 3, "VEC2", ",\"normalized\":true");
    model.add(bytes_of<std::uint16_t>({0, 65535, 13107, 26214, 65535, 0}), kUnsignedShort, 3, "VEC2",
              ",\"normalized\":true");
    for (const char* set : {"1", "2"}) {
        const Mesh mesh = only_mesh(model, fmt::format("\"attributes\":{{\"POSITION\":0,\"TEXCOORD_0\":{}}}", set));
        CHECK(mesh.vertices[0].uv == glm::vec2(0, 1));
        CHECK(mesh.vertices[1].uv == glm::vec2(0.2f, 0.4f));
        CHECK(mesh.vertices[2].uv == glm::vec2(1, 0));
    }
}

TEST_CASE("signed normalized components end at -1", "[scene][gltf]")
{
    ModelBuilder model;
    model.add(bytes_of<std::int8_t>({-128, 0, 0, 127, 0, 0, 0, -127, 0}), kByte, 3, "VEC3", ",\"normalized\":true");
    const Mesh mesh = only_mesh(model, "\"attributes\":{\"POSITION\":0}");
    CHECK(mesh.vertices[0].position == glm::vec3(-1, 0, 0));
    CHECK(mesh.vertices[1].position == glm::vec3(1, 0, 0));
    CHECK(mesh.vertices[2].position == glm::vec3(0, -1, 0));
}

TEST_CASE("a sparse accessor replaces single elements", "[scene][gltf]")
{
    ModelBuilder model;
    model.add(bytes_of<std::uint16_t>({1}), kUnsignedShort, 1, "SCALAR");
    model.add_floats({0, 0, 7}, 3);
    model.add(bytes_of(test::kTriangle), 5126, 3, "VEC3",
              ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":0,\"componentType\":5123},"
              "\"values\":{\"bufferView\":1}}");
    const Mesh mesh = only_mesh(model, "\"attributes\":{\"POSITION\":2}");
    CHECK(mesh.vertices[0].position == glm::vec3(0));
    CHECK(mesh.vertices[1].position == glm::vec3(0, 0, 7));
}

TEST_CASE("a sparse index past the accessor is refused", "[scene][gltf]")
{
    ModelBuilder model;
    model.add(bytes_of<std::uint16_t>({3}), kUnsignedShort, 1, "SCALAR");
    model.add_floats({0, 0, 7}, 3);
    model.add(bytes_of(test::kTriangle), 5126, 3, "VEC3",
              ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":0,\"componentType\":5123},"
              "\"values\":{\"bufferView\":1}}");
    const Folder folder;
    const auto loaded = load_model(model.write(folder, one_mesh("\"attributes\":{\"POSITION\":2}")));
    CHECK_THAT(loaded.mistakes, Catch::Contains("a sparse index is not less than its count 3"));
}

TEST_CASE("interleaved attributes are read at their stride", "[scene][gltf]")
{
    const std::vector<float> both{0, 0, 0, 0.25f, 1, 0, 0, 0.5f, 0, 1, 0, 0.75f};
    const Folder folder;
    folder.write("both.bin", bytes_of(both));
    const auto loaded = load_model(folder.write(
        "both.gltf", "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":48,\"uri\":\"both.bin\"}],"
                     "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48,\"byteStride\":16}],\"accessors\":[{\"bufferView\":0,"
                     "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}]," +
                         one_mesh("\"attributes\":{\"POSITION\":0}") + "}"));
    REQUIRE(loaded.mistakes == "");
    CHECK(corners(loaded.scene.meshes[0]) == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}
