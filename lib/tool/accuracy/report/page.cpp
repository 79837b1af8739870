// The page around the ladders: style, budgets, conditions.
#include <algorithm>

#include <fmt/format.h>

#include "tool/accuracy/report/drawing.hpp"
#include "tool/accuracy/report/report.hpp"

namespace passgraph::accuracy {
namespace {

constexpr const char* kStyle = R"(
:root { --ink: #1d2430; --faint: #7b8492; --line: #e1e5eb; --blue: #1f5fbf; --paper: #ffffff; --ground: #f4f6f9; --warn: #a33a12; }
* { box-sizing: border-box; }
body { margin: 0; font: 15px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; color: var(--ink); background: var(--ground); }
main, header > div { max-width: 1180px; margin: 0 auto; padding: 0 24px; }
header { background: #17202e; color: #e8edf5; padding: 36px 0 28px; }
header h1 { margin: 0 0 8px; font-size: 30px; letter-spacing: -0.01em; }
header p { margin: 0; max-width: 70ch; color: #b9c4d6; }
nav { position: sticky; top: 0; z-index: 1; background: #fffffff2; border-bottom: 1px solid var(--line); }
nav div { max-width: 1180px; margin: 0 auto; padding: 8px 24px; display: flex; flex-wrap: wrap; gap: 4px 18px; font-size: 13.5px; }
nav a { color: var(--blue); text-decoration: none; }
nav a:hover { text-decoration: underline; }
section { background: var(--paper); border: 1px solid var(--line); border-radius: 10px; padding: 22px 26px; margin: 22px 0; scroll-margin-top: 48px; }
h2 { margin: 0 0 8px; font-size: 21px; letter-spacing: -0.01em; }
.stage { margin: 0; color: var(--faint); font-size: 12px; text-transform: uppercase; letter-spacing: 0.08em; }
section > p { max-width: 82ch; }
.top { display: grid; grid-template-columns: minmax(0, 1.75fr) minmax(230px, 1fr); gap: 22px; align-items: start; }
.chart svg { width: 100%; height: auto; display: block; border: 1px solid var(--line); border-radius: 8px; }
.verdict { margin: 0; padding-left: 18px; font-size: 14px; }
.verdict li { margin: 0 0 7px; }
.scroll { overflow-x: auto; margin-top: 14px; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; font-variant-numeric: tabular-nums; }
th, td { padding: 6px 10px; text-align: right; border-bottom: 1px solid var(--line); vertical-align: top; white-space: nowrap; }
thead th { color: var(--faint); font-weight: 600; font-size: 12.5px; border-bottom: 2px solid var(--line); white-space: normal; vertical-align: bottom; }
tbody th, thead th:first-child, .left { text-align: left; font-weight: 400; }
.whole { white-space: nowrap; }
td.choice { text-align: left; }
td.left { white-space: normal; min-width: 150px; color: var(--faint); }
.what { display: block; color: var(--faint); font-size: 12px; white-space: normal; max-width: 260px; }
code { font: 0.92em ui-monospace, "SF Mono", Menlo, "DejaVu Sans Mono", monospace; }
.tag { font-size: 11px; background: #e4eefb; color: var(--blue); border-radius: 9px; padding: 1px 7px; }
.tag.grey { background: #eceef2; color: #6d7684; }
tr.dominated, tr.dominated strong { color: #8a93a1; }
.faint { color: var(--faint); }
.warn { color: var(--warn); }
.note { color: var(--faint); font-size: 13px; margin: 8px 0 0; }
.note.warn { color: var(--warn); }
.banner { border-color: #e7b59f; background: #fdf3ee; }
details { margin-top: 16px; }
summary { cursor: pointer; font-size: 14px; font-weight: 600; margin-bottom: 8px; }
.crops { display: flex; flex-wrap: wrap; gap: 14px 18px; margin-top: 12px; }
.pair { display: flex; gap: 6px; }
figure { margin: 0; }
figure img { display: block; image-rendering: pixelated; border: 1px solid var(--line); border-radius: 3px; }
figcaption { font-size: 12px; color: var(--faint); margin-top: 3px; }
.scale { display: flex; align-items: center; gap: 10px; font-size: 12px; font-variant-numeric: tabular-nums; color: var(--faint); }
.scale .bar { width: 320px; height: 14px; border: 1px solid var(--line); border-radius: 3px; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 5px 20px; margin: 0 0 14px; font-size: 14px; }
dt { color: var(--faint); }
dd { margin: 0; }
@media (max-width: 860px) { .top { grid-template-columns: 1fr; } }
)";

constexpr double kBudgets[] = {1.0, 2.0, 5.0, 10.0, 20.0};

std::string budget_cell(const MeasuredLadder& ladder, const MeasuredRung* rung, const MeasuredRung* before)
{
    if (!rung)
        return "<td class=\"choice faint\">&ndash;</td>";
    if (rung == before)
        return "<td class=\"choice faint\">the same</td>";
    return fmt::format("<td class=\"choice\"><code>{}</code><span class=\"what\">error {}</span></td>", rung->rung.name, error_text(ladder.ladder->metric, rung->deviation.error));
}

std::string navigation(const Measurements& measurements)
{
    std::string links = "<a href=\"#budgets\">Which rung?</a>";
    for (const MeasuredLadder& ladder : measurements.ladders)
        links += fmt::format("<a href=\"#{}\">{}</a>", ladder.ladder->name, escaped(ladder.ladder->title));
    return "<nav><div>" + links + "<a href=\"#conditions\">Conditions</a></div></nav>";
}

std::string banners(const Measurements& measurements, const Conditions& conditions)
{
    std::string text;
    if (conditions.is_interrupted)
        text += "<section class=\"banner\"><strong>Interrupted.</strong> What had been measured by then is here; other ladders are missing.</section>";
    std::string noisy;
    for (const MeasuredLadder& ladder : measurements.ladders)
        if (ladder.noise_floor > kNoisy)
            noisy += fmt::format("{}<a href=\"#{}\">{}</a> ({:.0f}&nbsp;%)", noisy.empty() ? "" : ", ", ladder.ladder->name, escaped(ladder.ladder->title), 100.0 * ladder.noise_floor);
    if (!noisy.empty())
        text += fmt::format("<section class=\"banner\"><strong>The machine was too noisy to measure some ladders well.</strong> Two runs of the same thing differed by more than {:.0f}&nbsp;% in {}. "
                            "Errors are exact all the same; times and ratios there are weak, and nothing below the noise is claimed.</section>",
                            100.0 * kNoisy, noisy);
    return text;
}

} // namespace

std::string budgets_html(const Measurements& measurements)
{
    std::string head;
    for (const double budget : kBudgets)
        head += fmt::format("<th class=\"left\">{:g} ms</th>", budget);
    std::string rows;
    for (const MeasuredLadder& ladder : measurements.ladders) {
        const MeasuredRung& used = default_rung(ladder);
        rows += fmt::format("<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th>", ladder.ladder->name, escaped(ladder.ladder->title));
        const MeasuredRung* before = nullptr;
        for (const double budget : kBudgets) {
            const MeasuredRung* best = best_within(ladder, budget);
            rows += budget_cell(ladder, best, before);
            before = best;
        }
        rows += fmt::format("<td class=\"choice\"><code>{}</code><span class=\"what\">{:.3g} ms, error {}</span></td></tr>\n", used.rung.name, used.ms.median,
                            error_text(ladder.ladder->metric, used.deviation.error));
    }
    return fmt::format("<section id=\"budgets\"><h2>Which rung for how many milliseconds?</h2><p>The most exact rung that stays within a budget, by the upper end of its interval, "
                       "on this machine and at this size. The error beside it is what you give up.</p><div class=\"scroll\"><table><thead><tr><th>ladder</th>{}<th class=\"left\">the default</th>"
                       "</tr></thead><tbody>{}</tbody></table></div></section>\n",
                       head, rows);
}

std::string conditions_html(const Measurements& measurements, const Conditions& conditions)
{
    std::string list;
    const auto add = [&](const char* name, const std::string& value) { list += fmt::format("<dt>{}</dt><dd>{}</dd>", name, escaped(value)); };
    add("Renderer", conditions.renderer + " by " + conditions.context);
    add("Rendering threads", conditions.threads);
    add("Processor", fmt::format("{}, {} cores", conditions.processor, conditions.cores));
    add("Load average before, after", fmt::format("{:.2f}, {:.2f}", conditions.load_before, conditions.load_after));
    add("Size", fmt::format("{} x {}", conditions.extent.width, conditions.extent.height));
    add("Rounds", fmt::format("{} planned, each rung once in each, in an order shuffled anew (seed {})", conditions.rounds, conditions.seed));
    add("A sample", fmt::format("as many draws as last {:g} ms, by the wall clock between two glFinish", conditions.sample_ms));
    add("Date", conditions.date);
    add("passgraph", fmt::format("{}, commit {}", conditions.version, conditions.commit));
    add("Kind of run", conditions.is_quick ? "quick: smaller pictures, fewer rounds" : "full");
    add("The whole run took", fmt::format("{:.0f} s", conditions.seconds));
    std::string noise;
    for (const MeasuredLadder& ladder : measurements.ladders)
        noise += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td{}>{}&nbsp;%</td></tr>", escaped(ladder.ladder->title), ladder.rounds,
                             ladder.noise_floor > kNoisy ? " class=\"warn\"" : "", short_number(100.0 * ladder.noise_floor));
    return fmt::format(R"(<section id="conditions"><h2>Conditions</h2><dl>{}</dl>
<p>Times are medians; intervals are 95&nbsp;% by bootstrap over the rounds. Ratios are taken round by round, so that a machine's drift cancels. In each ladder the default rung is built and
timed twice: how far the two differ is the noise floor, and no ratio or dominance below it is claimed. Every pass is a draw of its own here; a graph that fuses passes is faster and often more exact.</p>
<p>{}</p>
<p>Errors do not depend on the machine's load. Each is measured against a reference in double precision that shares no code with the passes, over every texel of a picture made for the ladder;
the bound beside it is derived, not measured.</p>
<div class="scroll"><table style="width:auto"><thead><tr><th>ladder</th><th>rounds</th><th>noise floor</th></tr></thead><tbody>{}</tbody></table></div></section>
)",
                       list,
                       conditions.is_software ? "<strong>This is software rendering.</strong> On a graphics card the ratios differ: linear filtering is nearly free there, memory bandwidth counts, and "
                                                "powers and roots are cheap. Take the errors from here and measure the times there."
                                              : "Drivers differ: what is faster here need not be elsewhere.",
                       noise);
}

std::string report_html(const Measurements& measurements, const Conditions& conditions)
{
    std::string sections;
    size_t rungs = 0;
    for (const MeasuredLadder& ladder : measurements.ladders) {
        sections += ladder_html(ladder);
        rungs += ladder.rungs.size();
    }
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                       "<title>What accuracy costs in time</title><style>{}</style></head><body>\n"
                       "<header><div><h1>What accuracy costs in time</h1><p>{} ladders of {} rungs, each compared with an exact reference and timed on {}, at {} x {}. "
                       "Lower and further left is better; a blue line joins what no other rung beats.</p></div></header>\n{}<main>{}{}{}{}</main></body></html>\n",
                       kStyle, measurements.ladders.size(), rungs, escaped(conditions.renderer), conditions.extent.width, conditions.extent.height, navigation(measurements),
                       banners(measurements, conditions), budgets_html(measurements), sections, conditions_html(measurements, conditions));
}

} // namespace passgraph::accuracy
