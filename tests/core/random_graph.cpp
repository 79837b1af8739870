// Random graphs of hand-made passes.
#include "random_graph.hpp"

#include <algorithm>
#include <random>

#include <fmt/format.h>

#include "core_support.hpp"

namespace passgraph::test {
namespace {

class Maker {
public:
    explicit Maker(unsigned seed) : random_(seed) {}

    RandomGraph run()
    {
        auto library = std::make_unique<PassLibrary>();
        const int count = below(22) + 3;
        std::vector<PassPtr> passes;
        for (int i = 0; i < count; ++i) {
            passes.push_back(random_pass(i));
            library->add(passes.back());
        }
        Graph graph(*library);
        std::vector<AnyImage> images = {graph.picture<Radiance>("first"), graph.picture<Radiance>("second")};
        for (const PassPtr& pass : passes) {
            PassArguments arguments;
            for (const InputPort& port : pass->inputs)
                arguments.inputs.push_back({port.name, recent(images)});
            const AddedPass added = graph.add(pass->name, arguments);
            for (const OutputPort& port : pass->outputs)
                images.push_back(added[port.name]);
        }
        const int outputs = below(3) + 1;
        for (int i = 0; i < outputs; ++i)
            graph.output(fmt::format("out{}", i), i == 0 ? images.back() : recent(images));
        CompileOptions options;
        options.picture_extents = {{"first", {64, 32}}, {"second", {64, 32}}};
        options.device = {16384, 4 + below(12), 4 + below(5)};
        return {std::move(library), std::move(graph), options};
    }

private:
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }

    /// Mostly one of the last images, so that chains grow long, but any may be read again.
    AnyImage recent(const std::vector<AnyImage>& images)
    {
        const int count = static_cast<int>(images.size());
        const int back = below(4) == 0 ? below(count) : below(std::min(count, 5));
        return images[static_cast<size_t>(count - 1 - back)];
    }

    Access access()
    {
        switch (below(8)) {
        case 0: return {AccessClass::warp, 0};
        case 1: return {AccessClass::gather, 2};
        case 2: return {};
        case 3: return {AccessClass::size_only, 0};
        default: return {AccessClass::pointwise, 0};
        }
    }

    PassPtr random_pass(int index)
    {
        PassMaker maker(fmt::format("pass{}", index));
        const int inputs = below(3) + 1;
        for (int i = 0; i < inputs; ++i) {
            maker.input(fmt::format("in{}", i), access(), Signal::radiance);
            maker.pass.inputs.back().filter = below(3) == 0 ? Filter::linear : Filter::nearest;
        }
        const Ratio scale = below(6) == 0 ? Ratio{1, 2} : Ratio{};
        const int outputs = below(4) == 0 ? below(3) + 1 : 1;
        for (int i = 0; i < outputs; ++i)
            maker.output(fmt::format("made{}", i), Signal::radiance, scale);
        if (below(10) == 0)
            for (OutputPort& port : maker.pass.outputs)
                port.texels = {{64, 32}};
        return maker.done();
    }

    std::mt19937 random_;
};

} // namespace

RandomGraph random_graph(unsigned seed) { return Maker(seed).run(); }

} // namespace passgraph::test
