// Textures: what each format is in OpenGL, creation, filling, and the samplers they are read through.
#pragma once

#include <array>
#include <map>
#include <tuple>

#include <passgraph/core/codec.hpp>
#include <passgraph/core/declaration.hpp>

#include "gl/cube_filter.hpp"
#include "gl/error_watch.hpp"
#include "gl/state.hpp"

namespace passgraph::gl {

/// What is needed to create and fill textures.
struct Upload {
    Driver& driver;
    State& state;
    ErrorWatch& watch;
    bool scrubs_imports = true; ///< as RendererOptions
    bool is_poisoned = false;
};

GLenum internal_format(Format format);

/// A texture of undefined contents and one level, to be drawn into. Poisoned, it holds NaN, or 1 in formats without one.
TextureObject create_target(Upload& upload, Format format, Extent extent);

/// A binary32 RGBA texture of one level or all of them.
TextureObject create_picture(Upload& upload, Extent extent, bool has_levels);
/// Shape    `rgba` has 4 channels and the texture's extent.
void fill_picture(Upload& upload, GLuint texture, const Picture& rgba, bool has_levels);

/// Gives a texture of one level all of them.
void add_levels(Upload& upload, GLuint texture);

/// A cube map, and the irradiance under it as a sky.
struct Cube {
    TextureObject texture;
    Harmonics harmonics{};
};

/// A cube's levels as they are uploaded, and the irradiance under it: most of what a cube costs, and no GL.
struct CubeLevels {
    struct Level {
        int size = 0;                                    ///< of a face, in texels
        std::array<std::vector<std::uint16_t>, 6> faces; ///< RGBA as binary16, so that a driver has nothing to convert
    };
    std::vector<Level> levels;
    Harmonics harmonics{};
};
CubeLevels cube_levels(const CubeFaces& faces);
Cube upload_cube(Upload& upload, const CubeLevels& cube);

/// A binary16 cube map whose levels are filtered for rough reflections (cube_filter.hpp).
/// Shape    six square faces of 4 channels, row 0 first in OpenGL's orientation.
Cube create_cube(Upload& upload, const CubeFaces& faces);

/// A texture of one level whose texels are uploaded as they lie: RGBA of bytes, or of halves for rgba16f.
TextureObject create_filled(Upload& upload, Format format, Extent extent, const void* texels);

/// The host's picture as values of a signal in RGBA: guarded; missing components 0, alpha 1, grey spread over RGB.
///
/// Shape    same extent, 4 channels.
/// Range    any floats; non-finite ones are replaced by the signal's guard, unless it is left out.
/// Errors   none.
Picture to_rgba(const Picture& picture, Signal signal, bool is_guarded = true);

/// Sampler objects, one per way of reading, made while a plan or a scene is taken in.
class Samplers {
public:
    explicit Samplers(Driver& driver) : driver_(driver) {}
    GLuint get(Filter filter, AddressMode wrap_u, AddressMode wrap_v, bool has_levels);

private:
    using Key = std::tuple<Filter, AddressMode, AddressMode, bool>;
    Driver& driver_;
    std::map<Key, SamplerObject> samplers_;
};

} // namespace passgraph::gl
