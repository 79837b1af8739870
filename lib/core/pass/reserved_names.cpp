// Names that a port, parameter or helper of a pass may not take.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "passgraph/core/pass_header.hpp"

namespace passgraph {
namespace {

// Keywords of GLSL 1.10 to 4.60 and GLSL ES 1.00 to 3.20, reserved words included.
constexpr std::string_view kKeywords = "active asm atomic_uint attribute bool break buffer bvec2 bvec3 bvec4 case cast "
                                       "centroid class coherent common const continue default "
                                       "discard dmat2 dmat2x2 dmat2x3 dmat2x4 dmat3 dmat3x2 dmat3x3 dmat3x4 dmat4 "
                                       "dmat4x2 dmat4x3 dmat4x4 do double dvec2 dvec3 dvec4 else enum "
                                       "extern external false filter fixed flat float for fvec2 fvec3 fvec4 goto half "
                                       "highp hvec2 hvec3 hvec4 if iimage1D iimage2D iimage3D "
                                       "iimageBuffer iimageCube image1D image2D image3D imageBuffer imageCube in "
                                       "inline inout input int interface invariant isampler1D "
                                       "isampler2D isampler3D isamplerBuffer isamplerCube ivec2 ivec3 ivec4 layout "
                                       "long lowp mat2 mat2x2 mat2x3 mat2x4 mat3 mat3x2 mat3x3 mat3x4 "
                                       "mat4 mat4x2 mat4x3 mat4x4 mediump namespace noinline noperspective out output "
                                       "packed partition patch precise precision public readonly "
                                       "resource restrict return row_major sample sampler1D sampler1DShadow sampler2D "
                                       "sampler2DArray sampler2DMS sampler2DRect sampler2DShadow "
                                       "sampler3D samplerBuffer samplerCube samplerCubeShadow shared short sizeof "
                                       "smooth static struct subroutine superp switch template texture "
                                       "this true typedef uimage2D uint uniform union unsigned usampler1D usampler2D "
                                       "usampler3D usamplerBuffer usamplerCube using uvec2 uvec3 "
                                       "uvec4 varying vec2 vec3 vec4 void volatile while writeonly";

constexpr std::string_view kBuiltins =
    "abs acos acosh all any asin asinh atan atanh bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp "
    "cos cosh cross dFdx "
    "dFdy degrees determinant distance dot equal exp exp2 faceforward findLSB findMSB floatBitsToInt floatBitsToUint "
    "floor fma fract frexp "
    "ftransform fwidth greaterThan greaterThanEqual imulExtended intBitsToFloat interpolateAtCentroid inverse "
    "inversesqrt isinf isnan ldexp "
    "length lessThan lessThanEqual log log2 matrixCompMult max min mix mod modf noise1 noise2 noise3 noise4 normalize "
    "not notEqual outerProduct "
    "packHalf2x16 packSnorm2x16 packUnorm2x16 packUnorm4x8 pow radians reflect refract round roundEven sign sin sinh "
    "smoothstep sqrt step tan "
    "tanh texelFetch texelFetchOffset textureGrad textureLod textureOffset textureProj textureSize transpose trunc "
    "uaddCarry "
    "uintBitsToFloat umulExtended unpackHalf2x16 unpackSnorm2x16 unpackUnorm2x16 unpackUnorm4x8 usubBorrow";

// What generated code gives every pass.
constexpr std::string_view kGenerated =
    "uv pixel pixel_count main view_ray world_from_view view_from_world camera_position view_distance frame_time frame_delta "
    "frame_index frame_is_cut random "
    "light_count light Light lights_have_ends lights_have_cones element_to_view element_normal_to_view element_base_color "
    "element_roughness_metallic element_specular element_emissive element_is_back_facing";

std::set<std::string, std::less<>> words_of(std::string_view list)
{
    std::set<std::string, std::less<>> words;
    size_t start = 0;
    while (start < list.size()) {
        const size_t end = std::min(list.find(' ', start), list.size());
        words.emplace(list.substr(start, end - start));
        start = end + 1;
    }
    return words;
}

bool is_swizzle(std::string_view name)
{
    if (name.empty() || name.size() > 4)
        return false;
    for (const std::string_view set : {"xyzw", "rgba", "stpq"})
        if (std::all_of(name.begin(), name.end(), [&](char c) { return set.find(c) != std::string_view::npos; }))
            return true;
    return false;
}

} // namespace

std::string why_reserved(std::string_view name)
{
    static const auto keywords = words_of(kKeywords);
    static const auto builtins = words_of(kBuiltins);
    static const auto generated = words_of(kGenerated);
    if (keywords.contains(name))
        return "it is a GLSL keyword";
    if (builtins.contains(name))
        return "it is a GLSL builtin function";
    if (generated.contains(name))
        return "generated code gives every pass a name like it";
    if (is_swizzle(name))
        return "it reads as a swizzle";
    if (name.starts_with("gl_") || name.starts_with("passgraph_"))
        return "names that start so belong to others";
    if (name.find("__") != std::string_view::npos)
        return "GLSL reserves names with two underscores";
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (name.empty() || !is_letter(name.front()) ||
        !std::all_of(name.begin(), name.end(), [&](char c) { return is_letter(c) || is_digit(c); }))
        return "names are letters, digits and underscores, and start with no digit";
    return "";
}

} // namespace passgraph
