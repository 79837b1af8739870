// Chooses scenes and fills inputs.
#include "tool/contract/feeds.hpp"

#include <algorithm>

#include "tool/contract/scenes.hpp"

namespace passgraph::tool::contract {

const std::vector<const Scene*>& scenes_for(const PassDeclaration& pass)
{
    static const Scene unlit = unlit_scene();
    static const Scene lit = lit_scene();
    static const Scene hard = hard_scene();
    static const Scene meshes = hard_meshes();
    static const std::vector<const Scene*> none = {nullptr};
    static const std::vector<const Scene*> lamps = {&lit, &hard, &unlit};
    static const std::vector<const Scene*> shapes = {&meshes};
    static const std::vector<const Scene*> camera = {&lit};
    const bool has_scene =
        std::any_of(pass.inputs.begin(), pass.inputs.end(), [](const InputPort& port) { return port.over == Over::scene; });
    if (has_scene)
        return shapes;
    // A composite's reads are those of the passes inside; a scene does no harm where none is read.
    return pass.reads.lights || pass.composite ? lamps : pass.reads.camera || pass.reads.frame ? camera : none;
}

Feed fill_inputs(const Subject& subject, const StageOptions& options, Filling filling, std::mt19937& random)
{
    Feed feed;
    const std::mt19937 start = random;
    for (const InputPort& port : subject.pass->inputs) {
        if (port.over == Over::scene)
            continue;
        if (filling == Filling::alike)
            random = start; // inputs of one signal and extent become one picture
        const Signal signal = signal_of(port.signal, options);
        feed[port.name] =
            picture_of(filling, signal, span_of(subject.contract().domain, port.name, signal), extent_of(port, options), random);
    }
    return feed;
}

} // namespace passgraph::tool::contract
