// Chains and joins built-in passes at random.
#include "contract/random_picture_graph.hpp"

#include <random>

#include <fmt/format.h>

#include "support/pass_runner.hpp"

namespace passgraph::test {
namespace {

PassArguments::Setting number(const std::string& name, double value)
{
    PassArguments::Setting setting;
    setting.name = name;
    setting.numbers = {value};
    return setting;
}

PassArguments::Setting item(const std::string& name, const std::string& value)
{
    PassArguments::Setting setting;
    setting.name = name;
    setting.item = value;
    return setting;
}

} // namespace

PictureGraph random_picture_graph(unsigned seed)
{
    std::mt19937 random(seed);
    const auto below = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
    PictureGraph made{Graph(builtin_passes()), {}};
    Graph& graph = made.graph;
    std::vector<AnyImage> images = {graph.picture<Radiance>("first"), graph.picture<Radiance>("second")};
    made.pictures["first"] = noise({37, 23}, 3, 0.0f, 4.0f, seed);
    made.pictures["second"] = noise({37, 23}, 3, 0.0f, 1.0f, seed + 1000);
    const unsigned count = 3 + below(8);
    for (unsigned i = 0; i < count; ++i) {
        const AnyImage image = images[images.size() - 1 - below(static_cast<unsigned>(std::min<size_t>(images.size(), 4)))];
        const AnyImage other = images[below(static_cast<unsigned>(images.size()))];
        PassArguments use;
        use.name = fmt::format("n{}", i);
        use.inputs = {{"image", image}};
        std::string pass;
        switch (below(8)) {
        case 0: pass = "bright"; use.settings = {number("threshold", below(3))}; break;
        case 1: pass = "blur_direction"; use.settings = {item("direction", below(2) == 0 ? "horizontal" : "vertical")}; break;
        case 2: pass = "gaussian_blur"; use.settings = {number("sigma", 1.0 + below(3))}; break;
        case 3: pass = "downsample"; break;
        case 4: pass = "upsample"; break;
        case 5: pass = "vignette"; break;
        case 6: pass = "pixelate"; use.settings = {number("cell", 2.0 + below(5))}; break;
        default: pass = "bloom_combine"; use.inputs = {{"scene", image}, {"bloom", other}}; break;
        }
        const bool is_blur = pass == "blur_direction" || pass == "gaussian_blur";
        images.push_back(graph.add(pass, std::move(use))[is_blur ? "blurred" : "color"]);
    }
    graph.output("out0", images.back());
    const unsigned more = below(3);
    for (unsigned i = 0; i < more; ++i)
        graph.output(fmt::format("out{}", i + 1), images[2 + below(count)]);
    return made;
}

} // namespace passgraph::test
