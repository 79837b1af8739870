// Scene files that are right.
#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include <passgraph/image/image_file.hpp>

#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;
using test::Folder;

namespace {

Scene load(const Folder& folder, const std::string& text)
{
    const auto scene = load_scene(folder.write("lamp.json", text));
    INFO((scene ? std::string() : to_text(scene.error())));
    REQUIRE(scene);
    return *scene;
}

void copy_box(const Folder& folder)
{
    std::filesystem::create_directories(folder.path("models"));
    std::filesystem::copy_file(test::data_file("models/box01.glb"), folder.path("models/box.glb"));
}

void write_sky(const Folder& folder, float value)
{
    Picture face({2, 2}, 3);
    std::fill(face.texels.begin(), face.texels.end(), value);
    std::filesystem::create_directories(folder.path("sky"));
    for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"})
        REQUIRE(write_picture(folder.path(std::string("sky/") + name + ".pfm"), face));
}

} // namespace

TEST_CASE("a scene file's camera, sky, elements and lights are loaded", "[scene]")
{
    const Folder folder;
    copy_box(folder);
    write_sky(folder, 2.0f);
    const Scene scene = load(folder, R"({ // comments are allowed
      "passgraph_scene": 1, "name": "night_lamp",
      "camera": { "position": [0,100,140], "direction": [0,0,-2], "vertical_fov_degrees": 90, "near": 1, "far": 2001 },
      "sky": { "faces": "sky", "intensity": 0.5 },
      "elements": [ { "name": "a", "model": "models/box.glb", "position": [1,2,3], "scale": 2 },
                    { "name": "b", "model": "models/../models/box.glb", "scale": [1,-1,1] } ],
      "lights": [ { "name": "moon", "kind": "directional", "color": [1.2,1.2,3.5], "direction": [0,-4,0] },
                  { "kind": "point", "color": [9,8,7], "position": [0,50,0], "radius": 200 },
                  { "kind": "spot", "color": [9,8,7], "position": [0,50,0], "direction": [3,0,0], "radius": 20,
                    "inner_angle_degrees": 30, "outer_angle_degrees": 30 },
                  { "kind": "spot", "color": [9,8,7], "position": [0,50,0], "direction": [3,0,0], "radius": 20,
                    "outer_angle_degrees": 180 } ] })");
    CHECK(scene.name == "night_lamp");
    CHECK(scene.camera.position == glm::dvec3(0, 100, 140));
    CHECK(scene.camera.direction == glm::vec3(0, 0, -1));
    CHECK(scene.camera.vertical_fov == Approx(1.5707963f));
    CHECK(scene.camera.far_plane == 2001.0f);
    CHECK(scene.sky.faces[5].texels == std::vector<float>(12, 1.0f));
    REQUIRE(scene.elements.size() == 2);
    CHECK(scene.elements[0].world_from_model * glm::dvec4(1, 1, 1, 1) == glm::dvec4(3, 4, 5, 1));
    CHECK(scene.elements[1].world_from_model[1][1] == -1.0);
    REQUIRE(scene.lights.size() == 4);
    CHECK(scene.lights[0].direction == glm::vec3(0, -1, 0));
    CHECK(scene.lights[1].kind == Light::Kind::point);
    CHECK(scene.lights[1].radius == 200.0f);
    CHECK(scene.lights[1].name == "light 1");
    CHECK(scene.lights[2].kind == Light::Kind::spot);
    CHECK(scene.lights[2].direction == glm::vec3(1, 0, 0));
    CHECK(scene.lights[2].inner_angle == Approx(0.52359878f));
    CHECK(scene.lights[2].outer_angle == scene.lights[2].inner_angle);
    CHECK(scene.lights[3].inner_angle == 0.0f);
    CHECK(scene.lights[3].outer_angle == Approx(3.14159265f));
    SECTION("a model named twice is held once") { CHECK(scene.meshes.size() == 1); }
}

TEST_CASE("a target is looked at from the position", "[scene]")
{
    const Folder folder;
    const Scene scene =
        load(folder, R"({"passgraph_scene": 1, "camera": {"position": [1,1,1], "target": [1,1,9], "up": [0,3,0]}})");
    CHECK(scene.camera.direction == glm::vec3(0, 0, 1));
    CHECK(scene.camera.up == glm::vec3(0, 1, 0));
}

TEST_CASE("a camera without an up looks straight down like onto a map, and straight up", "[scene]")
{
    const Folder folder;
    for (const auto& [direction, up] : {std::pair{"[0,-3,0]", glm::vec3(0, 0, -1)}, {"[0,0.5,0]", glm::vec3(0, 0, 1)}}) {
        const Scene scene = load(folder, R"({"passgraph_scene": 1, "camera": {"position": [1,1,1], "direction": )" + std::string(direction) + "}}");
        CHECK(scene.camera.up == up);
    }
}

TEST_CASE("rotation is about x, then the turned y, then the twice turned z", "[scene]")
{
    const Folder folder;
    copy_box(folder);
    const Scene scene = load(folder, R"({"passgraph_scene": 1, "elements": [
        {"model": "models/box.glb", "rotation_degrees": [90, 90, 0]}]})");
    const glm::vec3 image = glm::mat3(scene.elements[0].world_from_model) * glm::vec3(1, 0, 0);
    CHECK(glm::length(image - glm::vec3(0, 1, 0)) < 1e-6f); // Ry takes x to -z, Rx takes -z to y
    CHECK(scene.elements[0].name == "box");
}

TEST_CASE("without a camera the whole scene is in view, from +Z", "[scene]")
{
    const Folder folder;
    copy_box(folder);
    const Scene scene = load(folder, R"({"passgraph_scene": 1, "elements": [{"model": "models/box.glb",
        "position": [10, 0, 0]}]})");
    CHECK(scene.camera.position.x == 10.0f);
    CHECK(scene.camera.position.z > 0.5f);
    CHECK(scene.camera.direction == glm::vec3(0, 0, -1));
}

TEST_CASE("the least scene file is a scene with a material, a name and no sky", "[scene]")
{
    const Folder folder;
    const Scene scene = load(folder, R"({"passgraph_scene": 1})");
    CHECK(scene.name == "lamp");
    CHECK(scene.materials.size() == 1);
    CHECK_FALSE(scene.sky.is_present());
}
