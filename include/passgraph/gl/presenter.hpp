// Shows an image of any signal as colors: in a window, as a small copy, or as a picture to be saved.
#pragma once

#include <memory>
#include <vector>

#include <passgraph/core/codec.hpp>
#include <passgraph/core/error.hpp>
#include <passgraph/gl/renderer.hpp>

namespace passgraph {

/// An image to be looked at: a plan's output and the texture that holds it.
///
/// Values come to a scale of their signal first: radiance x / (1 + x), depth 1 / d (in proportion to the distance; the distance itself where that is stored), a
/// normal (n + 1) / 2, velocity a share of 64 texels, everything else as it is. There `low` is black and `high` white.
struct ShownImage {
    std::vector<StoredCodes> codes; ///< one to four, of one extent
    Signal signal = Signal::display;
    Codec codec;
    Vec3 low{0.0f, 0.0f, 0.0f};
    Vec3 high{1.0f, 1.0f, 1.0f};

    Extent extent() const { return codes.front().texture.extent; }
};

/// Draws images for people. It keeps a program for each signal and codec it has met.
class Presenter {
public:
    /// Errors   gl_too_old, gl_function_missing.
    static Result<Presenter> create(GlLoader loader);
    Presenter(Presenter&&) noexcept;
    Presenter& operator=(Presenter&&) noexcept;
    ~Presenter(); ///< needs the same context current

    /// Fills the default framebuffer: the image as large as fits with its aspect kept, the rest dark.
    /// Errors   gl_error.
    Result<void> show(const ShownImage& image, Extent window);
    /// Fills the default framebuffer with the color beside images.
    Result<void> clear();
    /// Where `show` puts an image in a window: from the bottom left, in pixels.
    struct Place {
        int x = 0;
        int y = 0;
        Extent extent;
    };
    static Place place_of(Extent image, Extent window);

    /// A copy as an 8-bit texture for a user interface, first row at the bottom; `index` names it, and a later call replaces it.
    /// Errors   gl_error, out_of_memory.
    Result<HostTexture> keep(size_t index, const ShownImage& image, Extent extent);

    /// The colors that `show` shows. Shape: the image's extent, 3 channels. Errors: gl_error.
    Result<Picture> read(const ShownImage& image);

private:
    class Impl;
    explicit Presenter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace passgraph
