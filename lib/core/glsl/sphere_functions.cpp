// GLSL of what a pass asks of a cube map beside its texels: its levels and the irradiance under it.
#include <fmt/format.h>

#include "core/glsl/assemble.hpp"
#include "passgraph/core/glsl_interface.hpp"

namespace passgraph::glsl {

std::string harmonics_name(std::string_view sampler) { return fmt::format("{}_harmonics", sampler); }

std::string_view sphere_functions()
{
    // top_level is gl's prefiltered_levels() - 1; log2 of a power of two may come out an ulp low.
    return R"(float passgraph_top_level(int size)
{
    float levels = floor(log2(float(size)) + 1e-4);
    return min(levels, max(levels - 2.0, 3.0));
}
// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", eq. 13, its constants folded
// into the coefficients. Nine harmonics may go below 0 where a narrow light sets.
vec3 passgraph_irradiance(vec3 c[9], vec3 d)
{
    vec3 e = c[0] + c[1] * d.y + c[2] * d.z + c[3] * d.x + c[4] * (d.x * d.y) + c[5] * (d.y * d.z) +
             c[6] * (d.z * d.z) + c[7] * (d.x * d.z) + c[8] * (d.x * d.x - d.y * d.y);
    return max(e, vec3(0.0));
}
)";
}

} // namespace passgraph::glsl
