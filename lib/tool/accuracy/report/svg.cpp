// Drawings as SVG.
#include <fmt/format.h>

#include "tool/accuracy/report/drawing.hpp"

namespace passgraph::accuracy {
namespace {

struct Writer {
    std::string text;

    void operator()(const LineShape& line)
    {
        text += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="#{:06x}" stroke-width="{:g}" stroke-linecap="round"/>)",
                            line.x0, line.y0, line.x1, line.y1, line.ink, line.width);
    }
    void operator()(const DiscShape& disc)
    {
        text += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:g}" fill="#{:06x}" stroke="#{:06x}" stroke-width="{:g}"/>)",
                            disc.x, disc.y, disc.radius, disc.fill, disc.rim, disc.rim_width);
    }
    void operator()(const BoxShape& box)
    {
        text += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="#{:06x}"/>)", box.x, box.y, box.width,
                            box.height, box.fill);
    }
    void operator()(const TextShape& shape)
    {
        static constexpr const char* kAnchors[] = {"start", "middle", "end"};
        text += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{:g}" text-anchor="{}" fill="#{:06x}"{}>{}</text>)", shape.x,
                            shape.y, shape.size, kAnchors[static_cast<size_t>(shape.anchor)], shape.ink,
                            shape.is_bold ? " font-weight=\"600\"" : "", escaped(shape.text));
    }
};

} // namespace

std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&': safe += "&amp;"; break;
        case '<': safe += "&lt;"; break;
        case '>': safe += "&gt;"; break;
        case '"': safe += "&quot;"; break;
        default: safe += c;
        }
    }
    return safe;
}

std::string to_svg(const Drawing& drawing)
{
    Writer writer;
    writer.text = fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:g} {:g}" role="img" font-family="system-ui, sans-serif"><title>{}</title>)",
                              drawing.width, drawing.height, escaped(drawing.title));
    for (const Shape& shape : drawing.shapes) {
        std::visit(writer, shape);
        writer.text += '\n';
    }
    return writer.text + "</svg>\n";
}

double text_width(const std::string& text, double size) { return 0.56 * size * static_cast<double>(text.size()); }

} // namespace passgraph::accuracy
