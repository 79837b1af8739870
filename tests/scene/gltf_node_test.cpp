// Where the nodes of a glTF model put its meshes.
#include <glm/gtc/matrix_transform.hpp>

#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::Folder;
using test::load_model;

namespace {

/// A model of one triangle mesh with these nodes.
test::Loaded with_nodes(const std::string& nodes, const glm::mat4& placed = glm::mat4(1.0f))
{
    const Folder folder;
    test::ModelBuilder model;
    model.add_floats(test::kTriangle, 3);
    return load_model(
        model.write(folder, "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," + nodes), placed);
}

glm::vec3 image_of(const Element& element, const glm::vec3& point)
{
    return glm::vec3(element.world_from_model * glm::dvec4(point, 1.0));
}

} // namespace

TEST_CASE("a node scales, then rotates, then translates", "[scene][gltf]")
{
    const auto loaded = with_nodes("\"nodes\":[{\"mesh\":0,\"translation\":[10,0,0],\"scale\":[2,3,4],"
                                   "\"rotation\":[0,0,0.70710678118654752,0.70710678118654752]}]");
    REQUIRE(loaded.mistakes == "");
    const glm::vec3 place = image_of(loaded.scene.elements[0], {1, 0, 0});
    CHECK(place.x == Approx(10.0f));
    CHECK(place.y == Approx(2.0f));
}

TEST_CASE("children are placed by their parents and the model by the caller", "[scene][gltf]")
{
    const auto loaded = with_nodes("\"nodes\":[{\"children\":[1],\"translation\":[1,0,0]},"
                                   "{\"mesh\":0,\"matrix\":[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,5,0,1]}]",
                                   glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 100)));
    REQUIRE(loaded.mistakes == "");
    CHECK(image_of(loaded.scene.elements[0], {1, 1, 1}) == glm::vec3(3, 7, 102));
}

TEST_CASE("a negative scale stays in the placement", "[scene][gltf]")
{
    const auto loaded = with_nodes("\"nodes\":[{\"mesh\":0,\"scale\":[-1,1,1]}]");
    CHECK(glm::determinant(loaded.scene.elements[0].world_from_model) == -1.0);
    CHECK(loaded.scene.meshes[0].vertices[1].position == glm::vec3(1, 0, 0));
}

TEST_CASE("two nodes share one mesh and have numbered names", "[scene][gltf]")
{
    const auto loaded = with_nodes("\"nodes\":[{\"mesh\":0},{\"mesh\":0}]");
    REQUIRE(loaded.scene.elements.size() == 2);
    CHECK(loaded.scene.meshes.size() == 1);
    CHECK(loaded.scene.elements[0].name == "thing.0");
    CHECK(loaded.scene.elements[1].name == "thing.1");
}

TEST_CASE("only the default scene is drawn; the first one, if none is named", "[scene][gltf]")
{
    const std::string nodes = "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"translation\":[1,0,0]},{\"mesh\":0}],"
                              "\"scenes\":[{\"nodes\":[1]},{\"nodes\":[0,2]}]";
    const auto first = with_nodes(nodes);
    REQUIRE(first.scene.elements.size() == 1);
    CHECK(first.scene.elements[0].world_from_model[3][0] == 1.0);
    CHECK(with_nodes(nodes + ",\"scene\":1").scene.elements.size() == 2);
}

TEST_CASE("without scenes every root is drawn", "[scene][gltf]")
{
    CHECK(with_nodes("\"nodes\":[{\"mesh\":0,\"children\":[2]},{\"mesh\":0},{\"mesh\":0}]").scene.elements.size() == 3);
}

TEST_CASE("a scene that lists a child or a node twice is refused", "[scene][gltf]")
{
    CHECK_THAT(with_nodes("\"nodes\":[{\"children\":[1]},{\"mesh\":0}],\"scenes\":[{\"nodes\":[0,1]}]").mistakes,
               Catch::Contains("names nodes[1], which is no root"));
    CHECK_THAT(with_nodes("\"nodes\":[{\"mesh\":0}],\"scenes\":[{\"nodes\":[0,0]}]").mistakes,
               Catch::Contains("names nodes[0] twice"));
}

TEST_CASE("a chain of a hundred thousand nodes does not exhaust the stack", "[scene][gltf]")
{
    std::string nodes = "\"nodes\":[";
    constexpr int kNodes = 100000;
    for (int i = 0; i + 1 < kNodes; ++i)
        nodes += fmt::format("{{\"children\":[{}]}},", i + 1);
    const auto loaded = with_nodes(nodes + "{\"mesh\":0}]");
    CHECK(loaded.mistakes == "");
    CHECK(loaded.scene.elements.size() == 1);
}

TEST_CASE("a placement that no float holds is refused and adds nothing", "[scene][gltf]")
{
    const auto loaded = with_nodes("\"nodes\":[{\"children\":[1],\"scale\":[1e30,1,1]},{\"mesh\":0,\"scale\":[1e30,1,1]}]");
    CHECK_THAT(loaded.mistakes, Catch::Contains("value_out_of_range") && Catch::Contains("no finite place"));
    CHECK(loaded.scene.meshes.empty());
}

TEST_CASE("a matrix with a perspective row is refused", "[scene][gltf]")
{
    CHECK_THAT(with_nodes("\"nodes\":[{\"mesh\":0,\"matrix\":[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}]").mistakes,
               Catch::Contains("is not affine"));
}
