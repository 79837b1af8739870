// Only what a scene calls for is drawn, and the picture is that of drawing everything: random scenes, and scenes at the edge of each
// rule. Each pass is drawn by itself, so that every image is rounded alike and no bit may differ.
#include <cstdlib>
#include <optional>
#include <random>

#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/facts.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Many small programs: softpipe compiles them twenty times as fast. Set before the first context is made.
const bool kUsesSoftpipe = setenv("GALLIUM_DRIVER", "softpipe", 0) == 0;

constexpr Extent kExtent{64, 64};

/// A box of side 2 around the origin.
Mesh box_mesh(int material)
{
    Mesh mesh;
    mesh.material = material;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const float sign = side % 2 == 0 ? 1.0f : -1.0f;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 0; corner < 4; ++corner) {
            const float u = corner == 1 || corner == 2 ? 1.0f : -1.0f;
            const float v = corner >= 2 ? 1.0f : -1.0f;
            Vertex vertex;
            vertex.normal = glm::vec3(0.0f);
            vertex.normal[axis] = sign;
            vertex.position[axis] = sign;
            vertex.position[(axis + 1) % 3] = u * sign;
            vertex.position[(axis + 2) % 3] = v;
            vertex.uv = {0.5f * u + 0.5f, 0.5f * v + 0.5f};
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
            mesh.indices.push_back(first + corner);
    }
    return mesh;
}

class RandomScene {
public:
    explicit RandomScene(unsigned seed) : random_(seed)
    {
        scene.camera.position = {0.0, 2.0, 9.0};
        const bool has_metal = chance(0.5f);
        const bool glows = chance(0.4f);
        for (int i = 0; i < 3; ++i) {
            Material material;
            material.base_color = {between(0, 1), between(0, 1), between(0, 1), 1.0f};
            material.metallic = has_metal ? between(0, 1) : 0.0f;
            material.roughness = between(0, 1);
            if (glows && i == 0)
                material.emissive = {between(0, 4), between(0, 4), 0.0f};
            scene.materials.push_back(material);
            scene.meshes.push_back(box_mesh(i));
        }
        const int boxes = static_cast<int>(between(0, 6));
        for (int i = 0; i < boxes; ++i) {
            Element element;
            element.mesh = i % 3;
            element.world_from_model[3] = glm::dvec4(between(-4, 4), between(-2, 3), between(-6, 3), 1.0);
            scene.elements.push_back(element);
        }
        const int lamps = static_cast<int>(between(0, 7));
        for (int i = 0; i < lamps; ++i)
            scene.lights.push_back(random_light());
        if (chance(0.6f)) {
            const float most = chance(0.5f) ? 0.2f : 3.0f;
            for (Picture& face : scene.sky.faces) {
                face = Picture({4, 4}, 3);
                for (float& value : face.texels)
                    value = between(0, most);
            }
        }
    }

    Scene scene;

    float between(float low, float high) { return low + (high - low) * static_cast<float>(random_() % 4096) / 4096.0f; }
    bool chance(float share) { return between(0, 1) < share; }

private:
    Light random_light()
    {
        Light light;
        light.kind = static_cast<Light::Kind>(random_() % 3);
        const float strength = chance(0.2f) ? 0.0f : light.kind == Light::Kind::directional ? 0.5f : 8.0f;
        light.color = {between(0, strength), between(0, strength), between(0, strength)};
        light.position = {between(-9, 9), between(-3, 9), between(-9, 12)};
        light.direction = glm::normalize(glm::vec3(between(-1, 1), -1.0f, between(-1, 1)));
        light.radius = chance(0.2f) ? 0.5f : between(2, 15);
        light.inner_angle = between(0, 0.5f);
        light.outer_angle = light.inner_angle + between(0, 0.6f);
        return light;
    }

    std::mt19937 random_;
};

void set(Graph& graph, const std::string& place, double value) { REQUIRE(graph.set(place, {place, {value}, "", {}})); }

/// One renderer goes from scene to scene and from plan to plan: what is the same for all, the split-sum table, is drawn once.
void draw(std::optional<Renderer>& renderer, const Graph& graph, const Scene& scene, bool is_lazy)
{
    CompileOptions options{.extent = kExtent, .specialise = is_lazy, .fuse = false};
    if (is_lazy)
        options.facts = facts_of(scene);
    auto plan = compile(graph, options);
    REQUIRE(plan);
    if (!renderer) {
        auto made = Renderer::create(std::move(*plan), {.loader = test_context().loader(), .is_timed = true});
        REQUIRE(made);
        renderer = std::move(*made);
    } else {
        REQUIRE(renderer->replace(std::move(*plan)));
    }
    REQUIRE(renderer->set_scene(scene));
    const auto drawn = renderer->render();
    if (!drawn)
        FAIL(to_text(drawn.error()));
}

/// How many passes were not drawn, before drawing and by the device. Every output has the bits of drawing everything.
int compare(const Graph& graph, const Scene& scene)
{
    static std::optional<Renderer> lazy;
    static std::optional<Renderer> eager;
    draw(lazy, graph, scene, true);
    draw(eager, graph, scene, false);
    for (const Plan::Output& output : eager->plan().outputs) {
        INFO(output.name);
        CHECK(lazy->read(output.name)->texels == eager->read(output.name)->texels);
    }
    int left_out = static_cast<int>(lazy->plan().culled.size());
    for (const StepTime& time : lazy->step_times())
        left_out += time.was_skipped;
    return left_out;
}

Graph demo(const char* name) { return sample_graph(std::string("deferred_demo/") + name + ".graph.json"); }

} // namespace

TEST_CASE("a hundred random scenes look as if everything were drawn", "[needed]")
{
    int left_out = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        RandomScene made(seed);
        Graph graph = demo(seed % 3 == 0 ? "bloom" : seed % 3 == 1 ? "night" : "pixelated");
        if (made.chance(0.3f))
            set(graph, "lit.environment", 0.0);
        if (made.chance(0.2f))
            set(graph, "view.intensity", 0.0);
        if (made.chance(0.3f))
            set(graph, "film.strength", 0.0);
        set(graph, "bright.threshold", made.chance(0.5f) ? 0.8 : 20.0);
        set(graph, "bright.knee", made.between(0, 1));
        left_out += compare(graph, made.scene);
    }
    CHECK(left_out > 100); // it did leave passes out
}

TEST_CASE("a scene as dark as threshold minus knee has no bloom before drawing; one a little brighter has", "[needed]")
{
    // No lamp, no sky's light: what a surface emits is all there is, 0.4 = 0.8 - 0.8 * 0.5.
    for (const auto& [emission, has_bloom] : {std::pair{0.0f, false}, {0.39f, false}, {0.4f, true}, {0.41f, true}}) {
        CAPTURE(emission);
        RandomScene made(3);
        Scene& scene = made.scene;
        scene.lights.clear();
        scene.sky = {};
        for (Material& material : scene.materials)
            material.emissive = glm::vec3(emission);
        const Graph graph = demo("bloom");
        compare(graph, scene);
        const auto plan = compile(graph, {.extent = kExtent, .facts = facts_of(scene)});
        REQUIRE(plan);
        const bool is_drawn = std::any_of(plan->steps.begin(), plan->steps.end(), [](const Plan::Step& step) {
            return std::find(step.passes.begin(), step.passes.end(), "eighth") != step.passes.end();
        });
        CHECK(is_drawn == has_bloom); // 0.4 itself, stored as a half, may round up
    }
}

TEST_CASE("an emission of exactly 0 is not read, the smallest is", "[needed]")
{
    for (const float emission : {0.0f, 1e-7f, 1.0f}) {
        CAPTURE(emission);
        RandomScene made(5);
        for (Material& material : made.scene.materials)
            material.emissive = {0.0f, emission, 0.0f};
        const Graph graph = demo("bloom");
        compare(graph, made.scene);
        const auto plan = compile(graph, {.extent = kExtent, .facts = facts_of(made.scene)});
        REQUIRE(plan);
        const bool is_read = std::any_of(plan->imports.begin(), plan->imports.end(),
                                         [](const Plan::Import& import) { return import.name == "scene.atlas_emissive"; });
        CHECK(is_read == (emission > 0.0f));
    }
}

TEST_CASE("every number of lamps from none to more than a program takes is right", "[needed]")
{
    for (int count = 0; count <= 6; ++count) {
        CAPTURE(count);
        RandomScene made(8);
        made.scene.lights.clear();
        for (int i = 0; i < count; ++i) {
            Light light;
            light.kind = static_cast<Light::Kind>(i % 3);
            light.color = glm::vec3(i % 3 == 0 ? 0.5f : 6.0f);
            light.position = {2.0 * i - 5.0, 4.0, 4.0};
            light.direction = glm::normalize(glm::vec3(0.2f, -1.0f, -0.3f));
            light.radius = 12.0f;
            made.scene.lights.push_back(light);
        }
        compare(demo("bloom"), made.scene);
    }
}

TEST_CASE("a lamp that only just reaches a surface is drawn, and one that does not is not missed", "[needed]")
{
    for (const float radius : {2.99f, 3.0f, 3.01f, 3.2f}) {
        CAPTURE(radius);
        RandomScene made(0);
        made.scene.elements.assign(1, {});
        made.scene.elements.front().mesh = 0;
        Light light;
        light.kind = Light::Kind::point;
        light.color = glm::vec3(50.0f);
        light.position = {0.0, 0.0, 4.0}; // three metres in front of the box
        light.radius = radius;
        made.scene.lights.assign(1, light);
        compare(demo("bloom"), made.scene);
    }
}

TEST_CASE("a renderer refuses a scene with more than its plan was made for", "[needed]")
{
    RandomScene made(1);
    made.scene.lights.clear();
    made.scene.sky = {};
    auto plan = compile(demo("bloom"), {.extent = kExtent, .facts = facts_of(made.scene)});
    REQUIRE(plan);
    auto renderer = Renderer::create(std::move(*plan), {.loader = test_context().loader()});
    REQUIRE(renderer);
    REQUIRE(renderer->set_scene(made.scene));
    CHECK(renderer->render());
    Scene lit = made.scene;
    Light light;
    light.kind = Light::Kind::point;
    light.position = {0.0, 0.0, 3.0};
    light.radius = 50.0f;
    lit.lights.push_back(light);
    lit.elements.assign(1, {});
    REQUIRE(renderer->set_scene(lit));
    const auto refused = renderer->render();
    REQUIRE_FALSE(refused);
    CHECK(refused.error().front().code == "facts_unmet");
    CHECK_THAT(refused.error().front().message, Catch::Contains("point_lights"));
    auto fitting = compile(demo("bloom"), {.extent = kExtent, .facts = facts_of(lit)});
    REQUIRE(fitting);
    REQUIRE(renderer->replace(std::move(*fitting)));
    CHECK(renderer->render());
}
