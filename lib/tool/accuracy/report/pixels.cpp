// Drawings as pixels: each shape's coverage of a pixel from its distance to the pixel's center.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_easy_font.h>
#pragma GCC diagnostic pop

#include "tool/accuracy/report/drawing.hpp"

namespace passgraph::accuracy {
namespace {

constexpr double kLetterHeight = 8.5; // stb_easy_font's units from baseline to the top of a line, about

class Canvas {
public:
    Canvas(const Drawing& drawing, double scale)
        : scale_(scale), picture_({static_cast<int>(std::lround(drawing.width * scale)), static_cast<int>(std::lround(drawing.height * scale))}, 3)
    {
        std::fill(picture_.texels.begin(), picture_.texels.end(), 1.0f);
    }

    void operator()(const LineShape& line)
    {
        const double dx = line.x1 - line.x0;
        const double dy = line.y1 - line.y0;
        const double squared = std::max(dx * dx + dy * dy, 1e-12);
        const double reach = 0.5 * line.width;
        paint(std::min(line.x0, line.x1) - reach, std::min(line.y0, line.y1) - reach, std::max(line.x0, line.x1) + reach,
              std::max(line.y0, line.y1) + reach, line.ink, [&](double x, double y) {
                  const double along = std::clamp(((x - line.x0) * dx + (y - line.y0) * dy) / squared, 0.0, 1.0);
                  return std::hypot(x - line.x0 - along * dx, y - line.y0 - along * dy) - reach;
              });
    }
    void operator()(const DiscShape& disc)
    {
        const double outer = disc.radius + 0.5 * disc.rim_width;
        const auto ring = [&](double radius, Ink ink) {
            paint(disc.x - radius, disc.y - radius, disc.x + radius, disc.y + radius, ink,
                  [&](double x, double y) { return std::hypot(x - disc.x, y - disc.y) - radius; });
        };
        if (disc.rim_width > 0.0)
            ring(outer, disc.rim);
        ring(disc.radius - 0.5 * disc.rim_width, disc.fill);
    }
    void operator()(const BoxShape& box) { paint_box(box.x, box.y, box.width, box.height, box.fill); }
    void operator()(const TextShape& text)
    {
        std::string letters = text.text;
        const double unit = text.size / 11.0;
        const double wide = unit * stb_easy_font_width(letters.data());
        const double left = text.anchor == TextShape::Anchor::start    ? text.x
                            : text.anchor == TextShape::Anchor::middle ? text.x - 0.5 * wide
                                                                       : text.x - wide;
        struct Corner {
            float x, y, z;
            unsigned char color[4];
        };
        std::vector<Corner> corners(letters.size() * 4 * 20 + 4); // a letter is at most 20 quads
        const int quads = stb_easy_font_print(0.0f, 0.0f, letters.data(), nullptr, corners.data(), static_cast<int>(corners.size() * sizeof(Corner)));
        for (int i = 0; i < quads; ++i) {
            const Corner& low = corners[static_cast<size_t>(4 * i)];
            const Corner& high = corners[static_cast<size_t>(4 * i + 2)];
            const double bold = text.is_bold ? 0.35 : 0.0;
            paint_box(left + unit * low.x, text.y + unit * (low.y - kLetterHeight), unit * (high.x - low.x + bold), unit * (high.y - low.y), text.ink);
        }
    }

    Picture take() { return std::move(picture_); }

private:
    /// `distance` to the shape in units, negative inside, is asked at pixel centers of the box.
    template <class Distance>
    void paint(double x0, double y0, double x1, double y1, Ink ink, const Distance& distance)
    {
        for_pixels(x0, y0, x1, y1, [&](int x, int y) {
            const double off = distance((x + 0.5) / scale_, (y + 0.5) / scale_) * scale_;
            blend(x, y, ink, std::clamp(0.5 - off, 0.0, 1.0));
        });
    }
    void paint_box(double x, double y, double width, double height, Ink ink)
    {
        const auto covered = [&](double low, double high, int pixel) {
            return std::clamp(std::min(high * scale_, pixel + 1.0) - std::max(low * scale_, static_cast<double>(pixel)), 0.0, 1.0);
        };
        for_pixels(x, y, x + width, y + height, [&](int px, int py) { blend(px, py, ink, covered(x, x + width, px) * covered(y, y + height, py)); });
    }
    template <class Visit>
    void for_pixels(double x0, double y0, double x1, double y1, const Visit& visit)
    {
        const auto first = [&](double at) { return std::max(static_cast<int>(std::floor(at * scale_)) - 1, 0); };
        const auto last = [&](double at, int size) { return std::min(static_cast<int>(std::ceil(at * scale_)) + 1, size - 1); };
        for (int y = first(y0); y <= last(y1, picture_.extent.height); ++y)
            for (int x = first(x0); x <= last(x1, picture_.extent.width); ++x)
                visit(x, y);
    }
    void blend(int x, int y, Ink ink, double coverage)
    {
        const int row = picture_.extent.height - 1 - y; // a picture's first row is its lowest
        for (int c = 0; c < 3; ++c) {
            float& channel = picture_.at(x, row, c);
            const double wanted = static_cast<double>((ink >> (16 - 8 * c)) & 255u) / 255.0;
            channel += static_cast<float>(coverage * (wanted - channel));
        }
    }

    double scale_;
    Picture picture_;
};

} // namespace

Picture to_picture(const Drawing& drawing, double scale)
{
    Canvas canvas(drawing, scale);
    for (const Shape& shape : drawing.shapes)
        std::visit(canvas, shape);
    return canvas.take();
}

} // namespace passgraph::accuracy
