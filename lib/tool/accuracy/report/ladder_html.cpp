// The page's section of one ladder: chart, what to take, table, pictures.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tool/accuracy/crops.hpp"
#include "tool/accuracy/report/chart.hpp"
#include "tool/accuracy/report/report.hpp"

namespace passgraph::accuracy {
namespace {

std::string ms_text(double ms) { return ms >= 10.0 ? fmt::format("{:.1f}", ms) : fmt::format("{:.2f}", ms); }

const MeasuredRung& most_exact(const MeasuredLadder& ladder)
{
    return *std::min_element(ladder.rungs.begin(), ladder.rungs.end(), [](const auto& a, const auto& b) {
        return a.deviation.error != b.deviation.error ? a.deviation.error < b.deviation.error : a.ms.median < b.ms.median;
    });
}

const MeasuredRung& cheapest(const MeasuredLadder& ladder)
{
    return *std::min_element(ladder.rungs.begin(), ladder.rungs.end(), [](const auto& a, const auto& b) { return a.ms.median < b.ms.median; });
}

std::string rung_phrase(const MeasuredLadder& ladder, const MeasuredRung& rung)
{
    return fmt::format("<code>{}</code> ({}&nbsp;ms, error <span class=\"whole\">{}</span>)", rung.rung.name, ms_text(rung.ms.median), error_text(ladder.ladder->metric, rung.deviation.error));
}

/// The rungs that the same other one beats, in a line each.
std::string grouped(const MeasuredLadder& ladder, std::string MeasuredRung::*other, const char* phrase)
{
    std::string text;
    for (const MeasuredRung& winner : ladder.rungs) {
        std::string names;
        for (const MeasuredRung& rung : ladder.rungs)
            if (rung.*other == winner.rung.name)
                names += fmt::format("{}<code>{}</code>", names.empty() ? "" : ", ", rung.rung.name);
        if (!names.empty())
            text += fmt::format("<li class=\"faint\">{}: {}.</li>", names, fmt::format(fmt::runtime(phrase), fmt::format("<code>{}</code>", winner.rung.name)));
    }
    return text;
}

/// What somebody in a hurry should know; nothing that the noise does not allow.
std::string verdict(const MeasuredLadder& ladder)
{
    const MeasuredRung& used = default_rung(ladder);
    const MeasuredRung& exact = most_exact(ladder);
    const MeasuredRung& quick = cheapest(ladder);
    std::string text = fmt::format("<li>Used unless you choose: {}.</li>", rung_phrase(ladder, used));
    if (&exact != &used)
        text += fmt::format("<li>Most exact: {}.</li>", rung_phrase(ladder, exact));
    if (!exact.is_ratio_claimed && &quick != &exact)
        text += fmt::format("<li>No rung is measurably cheaper than the most exact one, {}.</li>", exact.rung.name);
    else if (&quick != &used && &quick != &exact)
        text += fmt::format("<li>Cheapest: {}{}.</li>", rung_phrase(ladder, quick), quick.dominated_by.empty() ? "" : ", though dominated");
    text += grouped(ladder, &MeasuredRung::dominated_by, "dominated by {}, which is faster and no less exact");
    if (exact.is_ratio_claimed || &quick == &exact)
        text += grouped(ladder, &MeasuredRung::as_fast_as, "no measurable time saved over {}, which is more exact");
    for (const MeasuredRung& rung : ladder.rungs) {
        if (rung.deviation.non_finite > 0.0)
            text += fmt::format("<li class=\"warn\"><code>{}</code> returns values that are no finite number for {}&nbsp;% of the texels.</li>", rung.rung.name,
                                short_number(100.0 * rung.deviation.non_finite));
        if (!rung.is_within_bound)
            text += fmt::format("<li class=\"warn\"><code>{}</code> is beyond its derived bound of {}.</li>", rung.rung.name, error_text(ladder.ladder->metric, rung.rung.bound));
    }
    return "<ul class=\"verdict\">" + text + "</ul>";
}

std::string ratio_cell(const MeasuredLadder& ladder, const MeasuredRung& rung)
{
    if (&rung == &cheapest(ladder))
        return "1";
    if (!rung.is_ratio_claimed)
        return fmt::format("<span class=\"faint\" title=\"{:.3f} ({:.3f} to {:.3f}): within the noise\">&asymp; 1</span>", rung.to_cheapest.median,
                           rung.to_cheapest.interval.low, rung.to_cheapest.interval.high);
    return fmt::format("{:.2f} <span class=\"faint\">({:.2f}&ndash;{:.2f})</span>", rung.to_cheapest.median, rung.to_cheapest.interval.low,
                       rung.to_cheapest.interval.high);
}

std::string table_row(const MeasuredLadder& ladder, const MeasuredRung& rung)
{
    const Metric& metric = ladder.ladder->metric;
    std::string row = fmt::format("<tr{}><th scope=\"row\"><code>{}</code>{}{}<span class=\"what\">{}</span></th>", rung.dominated_by.empty() ? "" : " class=\"dominated\"",
                                  rung.rung.name, rung.rung.is_default ? " <span class=\"tag\">default</span>" : "",
                                  rung.dominated_by.empty() ? "" : " <span class=\"tag grey\">dominated</span>", escaped(rung.rung.what));
    row += fmt::format("<td>{} <span class=\"faint\">({}&ndash;{})</span></td><td>{}</td><td>{:.3g}</td>", ms_text(rung.ms.median), ms_text(rung.ms.interval.low),
                       ms_text(rung.ms.interval.high), ratio_cell(ladder, rung), rung.bytes_per_pixel);
    row += fmt::format("<td><strong>{}</strong></td><td>{}</td><td>{}</td>", error_text(metric, rung.deviation.error), error_text(metric, rung.deviation.mean),
                       std::isfinite(rung.rung.bound) ? error_text(metric, rung.rung.bound) : "&ndash;");
    for (const Figure& figure : rung.figures)
        row += fmt::format("<td>{}</td>", figure.value >= 100.0 ? fmt::format("{:.0f}", figure.value) : fmt::format("{:.4g}", figure.value));
    return row + fmt::format("<td class=\"left\">{}</td></tr>\n", escaped(rung.worst_input));
}

std::string table(const MeasuredLadder& ladder)
{
    std::string head = "<th>rung</th><th>ms <span class=\"faint\">(95&nbsp;%)</span></th><th>times the cheapest</th><th>bytes per pixel</th><th>error</th><th>mean</th><th>bound</th>";
    for (const Figure& figure : ladder.rungs.front().figures)
        head += "<th>" + escaped(figure.name) + "</th>";
    std::string rows;
    for (const MeasuredRung& rung : ladder.rungs)
        rows += table_row(ladder, rung);
    return fmt::format("<div class=\"scroll\"><table><thead><tr>{}<th class=\"left\">worst input</th></tr></thead><tbody>\n{}</tbody></table></div>"
                       "<p class=\"note\">Error: {}. Bytes: of the images kept between draws, or of the result where there are none; a dominated rung "
                       "may still be worth its bytes.</p>",
                       head, rows, escaped(ladder.ladder->metric.name));
}

/// The colors of the maps from the largest difference below to the largest above.
std::string scale_bar(const MeasuredLadder& ladder)
{
    std::string stops;
    constexpr int kStops = 20;
    for (int i = 0; i <= kStops; ++i) {
        const double at = 2.0 * i / kStops - 1.0; // -1 ... 1
        const double size = std::abs(at) > 0.0 ? std::pow(10.0, kMapDecades * (std::abs(at) - 1.0)) * ladder.map_limit : 0.0;
        const auto color = map_color(at < 0.0 ? -size : size, ladder.map_limit);
        stops += fmt::format("{}rgb({:.0f},{:.0f},{:.0f})", i > 0 ? "," : "", 255.0 * color[0], 255.0 * color[1], 255.0 * color[2]);
    }
    const Metric& metric = ladder.ladder->metric;
    Metric plain = metric;
    plain.unit.clear();
    const auto label = [&](double share) { return error_text(plain, share * ladder.map_limit); };
    return fmt::format("<div class=\"scale\"><span>&minus;{0}</span><span>&minus;{1}</span><span class=\"bar\" style=\"background:linear-gradient(90deg,{2})\"></span>"
                       "<span>+{1}</span><span>+{0}</span></div><p class=\"note\">Signed difference from the truth, of the component furthest off{3}; "
                       "one logarithmic scale for all maps of this ladder, white below 10<sup>&minus;5</sup> of its end. Magenta: not a finite number.</p>",
                       label(1.0), label(std::pow(10.0, -kMapDecades / 2.0)), stops,
                       metric.distance == Distance::relative || metric.distance == Distance::is_wrong ? ", over the true value" : "");
}

std::string figure(const std::string& caption, const Picture& picture)
{
    return fmt::format("<figure><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>", data_uri(picture),
                       2 * picture.extent.width, 2 * picture.extent.height, escaped(caption), escaped(caption));
}

std::string pictures(const MeasuredLadder& ladder)
{
    std::string text = "<div class=\"pair\">" + figure("the truth", ladder.truth_crop) + "</div>";
    for (const MeasuredRung& rung : ladder.rungs)
        text += fmt::format("<div class=\"pair\">{}{}</div>", figure(rung.rung.name, rung.crop),
                            figure("difference", difference_map(rung.differences, rung.crop.extent, ladder.map_limit)));
    return fmt::format("<details open><summary>Crops, twice enlarged, beside their differences</summary>{}<div class=\"crops\">{}</div></details>", scale_bar(ladder), text);
}

std::string noise_note(const MeasuredLadder& ladder)
{
    const std::string percent = short_number(100.0 * ladder.noise_floor);
    if (ladder.noise_floor > kNoisy)
        return fmt::format("<p class=\"note warn\">The machine was too noisy here: <code>{}</code> measured against itself differed by up to {}&nbsp;% over {} rounds. "
                           "Differences below that are not claimed; run again on an idle machine.</p>",
                           default_rung(ladder).rung.name, percent, ladder.rounds);
    return fmt::format("<p class=\"note\">{} rounds; <code>{}</code> measured against itself differed by up to {}&nbsp;%, and nothing below that is claimed.</p>", ladder.rounds,
                       default_rung(ladder).rung.name, percent);
}

} // namespace

std::string ladder_html(const MeasuredLadder& ladder)
{
    const Ladder& data = *ladder.ladder;
    return fmt::format("<section id=\"{0}\"><p class=\"stage\">{1}</p><h2>{2}</h2><p>{3}</p>\n<div class=\"top\"><div class=\"chart\">{4}</div>{5}</div>\n{6}{7}{8}</section>\n",
                       data.name, escaped(data.stage), escaped(data.title), escaped(data.about), to_svg(pareto_chart(ladder)), verdict(ladder), table(ladder),
                       noise_note(ladder), pictures(ladder));
}

} // namespace passgraph::accuracy
