// Defect 10 of the original: work that is done again each frame.
#include <cstddef>
#include <map>

#include "defects/defect_support.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// What the driver was asked for, by function; bytes of buffers and texels of textures that came with data.
struct Asked {
    std::map<std::string, int> calls;
    std::ptrdiff_t bytes = 0;
    std::ptrdiff_t texels = 0;
};

Asked& asked()
{
    static Asked counted;
    return counted;
}

template <class Function> Function* real(const char* name)
{
    return reinterpret_cast<Function*>(test_context().loader()(name));
}

using Text = const char*;

void buffer_data(unsigned target, std::ptrdiff_t size, const void* data, unsigned usage)
{
    asked().bytes += data ? size : 0;
    real<decltype(buffer_data)>("glBufferData")(target, size, data, usage);
}
void buffer_sub_data(unsigned target, std::ptrdiff_t offset, std::ptrdiff_t size, const void* data)
{
    asked().bytes += size;
    real<decltype(buffer_sub_data)>("glBufferSubData")(target, offset, size, data);
}
void tex_image(unsigned target, int level, int internal, int width, int height, int border, unsigned format, unsigned type,
               const void* data)
{
    ++asked().calls["glTexImage2D"];
    asked().texels += data ? static_cast<std::ptrdiff_t>(width) * height : 0;
    real<decltype(tex_image)>("glTexImage2D")(target, level, internal, width, height, border, format, type, data);
}
void tex_sub_image(unsigned target, int level, int x, int y, int width, int height, unsigned format, unsigned type,
                   const void* data)
{
    asked().texels += static_cast<std::ptrdiff_t>(width) * height;
    real<decltype(tex_sub_image)>("glTexSubImage2D")(target, level, x, y, width, height, format, type, data);
}
int get_uniform_location(unsigned program, Text name)
{
    ++asked().calls["glGetUniformLocation"];
    return real<decltype(get_uniform_location)>("glGetUniformLocation")(program, name);
}
unsigned create_program()
{
    ++asked().calls["glCreateProgram"];
    return real<decltype(create_program)>("glCreateProgram")();
}
template <int Which> void gen(int count, unsigned* ids)
{
    static constexpr Text kNames[] = {"glGenBuffers", "glGenTextures", "glGenFramebuffers", "glGenVertexArrays"};
    asked().calls[kNames[Which]] += count;
    real<void(int, unsigned*)>(kNames[Which])(count, ids);
}

void* counting_loader(const char* name)
{
    static const std::map<std::string, void*> counted = {
        {"glBufferData", reinterpret_cast<void*>(buffer_data)},
        {"glBufferSubData", reinterpret_cast<void*>(buffer_sub_data)},
        {"glTexImage2D", reinterpret_cast<void*>(tex_image)},
        {"glTexSubImage2D", reinterpret_cast<void*>(tex_sub_image)},
        {"glGetUniformLocation", reinterpret_cast<void*>(get_uniform_location)},
        {"glCreateProgram", reinterpret_cast<void*>(create_program)},
        {"glGenBuffers", reinterpret_cast<void*>(gen<0>)},
        {"glGenTextures", reinterpret_cast<void*>(gen<1>)},
        {"glGenFramebuffers", reinterpret_cast<void*>(gen<2>)},
        {"glGenVertexArrays", reinterpret_cast<void*>(gen<3>)},
    };
    const auto found = counted.find(name);
    return found == counted.end() ? test_context().loader()(name) : found->second;
}

} // namespace

TEST_CASE("defect 10: after the first frame nothing is created, looked up by name or uploaded again", "[defects]")
{
    const Scene& scene = night_lamp();
    Camera camera = scene.camera;
    std::ptrdiff_t mesh_bytes = 0;
    for (const Mesh& mesh : scene.meshes)
        mesh_bytes += static_cast<std::ptrdiff_t>(mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * 4);
    CompileOptions options;
    options.extent = {160, 90};
    const auto plan = compile(sample_graph("deferred_demo/bloom.graph.json"), options);
    REQUIRE(plan);
    asked() = {};
    auto renderer = Renderer::create(*plan, {.loader = counting_loader});
    REQUIRE(renderer);
    REQUIRE(renderer->set_scene(scene));
    REQUIRE(renderer->render());
    CHECK(asked().bytes >= mesh_bytes); // the first frame does pay, and the counters count
    CHECK(asked().texels > 0);
    CHECK(asked().calls["glGenTextures"] > 0);
    CHECK(asked().calls["glGetUniformLocation"] > 0);
    for (int frame = 1; frame < 4; ++frame) {
        asked() = {};
        camera.position.x += 0.5; // even when everything has to be drawn again
        const std::int64_t draws = renderer->counters().draws;
        REQUIRE(renderer->render({.time = frame / 60.0, .index = frame, .camera = &camera}));
        CHECK(renderer->counters().draws >= draws + static_cast<std::int64_t>(scene.elements.size() + plan->steps.size()) - 1);
        CHECK(asked().calls.empty());
        CHECK(asked().texels == 0);
        // Camera and frame blocks, and each lamp in view space: 3 * 64 + 2 * 16, 32 and 3 * 16 bytes.
        CHECK(asked().bytes <= 3 * 64 + 2 * 16 + 32 + static_cast<std::ptrdiff_t>(scene.lights.size()) * 3 * 16);
    }
}

TEST_CASE("defect 10: what nothing reads is not drawn, and images that never live together share memory", "[defects]")
{
    CompileOptions options;
    options.extent = {1280, 720};
    const Graph graph = sample_graph("deferred_demo/bloom.graph.json");
    const auto plan = compile(graph, options);
    REQUIRE(plan);
    std::int64_t bytes = 0;
    bool has_smaller = false;
    for (const auto& slot : plan->slots) {
        bytes += static_cast<std::int64_t>(slot.extent.width) * slot.extent.height * bytes_per_texel(slot.format);
        has_smaller = has_smaller || slot.extent.width < options.extent.width;
    }
    CHECK(has_smaller);
    // The original's eight full-size targets: RGB16F is stored with four channels of two bytes, and D24 with four bytes.
    CHECK(bytes < std::int64_t{1280} * 720 * (8 * 8 + 4));
    // An output less: what only the glow needed is gone with it.
    const auto without = compile(graph_of(R"({
      "passgraph": 1, "inputs": { "photo": "radiance" },
      "passes": { "bright": { "pass": "bright", "inputs": { "image": "photo" } },
                  "glow": { "pass": "gaussian_blur", "inputs": { "image": "bright" } },
                  "shown": { "pass": "tone_map", "inputs": { "image": "photo" } } },
      "outputs": { "color": "shown" } })"), options);
    REQUIRE(without);
    CHECK(without->steps.size() == 1);
}
