// Scenes and passes for the tests of the original's defects.
#include "defects/defect_support.hpp"

#include <passgraph/scene/scene_file.hpp>
#include <passgraph/shader/pass_file.hpp>

#include "support/catch.hpp"

namespace passgraph::test {

std::string original_folder()
{
    return std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/original";
}

const PassLibrary& with_original()
{
    static const PassLibrary library = [] {
        PassLibrary all = builtin_passes();
        const auto loaded =
            load_pass_folder(original_folder(), all, std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common");
        if (!loaded)
            FAIL(to_text(loaded.error()));
        return all;
    }();
    return library;
}

const Scene& night_lamp()
{
    static const Scene scene = [] {
        auto loaded = load_scene(std::string(PASSGRAPH_SOURCE_DIR) +
                                 "/samples/deferred_demo/resources/scenes/night_lamp.scene.json");
        if (!loaded)
            FAIL(to_text(loaded.error()));
        return std::move(*loaded);
    }();
    return scene;
}

Scene squares(const std::vector<Square>& all)
{
    Scene scene;
    for (const Square& square : all) {
        const int index = static_cast<int>(scene.meshes.size());
        Material material;
        material.base_color = glm::vec4(square.color, 1.0f);
        material.specular = square.specular;
        material.roughness = square.roughness;
        material.metallic = square.metallic;
        scene.materials.push_back(material);
        Mesh mesh;
        for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
            mesh.vertices.push_back({{corner, 0.0f}, {0, 0, 1}, {0, 0}});
        mesh.indices = {0, 1, 2, 0, 2, 3};
        mesh.material = index;
        scene.meshes.push_back(mesh);
        Element element{"square", index, glm::dmat4(1.0)};
        element.world_from_model[3][2] = -square.distance;
        scene.elements.push_back(element);
    }
    return scene;
}

std::map<std::string, Picture> run_scene(const std::string& graph, const Scene& scene, Extent extent)
{
    GraphRun run;
    run.options.extent = extent;
    run.scene = &scene;
    return run_graph(graph_of(graph, with_original()), run);
}

} // namespace passgraph::test
