// Turns baked files into a library.
#include "passgraph/core/baked_passes.hpp"

#include <cassert>
#include <string_view>

#include "passgraph/core/graph_file.hpp"
#include "passgraph/core/pass_header.hpp"

namespace passgraph {

PassLibrary unbake(std::span<const BakedFile> passes, std::span<const BakedFile> commons,
                   std::span<const BakedFile> composites)
{
    const IncludeFinder find_include = [&](std::string_view name) -> std::optional<IncludedFile> {
        for (const BakedFile& file : commons)
            if (std::string_view(file.path).ends_with(std::string("/common/") + std::string(name)))
                return IncludedFile{file.path, file.text};
        return std::nullopt;
    };
    PassLibrary library;
    for (const BakedFile& file : passes) {
        auto pass = read_pass_header(file.text, file.path, file.family, find_include);
        assert(pass && "a baked pass was checked by the build");
        [[maybe_unused]] const auto applied = apply_derived(*pass, file.derived);
        assert(applied && "derived by the build");
        library.add(std::make_shared<const PassDeclaration>(std::move(*pass)));
    }
    for (const BakedFile& file : composites) { // in the order in which they may name each other
        auto description = read_graph_description(file.text, file.path);
        assert(description && "a baked composite was checked by the build");
        auto declared =
            declare_composite(std::make_shared<const GraphDescription>(std::move(*description)), file.family, library);
        assert(declared && "a baked composite was checked by the build");
        library.add(*declared);
    }
    return library;
}

} // namespace passgraph
