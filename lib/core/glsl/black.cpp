// Black in generated texts: what it is stored as, and the condition by which a pass says where it is.
#include <fmt/format.h>

#include "core/glsl/assemble.hpp"

namespace passgraph::glsl {

std::array<float, 4> black_codes(const std::vector<StoredValue>& values)
{
    std::array<float, 4> codes = {0.0f, 0.0f, 0.0f, 1.0f};
    for (const StoredValue& stored : values) {
        const bool has_all = values.size() == 1 ? info(stored.signal).components == 4 : stored.channels.find('a') != std::string::npos;
        if (has_all)
            codes[3] = 0.0f;
    }
    return codes;
}

GlslText skip_text(const PassDeclaration& pass)
{
    GlslText text;
    text.file = pass.file;
    text.first_line = pass.skip_where.line;
    // A comment in the condition ends with its line; what is missing at its end is missing there.
    text.text = fmt::format("bool {}(vec2 uv) {{ return ({}\n#line {}\n); }}\n", kSkips, pass.skip_when, pass.skip_where.line);
    text.globals = pass.body.globals;
    text.globals.emplace_back(kSkips);
    text.includes = pass.body.includes;
    return text;
}

} // namespace passgraph::glsl
