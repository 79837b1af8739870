// Creation and filling of textures and samplers.
#include "gl/textures.hpp"

#include <algorithm>
#include <cassert>

#include <glm/gtc/packing.hpp>
#include <limits>
#include <vector>

namespace passgraph::gl {
namespace {

struct FormatRow {
    Format format;
    GLenum internal;
};

constexpr FormatRow kFormats[] = {
    {Format::r8, GL_R8},
    {Format::rg8, GL_RG8},
    {Format::rgba8, GL_RGBA8},
    {Format::srgb8_a8, GL_SRGB8_ALPHA8},
    {Format::rgb10_a2, GL_RGB10_A2},
    {Format::rg16, GL_RG16},
    {Format::rgba16, GL_RGBA16},
    {Format::r16f, GL_R16F},
    {Format::rg16f, GL_RG16F},
    {Format::rgba16f, GL_RGBA16F},
    {Format::r11f_g11f_b10f, GL_R11F_G11F_B10F},
    {Format::r32f, GL_R32F},
    {Format::rg32f, GL_RG32F},
    {Format::rgba32f, GL_RGBA32F},
    {Format::depth24, GL_DEPTH_COMPONENT24},
    {Format::depth32f, GL_DEPTH_COMPONENT32F},
};

constexpr GLint kAllLevels = 1000; // OpenGL's own default

GLint wrap_name(AddressMode mode)
{
    switch (mode) {
    case AddressMode::clamp: return GL_CLAMP_TO_EDGE;
    case AddressMode::mirror: return GL_MIRRORED_REPEAT;
    case AddressMode::repeat: return GL_REPEAT;
    }
    return GL_CLAMP_TO_EDGE;
}

/// Complete and unfiltered for whoever samples it without a sampler object.
void set_reading(const Functions& gl, GLenum target, bool has_levels)
{
    gl.TexParameteri(target, GL_TEXTURE_BASE_LEVEL, 0);
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, has_levels ? kAllLevels : 0);
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

bool has_nan(Format format)
{
    switch (format) {
    case Format::r16f:
    case Format::rg16f:
    case Format::rgba16f:
    case Format::r11f_g11f_b10f:
    case Format::r32f:
    case Format::rg32f:
    case Format::rgba32f: return true;
    default: return false; // a depth of NaN is clamped by some drivers and kept by others
    }
}

float component(const Picture& picture, const float* texel, int index, int components)
{
    const bool is_alpha = index == 3;
    const bool is_grey = picture.channels <= 2 && components >= 3;
    if (is_grey && picture.channels == 1)
        return is_alpha ? 1.0f : texel[0];
    if (is_grey && components == 4) // grey and alpha
        return is_alpha ? texel[1] : texel[0];
    if (index < picture.channels && index < components)
        return texel[index];
    return is_alpha ? 1.0f : 0.0f;
}

} // namespace

GLenum internal_format(Format format)
{
    const FormatRow& row = kFormats[static_cast<size_t>(format)];
    assert(row.format == format);
    return row.internal;
}

TextureObject create_target(Upload& upload, Format format, Extent extent)
{
    std::vector<float> poison;
    if (upload.is_poisoned)
        poison.assign(static_cast<size_t>(extent.width) * static_cast<size_t>(extent.height) * (is_depth(format) ? 1 : 4),
                      has_nan(format) ? std::numeric_limits<float>::quiet_NaN() : 1.0f);
    TextureObject texture(upload.driver);
    upload.state.edit_texture(GL_TEXTURE_2D, texture.id());
    const Functions& gl = upload.driver.gl;
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format(format)), extent.width, extent.height, 0,
                  is_depth(format) ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, upload.is_poisoned ? poison.data() : nullptr);
    set_reading(gl, GL_TEXTURE_2D, false);
    return texture;
}

TextureObject create_picture(Upload& upload, Extent extent, bool has_levels)
{
    TextureObject texture(upload.driver);
    upload.state.edit_texture(GL_TEXTURE_2D, texture.id());
    const Functions& gl = upload.driver.gl;
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, extent.width, extent.height, 0, GL_RGBA, GL_FLOAT, nullptr);
    set_reading(gl, GL_TEXTURE_2D, has_levels);
    return texture;
}

void fill_picture(Upload& upload, GLuint texture, const Picture& rgba, bool has_levels)
{
    assert(rgba.channels == 4);
    const Functions& gl = upload.driver.gl;
    upload.state.edit_texture(GL_TEXTURE_2D, texture);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, rgba.extent.width, rgba.extent.height, GL_RGBA, GL_FLOAT,
                     rgba.texels.data());
    if (has_levels)
        gl.GenerateMipmap(GL_TEXTURE_2D);
}

void add_levels(Upload& upload, GLuint texture)
{
    upload.state.edit_texture(GL_TEXTURE_2D, texture);
    upload.driver.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, kAllLevels);
    upload.driver.gl.GenerateMipmap(GL_TEXTURE_2D);
}

CubeLevels cube_levels(const CubeFaces& faces)
{
    const auto packed = [](CubeFaces of_level) {
        CubeLevels::Level level{of_level[0].extent.width, {}};
        of_level = rounded_to_half(std::move(of_level)); // packing rounds nothing then
        for (size_t i = 0; i < of_level.size(); ++i) {
            level.faces[i].resize(of_level[i].texels.size());
            std::transform(of_level[i].texels.begin(), of_level[i].texels.end(), level.faces[i].begin(),
                           [](float value) { return glm::packHalf1x16(value); });
        }
        return level;
    };
    CubeLevels cube{{packed(faces)}, irradiance_harmonics(faces)};
    for (CubeFaces& rough : prefiltered(faces))
        cube.levels.push_back(packed(std::move(rough)));
    return cube;
}

Cube upload_cube(Upload& upload, const CubeLevels& levels)
{
    Cube cube{TextureObject(upload.driver), levels.harmonics};
    upload.state.edit_texture(GL_TEXTURE_CUBE_MAP, cube.texture.id());
    const Functions& gl = upload.driver.gl;
    for (size_t level = 0; level < levels.levels.size(); ++level) {
        const auto& [size, of_level] = levels.levels[level];
        for (size_t i = 0; i < of_level.size(); ++i)
            gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), static_cast<GLint>(level), GL_RGBA16F, size,
                          size, 0, GL_RGBA, GL_HALF_FLOAT, of_level[i].data());
    }
    set_reading(gl, GL_TEXTURE_CUBE_MAP, true);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.levels.size()) - 1);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    return cube;
}

Cube create_cube(Upload& upload, const CubeFaces& faces) { return upload_cube(upload, cube_levels(faces)); }

TextureObject create_filled(Upload& upload, Format format, Extent extent, const void* texels)
{
    TextureObject texture(upload.driver);
    upload.state.edit_texture(GL_TEXTURE_2D, texture.id());
    const Functions& gl = upload.driver.gl;
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format(format)), extent.width, extent.height, 0, GL_RGBA,
                  format == Format::rgba16f ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, texels);
    set_reading(gl, GL_TEXTURE_2D, false);
    return texture;
}

Picture to_rgba(const Picture& picture, Signal signal, bool is_guarded)
{
    const int components = info(signal).components;
    Picture values(picture.extent, components);
    const size_t texels = static_cast<size_t>(picture.extent.width) * static_cast<size_t>(picture.extent.height);
    for (size_t i = 0; i < texels; ++i)
        for (int c = 0; c < components; ++c)
            values.texels[i * static_cast<size_t>(components) + static_cast<size_t>(c)] =
                component(picture, &picture.texels[i * static_cast<size_t>(picture.channels)], c, components);
    if (is_guarded)
        apply_guard(values, signal);
    if (components == 4)
        return values;
    Picture rgba(picture.extent, 4);
    for (size_t i = 0; i < texels; ++i) {
        std::copy_n(&values.texels[i * static_cast<size_t>(components)], components, &rgba.texels[i * 4]);
        rgba.texels[i * 4 + 3] = 1.0f;
    }
    return rgba;
}

GLuint Samplers::get(Filter filter, AddressMode wrap_u, AddressMode wrap_v, bool has_levels)
{
    SamplerObject& sampler = samplers_[Key{filter, wrap_u, wrap_v, has_levels}];
    if (sampler)
        return sampler.id();
    sampler = SamplerObject(driver_);
    const Functions& gl = driver_.gl;
    const bool is_linear = filter == Filter::linear;
    const GLint plain = is_linear ? GL_LINEAR : GL_NEAREST;
    const GLint with_levels = is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
    gl.SamplerParameteri(sampler.id(), GL_TEXTURE_MAG_FILTER, plain);
    gl.SamplerParameteri(sampler.id(), GL_TEXTURE_MIN_FILTER, has_levels ? with_levels : plain);
    gl.SamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_S, wrap_name(wrap_u));
    gl.SamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_T, wrap_name(wrap_v));
    gl.SamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_R, wrap_name(wrap_v));
    return sampler.id();
}

} // namespace passgraph::gl
