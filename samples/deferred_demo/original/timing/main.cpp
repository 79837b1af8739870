// How long the original's frame takes on this machine, beside ours in the same run.
//
// A reconstruction: the original's program is not here. Its targets, its passes, its taps and its habits are rebuilt from
// its description (see ../../ORIGINAL.md), over our own scene; what it drew beside them, such as its sky box, is left out.
//
//   original_timing GRAPH.json SCENE.json [WIDTHxHEIGHT] [ROUNDS] [PICTURE.png]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <passgraph/context/context.hpp>
#include <passgraph/core/baked_passes.hpp>
#include <passgraph/core/compile.hpp>
#include <passgraph/core/graph_file.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/image/image_file.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "frame.hpp"

using namespace passgraph;

namespace {

template <class T> T expect(Result<T> result)
{
    if (!result) {
        std::fputs(to_text(result.error()).c_str(), stderr);
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

std::unique_ptr<Context> context()
{
    auto made = create_headless_context();
    if (!made) {
        std::fprintf(stderr, "%s\n  hint: %s\n", made.error().message.c_str(), made.error().hint.c_str());
        std::exit(3);
    }
    return std::move(*made);
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// One frame of ours, the camera a hair further on, so that everything is drawn again.
double our_frame(Renderer& renderer, Camera& camera, int index, void (*finish)())
{
    camera.position.x += index % 2 ? 1e-3 : -1e-3;
    finish();
    const auto start = std::chrono::steady_clock::now();
    expect(renderer.render({.time = index / 60.0, .index = index, .camera = &camera}));
    finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void write_picture_of(original::Frame& frame, Extent extent, const std::string& file)
{
    Picture picture(extent, 3);
    const std::vector<unsigned char> rgba = frame.pixels();
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 < 3)
            picture.texels[i / 4 * 3 + i % 4] = static_cast<float>(rgba[i]) / 255.0f;
    expect(write_picture(file, picture));
}

} // namespace

int main(int count, char** words)
{
    if (count < 3) {
        std::fprintf(stderr, "original_timing GRAPH.json SCENE.json [WIDTHxHEIGHT] [ROUNDS] [PICTURE.png]\n");
        return 2;
    }
    Extent extent{1280, 720};
    if (count > 3 && std::sscanf(words[3], "%dx%d", &extent.width, &extent.height) != 2)
        return 2;
    const int rounds = count > 4 ? std::max(1, std::atoi(words[4])) : 15;
    const Scene scene = expect(load_scene(words[2]));
    Camera camera = scene.camera;

    const std::unique_ptr<Context> their_context = context();
    original::Frame theirs(their_context->loader(), scene, extent);
    const std::unique_ptr<Context> our_context = context();
    CompileOptions options;
    options.extent = extent;
    const Graph graph = expect(load_graph(words[1], builtin_passes()));
    Renderer ours = expect(Renderer::create(expect(compile(graph, options)), {.loader = our_context->loader()}));
    expect(ours.set_scene(scene));
    const auto finish = reinterpret_cast<void (*)()>(our_context->loader()("glFinish"));

    std::vector<std::vector<double>> passes(original::kPasses.size() + 1);
    std::vector<double> our_times;
    std::vector<double> ratios;
    constexpr int kWarmUp = 2; // drivers compile on the first draws
    for (int round = -kWarmUp; round < rounds; ++round) {
        their_context->make_current();
        const original::PassTimes times = theirs.draw();
        double sum = 0.0;
        for (const double time : times)
            sum += time;
        our_context->make_current();
        const double our_time = our_frame(ours, camera, round + kWarmUp, finish);
        if (round < 0)
            continue;
        for (size_t i = 0; i < times.size(); ++i)
            passes[i].push_back(times[i]);
        passes.back().push_back(sum);
        our_times.push_back(our_time);
        ratios.push_back(our_time / sum);
    }
    their_context->make_current();
    std::printf("%s, %d x %d, %d rounds of both in turn, medians in ms\n", theirs.device().c_str(), extent.width,
                extent.height, rounds);
    std::printf("the original, reconstructed: %zu vertices, %.0f %% sky\n", theirs.vertices(), 100.0 * theirs.sky_share());
    for (size_t i = 0; i < original::kPasses.size(); ++i)
        std::printf("  %-22s %7.2f\n", original::kPasses[i], median(passes[i]));
    std::printf("  %-22s %7.2f\n", "frame", median(passes.back()));
    std::printf("ours, %s\n  %-22s %7.2f   %.2f of the original's\n", words[1], "frame", median(our_times), median(ratios));
    if (count > 5)
        write_picture_of(theirs, extent, words[5]);
    our_context->make_current();
    return 0;
}
