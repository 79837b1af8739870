// Shapes on a page, kept apart from how they are written: as SVG, or as pixels.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <passgraph/core/picture.hpp>

namespace passgraph::accuracy {

/// sRGB, 0xRRGGBB.
using Ink = unsigned;

struct LineShape {
    double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
    Ink ink = 0;
    double width = 1.0;
};

struct DiscShape {
    double x = 0.0, y = 0.0, radius = 0.0;
    Ink fill = 0;
    Ink rim = 0;
    double rim_width = 0.0;
};

struct BoxShape {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    Ink fill = 0;
};

struct TextShape {
    enum class Anchor { start, middle, end };
    double x = 0.0, y = 0.0; ///< of the baseline
    std::string text{};
    Ink ink = 0;
    double size = 12.0;
    Anchor anchor = Anchor::start;
    bool is_bold = false;
};

using Shape = std::variant<LineShape, DiscShape, BoxShape, TextShape>;

/// Shape    `width` x `height` units, y downwards; later shapes cover earlier ones.
struct Drawing {
    double width = 0.0;
    double height = 0.0;
    std::string title{}; ///< for those who do not see it
    std::vector<Shape> shapes{};
};

std::string to_svg(const Drawing& drawing);

/// The drawing as display codes, `scale` pixels per unit, edges smooth. Text is in stb_easy_font's letters.
Picture to_picture(const Drawing& drawing, double scale);

/// `&`, `<`, `>` and quotes as HTML and XML write them.
std::string escaped(const std::string& text);

/// How wide a text of this size is, about: for placing labels.
double text_width(const std::string& text, double size);

} // namespace passgraph::accuracy
