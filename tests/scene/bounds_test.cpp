// The box around a scene and the camera that shows all of it.
#include <passgraph/scene/bounds.hpp>
#include <passgraph/scene/camera_matrices.hpp>

#include <glm/gtc/matrix_transform.hpp>

#include "support/catch.hpp"

using namespace passgraph;

namespace {

Scene one_triangle()
{
    Scene scene;
    Mesh mesh;
    mesh.vertices.resize(4);
    mesh.vertices[1].position = {1, 0, 0};
    mesh.vertices[2].position = {0, 1, 0};
    mesh.vertices[3].position = {100, 100, 100};
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    return scene;
}

} // namespace

TEST_CASE("a scene without elements has no box", "[scene][bounds]")
{
    CHECK(bounds(one_triangle()).is_empty());
}

TEST_CASE("the box holds each element where it is placed and no vertex that is not drawn", "[scene][bounds]")
{
    Scene scene = one_triangle();
    scene.elements.push_back({"a", 0, glm::mat4(1.0f)});
    scene.elements.push_back({"b", 0, glm::translate(glm::mat4(1.0f), glm::vec3(-5, 0, 2))});
    const Bounds box = bounds(scene);
    CHECK(box.low == glm::vec3(-5, 0, 0));
    CHECK(box.high == glm::vec3(1, 1, 2));
}

TEST_CASE("the framing camera sees every corner of the box", "[scene][bounds]")
{
    const Bounds box{{-3, 10, 4}, {5, 11, 40}};
    const CameraMatrices m = matrices(framing_camera(box), {64, 64});
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 place((corner & 1) ? box.low.x : box.high.x, (corner & 2) ? box.low.y : box.high.y,
                              (corner & 4) ? box.low.z : box.high.z, 1.0f);
        const glm::vec4 clip = m.clip_from_view * m.view_from_world * place;
        CHECK(glm::abs(clip.x) < clip.w);
        CHECK(glm::abs(clip.y) < clip.w);
        CHECK(clip.z > 0.0f);
        CHECK(clip.z < clip.w);
    }
}

TEST_CASE("an empty box and a single point still give a camera that can be used", "[scene][bounds]")
{
    const Bounds point{{1, 2, 3}, {1, 2, 3}};
    for (const Camera& camera : {framing_camera(Bounds{}), framing_camera(point)}) {
        CHECK(camera.near_plane > 0.0f);
        CHECK(camera.near_plane < camera.far_plane);
    }
}
