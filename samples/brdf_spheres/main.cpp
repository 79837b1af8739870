// A page that shows the models of the lighting pass side by side: one row of spheres, smooth to rough, for each.
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <passgraph/context/context.hpp>
#include <passgraph/core/baked_passes.hpp>
#include <passgraph/core/compile.hpp>
#include <passgraph/core/graph_file.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/image/image_file.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "label.hpp"

using passgraph::Extent;
using passgraph::Picture;

namespace {

struct Model {
    const char* distribution;
    const char* geometry;
    const char* fresnel;
};

constexpr std::array<Model, 8> kModels = {{{"ggx", "smith_correlated", "schlick"},
                                           {"ggx", "smith_separable", "schlick"},
                                           {"ggx", "cook_torrance", "schlick"},
                                           {"ggx", "neumann", "schlick"},
                                           {"ggx", "implicit", "schlick"},
                                           {"beckmann", "smith_correlated", "schlick"},
                                           {"beckmann", "cook_torrance", "schlick"},
                                           {"ggx", "smith_correlated", "exact"}}};
constexpr std::array<const char*, 7> kRoughnesses = {"0.1", "0.2", "0.35", "0.5", "0.65", "0.8", "1.0"};

constexpr Extent kRow{1260, 92};
constexpr int kOversampling = 2; // of each row in both directions, for smooth edges
constexpr int kMargin = 214;     // for the models' names
constexpr int kHead = 64;
constexpr std::array<float, 3> kInk = {0.88f, 0.87f, 0.84f};
constexpr std::array<float, 3> kPale = {0.60f, 0.62f, 0.66f};

template <class T>
T value_or_exit(passgraph::Result<T> result)
{
    if (!result) {
        std::fputs(passgraph::to_text(result.error()).c_str(), stderr);
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

/// The row of spheres as a model lights it.
Picture row_of(const Model& model, const std::string& folder, const passgraph::Scene& scene, passgraph::GlLoader loader)
{
    passgraph::Graph graph = value_or_exit(passgraph::load_graph(folder + "/spheres.graph.json", passgraph::builtin_passes()));
    value_or_exit(graph.set("lit.distribution", {.name = "", .numbers = {}, .item = model.distribution, .where = {}}));
    value_or_exit(graph.set("lit.geometry", {.name = "", .numbers = {}, .item = model.geometry, .where = {}}));
    value_or_exit(graph.set("lit.fresnel", {.name = "", .numbers = {}, .item = model.fresnel, .where = {}}));
    passgraph::CompileOptions options;
    options.extent = {kRow.width * kOversampling, kRow.height * kOversampling};
    auto renderer = value_or_exit(passgraph::Renderer::create(value_or_exit(compile(graph, options)), {.loader = loader}));
    value_or_exit(renderer.set_scene(scene));
    value_or_exit(renderer.render());
    return passgraph::resized(value_or_exit(renderer.read("color")), kRow);
}

/// Copies a row to a place from the page's top left.
void put(Picture& page, const Picture& row, int left, int top)
{
    for (int y = 0; y < row.extent.height; ++y)
        for (int x = 0; x < row.extent.width; ++x)
            for (int c = 0; c < 3; ++c)
                page.at(left + x, page.extent.height - top - row.extent.height + y, c) = row.at(x, y, c);
}

Picture empty_page()
{
    const int rows = static_cast<int>(kModels.size());
    Picture page({kMargin + kRow.width, kHead + rows * kRow.height + 8}, 3);
    for (size_t i = 0; i < 2 * kRoughnesses.size(); ++i) {
        // As make_spheres.py places them: 2.2 apart, 0.8 between gold and lacquer; the camera sees 31.9 of it.
        const bool is_lacquer = i >= kRoughnesses.size();
        const double x = (static_cast<double>(i) * 2.2 + (is_lacquer ? 0.8 : 0.0) - 14.7) / 31.9 + 0.5;
        draw_label(page, kRoughnesses[i % kRoughnesses.size()], kMargin + static_cast<int>(x * kRow.width) - 15, 40, kPale);
    }
    draw_label(page, "roughness", 18, 40, kPale);
    draw_label(page, "gold", kMargin + kRow.width / 4 - 20, 12, kInk);
    draw_label(page, "red lacquer", kMargin + kRow.width * 3 / 4 - 50, 12, kInk);
    return page;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
        return std::fputs("usage: brdf_spheres FOLDER_OF_THIS_SAMPLE OUT.png\n", stderr), 2;
    const std::string folder = argv[1];
    const auto context = passgraph::create_headless_context();
    if (!context)
        return std::fprintf(stderr, "%s\n", context.error().message.c_str()), 3;
    const passgraph::Scene scene = value_or_exit(passgraph::load_scene(folder + "/spheres.scene.json"));
    Picture page = empty_page();
    for (size_t i = 0; i < kModels.size(); ++i) {
        const Model& model = kModels[i];
        const int top = kHead + static_cast<int>(i) * kRow.height;
        put(page, row_of(model, folder, scene, (*context)->loader()), kMargin, top);
        draw_label(page, model.distribution, 18, top + 16, kInk);
        draw_label(page, model.geometry, 18, top + 38, kPale);
        draw_label(page, model.fresnel, 18, top + 60, kPale);
    }
    value_or_exit(passgraph::write_picture(argv[2], page));
}
