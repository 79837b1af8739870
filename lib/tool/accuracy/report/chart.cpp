// Draws the chart of a ladder.
#include "tool/accuracy/report/chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace passgraph::accuracy {
namespace {

constexpr double kWidth = 760.0;
constexpr double kHeight = 400.0;
constexpr double kLeft = 78.0;
constexpr double kRight = kWidth - 24.0;
constexpr double kTop = 22.0;
constexpr double kBottom = kHeight - 54.0;

constexpr Ink kAxis = 0x5b6472;
constexpr Ink kGrid = 0xe6e9ee;
constexpr Ink kFront = 0x1f5fbf;
constexpr Ink kDominated = 0xb3b9c3;
constexpr Ink kText = 0x1d2430;
constexpr Ink kFaint = 0x8a93a1;
constexpr Ink kPaper = 0xffffff;

/// A logarithmic scale over a length of the page.
struct Scale {
    double low = 0.0; ///< decimal logarithms
    double high = 1.0;
    double from = 0.0;
    double to = 1.0;
    double at(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

struct Box {
    double x0, y0, x1, y1;
};

std::string power_text(int exponent)
{
    if (exponent >= -2 && exponent <= 3)
        return fmt::format("{:g}", std::pow(10.0, exponent));
    return fmt::format("1e{}", exponent);
}

class Chart {
public:
    explicit Chart(const MeasuredLadder& ladder) : ladder_(ladder)
    {
        drawing_ = {kWidth, kHeight, fmt::format("{}: time against error of {} rungs", ladder.ladder->title, ladder.rungs.size()), {}};
        choose_scales();
    }

    Drawing draw()
    {
        drawing_.shapes.emplace_back(BoxShape{0.0, 0.0, kWidth, kHeight, kPaper});
        draw_axes();
        draw_front();
        for (const MeasuredRung& rung : ladder_.rungs)
            draw_point(rung);
        for (const MeasuredRung& rung : ladder_.rungs)
            draw_label(rung);
        return std::move(drawing_);
    }

private:
    void choose_scales()
    {
        double fastest = 1e300, slowest = 0.0, least = 1e300, most = 0.0;
        for (const MeasuredRung& rung : ladder_.rungs) {
            fastest = std::min(fastest, rung.ms.interval.low);
            slowest = std::max(slowest, rung.ms.interval.high);
            has_zero_ = has_zero_ || rung.deviation.error <= 0.0;
            if (rung.deviation.error > 0.0) {
                least = std::min(least, rung.deviation.error);
                most = std::max(most, rung.deviation.error);
            }
        }
        if (most <= 0.0)
            least = most = 1.0;
        const double middle = 0.5 * (std::log10(fastest) + std::log10(slowest));
        const double reach = std::max(0.5 * (std::log10(slowest) - std::log10(fastest)) + 0.07, 0.2);
        time_ = {middle - reach, middle + reach, kLeft, kRight};
        const double low = std::floor(std::log10(least) - 0.15);
        const double high = std::ceil(std::log10(most) + 0.15);
        zero_y_ = kBottom - 18.0;
        error_ = {low, std::max(high, low + 1.0), has_zero_ ? kBottom - 44.0 : kBottom, kTop};
    }

    void line(double x0, double y0, double x1, double y1, Ink ink, double width) { drawing_.shapes.emplace_back(LineShape{x0, y0, x1, y1, ink, width}); }
    void text(double x, double y, const std::string& what, Ink ink, double size, TextShape::Anchor anchor, bool is_bold = false)
    {
        drawing_.shapes.emplace_back(TextShape{x, y, what, ink, size, anchor, is_bold});
    }

    /// Round times: 1, 2 and 5 of each decade; over less than a decade evenly apart, about six.
    std::vector<double> time_ticks() const
    {
        std::vector<double> ticks;
        const double low = std::pow(10.0, time_.low);
        const double high = std::pow(10.0, time_.high);
        if (time_.high - time_.low < 0.9) {
            const double power = std::pow(10.0, std::floor(std::log10((high - low) / 6.0)));
            const double share = (high - low) / 6.0 / power;
            const double step = power * (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0);
            for (int i = static_cast<int>(std::ceil(low / step)); i * step <= high; ++i)
                ticks.push_back(i * step);
            return ticks;
        }
        for (int decade = static_cast<int>(std::floor(time_.low)); decade <= std::ceil(time_.high); ++decade)
            for (const double first : {1.0, 2.0, 5.0})
                if (const double ms = first * std::pow(10.0, decade); ms >= low && ms <= high)
                    ticks.push_back(ms);
        return ticks;
    }

    void draw_axes()
    {
        for (const double ms : time_ticks()) {
            const double x = time_.at(ms);
            line(x, kTop, x, kBottom, kGrid, 1.0);
            text(x, kBottom + 18.0, fmt::format("{:g}", ms), kAxis, 11.5, TextShape::Anchor::middle);
        }
        const int low = static_cast<int>(error_.low);
        const int high = static_cast<int>(error_.high);
        for (int decade = low; decade <= high; ++decade) {
            const double y = error_.at(std::pow(10.0, decade));
            line(kLeft, y, kRight, y, kGrid, 1.2);
            if (high - low < 9 || (decade - low) % 2 == 0)
                text(kLeft - 8.0, y + 4.0, power_text(decade), kAxis, 11.5, TextShape::Anchor::end);
        }
        if (has_zero_) {
            line(kLeft, zero_y_, kRight, zero_y_, kGrid, 1.2);
            text(kLeft - 8.0, zero_y_ + 4.0, "0", kAxis, 11.5, TextShape::Anchor::end);
        }
        line(kLeft, kTop, kLeft, kBottom, kAxis, 1.0);
        line(kLeft, kBottom, kRight, kBottom, kAxis, 1.0);
        text(0.5 * (kLeft + kRight), kBottom + 40.0, "milliseconds (median, 95 % interval)", kAxis, 12.0, TextShape::Anchor::middle);
        const std::string unit = ladder_.ladder->metric.unit;
        text(8.0, 14.0, "error" + (unit.empty() ? "" : ", " + unit), kAxis, 12.0, TextShape::Anchor::start);
    }

    double y_of(const MeasuredRung& rung) const { return rung.deviation.error > 0.0 ? error_.at(rung.deviation.error) : zero_y_; }
    double x_of(const MeasuredRung& rung) const { return time_.at(rung.ms.median); }

    /// Steps through the rungs that none beats: what a budget buys.
    void draw_front()
    {
        std::vector<const MeasuredRung*> front;
        for (const MeasuredRung& rung : ladder_.rungs)
            if (rung.dominated_by.empty())
                front.push_back(&rung);
        std::sort(front.begin(), front.end(), [](const auto* a, const auto* b) { return a->ms.median < b->ms.median; });
        double best = 1e300;
        const MeasuredRung* last = nullptr;
        for (const MeasuredRung* rung : front) {
            if (rung->deviation.error >= best)
                continue;
            if (last) {
                line(x_of(*last), y_of(*last), x_of(*rung), y_of(*last), kFront, 1.6);
                line(x_of(*rung), y_of(*last), x_of(*rung), y_of(*rung), kFront, 1.6);
                taken_.push_back({x_of(*last), y_of(*last) - 2.0, x_of(*rung), y_of(*last) + 2.0});
                taken_.push_back({x_of(*rung) - 2.0, y_of(*last), x_of(*rung) + 2.0, y_of(*rung)});
            }
            best = rung->deviation.error;
            last = rung;
        }
    }

    void draw_point(const MeasuredRung& rung)
    {
        const double x = x_of(rung);
        const double y = y_of(rung);
        const Ink ink = rung.dominated_by.empty() ? kFront : kDominated;
        const double low = time_.at(rung.ms.interval.low);
        const double high = time_.at(rung.ms.interval.high);
        line(low, y, high, y, ink, 1.4);
        line(low, y - 4.0, low, y + 4.0, ink, 1.4);
        line(high, y - 4.0, high, y + 4.0, ink, 1.4);
        if (rung.rung.is_default)
            drawing_.shapes.emplace_back(DiscShape{x, y, 8.5, kPaper, ink, 1.6});
        drawing_.shapes.emplace_back(DiscShape{x, y, 4.5, ink, kPaper, 1.0});
        taken_.push_back({std::min(low, x - 9.0), y - 7.0, std::max(high, x + 9.0), y + 7.0});
    }

    /// How much of what is there a label would cover; leaving the page costs most.
    double cost_of(const Box& box) const
    {
        const double outside = std::max(kLeft - box.x0, 0.0) + std::max(box.x1 - kWidth + 2.0, 0.0) + std::max(2.0 - box.y0, 0.0) + std::max(box.y1 - kBottom, 0.0);
        double covered = 0.0;
        for (const Box& other : taken_)
            covered += std::max(std::min(box.x1, other.x1) - std::max(box.x0, other.x0), 0.0) * std::max(std::min(box.y1, other.y1) - std::max(box.y0, other.y0), 0.0);
        return 1000.0 * outside + covered;
    }

    /// Beside, above or below its point, the first place that covers least.
    void draw_label(const MeasuredRung& rung)
    {
        const std::string name = rung.rung.name + (rung.rung.is_default ? " (default)" : "");
        const std::string note = rung.dominated_by.empty() ? "" : "dominated by " + rung.dominated_by;
        const double width = std::max(text_width(name, 12.5), text_width(note, 10.5));
        const double height = note.empty() ? 15.0 : 28.0;
        const double x = x_of(rung);
        const double y = y_of(rung);
        const double right = std::max(time_.at(rung.ms.interval.high), x + 9.0) + 5.0;
        const double left = std::min(time_.at(rung.ms.interval.low), x - 9.0) - 5.0 - width;
        const double middle = x - 0.5 * width;
        const std::vector<std::pair<double, double>> corners = {
            {right, y - 0.5 * height},         {left, y - 0.5 * height},           {middle, y - height - 9.0},  {middle, y + 9.0},
            {right - 8.0, y - height - 4.0},   {right - 8.0, y + 4.0},             {left + 8.0, y - height - 4.0}, {left + 8.0, y + 4.0},
            {middle, y - 2.0 * height - 12.0}, {middle, y + height + 12.0},        {right, y - 1.6 * height},   {right, y + 0.8 * height},
            {left, y - 1.6 * height},          {left, y + 0.8 * height},           {kWidth - 4.0 - width, y - height - 9.0}, {kWidth - 4.0 - width, y + 9.0}};
        Box chosen{};
        double least = 1e300;
        for (const auto& [corner_x, corner_y] : corners) {
            const Box box{corner_x, corner_y, corner_x + width, corner_y + height};
            if (const double cost = cost_of(box); cost < least) {
                least = cost;
                chosen = box;
            }
        }
        taken_.push_back(chosen);
        text(chosen.x0, chosen.y0 + 11.5, name, note.empty() ? kText : kFaint, 12.5, TextShape::Anchor::start, rung.rung.is_default);
        if (!note.empty())
            text(chosen.x0, chosen.y0 + 24.0, note, kFaint, 10.5, TextShape::Anchor::start);
    }

    const MeasuredLadder& ladder_;
    Drawing drawing_;
    Scale time_;
    Scale error_;
    double zero_y_ = 0.0;
    bool has_zero_ = false;
    std::vector<Box> taken_;
};

} // namespace

Drawing pareto_chart(const MeasuredLadder& ladder) { return Chart(ladder).draw(); }

} // namespace passgraph::accuracy
