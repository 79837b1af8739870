// The photo stack in C++: any picture in, the same picture with glow, film curve and darker corners out.
#include <cstdio>

#include <passgraph/context/context.hpp>
#include <passgraph/core/compile.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/image/image_file.hpp>
#include <passgraph/passes.hpp>

namespace pass = passgraph::passes;
using passgraph::Radiance;

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

int main(int argc, char** argv)
{
    if (argc != 3)
        return std::fputs("usage: photo_stack IN OUT\n", stderr), 2;
    const auto photo = value_or_exit(passgraph::read_picture(argv[1], passgraph::Transfer::decode_srgb));

    passgraph::Graph graph;
    const auto input  = graph.picture<Radiance>("photo");
    const auto bright = graph.add(pass::Bright{.threshold = 0.7f, .knee = 0.6f}, {.image = input});
    const auto half   = graph.add(pass::Downsample<Radiance>{}, {.image = bright.color});
    const auto glow   = graph.add(pass::GaussianBlur<Radiance>{.sigma = 4.0f}, {.image = half.color});
    const auto film   = graph.add(pass::BloomCombine{.strength = 0.6f}, {.scene = input, .bloom = glow.blurred});
    const auto shown  = graph.add(pass::ToneMap{.exposure = 3.0f}, {.image = film.color});
    graph.output("color", graph.add(pass::Vignette<passgraph::Display>{.amount = 0.6f}, {.image = shown.color}).color);

    const auto context = passgraph::create_headless_context();
    if (!context)
        return std::fprintf(stderr, "%s\n", context.error().message.c_str()), 3;
    const auto plan = value_or_exit(compile(graph, {.extent = photo.extent, .picture_extents = {{"photo", photo.extent}}}));
    auto renderer = value_or_exit(passgraph::Renderer::create(plan, {.loader = (*context)->loader()}));
    value_or_exit(renderer.import_picture("photo", photo));
    value_or_exit(renderer.render());
    value_or_exit(passgraph::write_picture(argv[2], value_or_exit(renderer.read("color"))));
}
