// Numbers as people read them.
#include <cmath>

#include <fmt/format.h>

#include "tool/accuracy/report/report.hpp"

namespace passgraph::accuracy {

std::string short_number(double value)
{
    if (value == 0.0)
        return "0";
    const double size = std::abs(value);
    if (size >= 1e-3 && size < 1e4) {
        const int behind = std::max(2 - static_cast<int>(std::floor(std::log10(size))), 0);
        return fmt::format("{:.{}f}", value, behind);
    }
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    return fmt::format("{:.2g}&middot;10<sup>{}</sup>", value / std::pow(10.0, exponent), exponent);
}

std::string error_text(const Metric& metric, double error)
{
    if (error == 0.0)
        return "0";
    const bool is_share = metric.distance == Distance::relative || metric.distance == Distance::is_wrong;
    if (is_share && error >= 1e-4)
        return short_number(100.0 * error) + "&nbsp;%";
    return short_number(error) + (metric.unit.empty() ? "" : "&nbsp;" + (metric.unit == "degrees" ? std::string("&deg;") : metric.unit));
}

} // namespace passgraph::accuracy
