// The report for programs: JSON and CSV.
#include <cmath>

#include <fmt/format.h>

#include <passgraph/core/json_value.hpp>

#include "tool/accuracy/report/report.hpp"

namespace passgraph::accuracy {
namespace {

using Object = JsonValue;

Object pair_json(const Interval& interval) { return Object::array({interval.low, interval.high}); }

Object text_or_null(const std::string& text) { return text.empty() ? Object(nullptr) : Object(text); }

Object rung_json(const MeasuredLadder& ladder, const MeasuredRung& rung)
{
    Object json = {{"ladder", ladder.ladder->name},
                   {"rung", rung.rung.name},
                   {"error", rung.deviation.error},
                   {"metric", ladder.ladder->metric.name},
                   {"unit", ladder.ladder->metric.unit},
                   {"ms", rung.ms.median},
                   {"ms_interval", pair_json(rung.ms.interval)},
                   {"ratio_to_cheapest", rung.to_cheapest.median},
                   {"ratio_interval", pair_json(rung.to_cheapest.interval)},
                   {"is_ratio_claimed", rung.is_ratio_claimed},
                   {"bytes_per_pixel", rung.bytes_per_pixel},
                   {"error_mean", rung.deviation.mean},
                   {"error_p99", rung.deviation.p99},
                   {"error_max", rung.deviation.largest},
                   {"bias", rung.deviation.bias},
                   {"non_finite", rung.deviation.non_finite},
                   {"worst_input", rung.worst_input},
                   {"bound", rung.rung.bound},
                   {"is_within_bound", rung.is_within_bound},
                   {"is_default", rung.rung.is_default},
                   {"is_dominated", !rung.dominated_by.empty()},
                   {"dominated_by", text_or_null(rung.dominated_by)},
                   {"as_fast_as", text_or_null(rung.as_fast_as)},
                   {"what", rung.rung.what},
                   {"figures", Object::object()}};
    for (const Figure& figure : rung.figures)
        json["figures"][figure.name] = figure.value;
    return json;
}

Object conditions_json(const Conditions& conditions)
{
    return {{"renderer", conditions.renderer},
            {"context", conditions.context},
            {"threads", conditions.threads},
            {"processor", conditions.processor},
            {"cores", conditions.cores},
            {"load_average", Object::array({conditions.load_before, conditions.load_after})},
            {"size", Object::array({conditions.extent.width, conditions.extent.height})},
            {"rounds", conditions.rounds},
            {"sample_ms", conditions.sample_ms},
            {"seed", conditions.seed},
            {"date", conditions.date},
            {"version", conditions.version},
            {"commit", conditions.commit},
            {"quick", conditions.is_quick},
            {"interrupted", conditions.is_interrupted},
            {"seconds", conditions.seconds}};
}

/// A cell of CSV: quoted where it must be (RFC 4180).
std::string cell(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

} // namespace

std::string report_json(const Measurements& measurements, const Conditions& conditions)
{
    Object json = {{"passgraph", 1}, {"conditions", conditions_json(conditions)}, {"ladders", Object::array()}, {"rungs", Object::array()}};
    for (const MeasuredLadder& ladder : measurements.ladders) {
        json["ladders"].push_back({{"ladder", ladder.ladder->name},
                                   {"title", ladder.ladder->title},
                                   {"stage", ladder.ladder->stage},
                                   {"about", ladder.ladder->about},
                                   {"passes", ladder.ladder->passes},
                                   {"rounds", ladder.rounds},
                                   {"noise_floor", ladder.noise_floor},
                                   {"is_noisy", ladder.noise_floor > kNoisy},
                                   {"chart", "charts/" + ladder.ladder->name + ".svg"}});
        for (const MeasuredRung& rung : ladder.rungs)
            json["rungs"].push_back(rung_json(ladder, rung));
    }
    return json.text(2) + "\n";
}

std::string report_csv(const Measurements& measurements)
{
    std::string text = "ladder,rung,error,metric,unit,ms,ms_low,ms_high,ratio_to_cheapest,ratio_low,ratio_high,bytes_per_pixel,"
                       "error_mean,error_p99,error_max,bias,non_finite,bound,is_default,dominated_by,worst_input,figures\n";
    for (const MeasuredLadder& ladder : measurements.ladders)
        for (const MeasuredRung& rung : ladder.rungs) {
            std::string figures;
            for (const Figure& figure : rung.figures)
                figures += fmt::format("{}{}={:.9g}", figures.empty() ? "" : "; ", figure.name, figure.value);
            text += fmt::format("{},{},{:.9g},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{},{},{}\n",
                                ladder.ladder->name, rung.rung.name, rung.deviation.error, cell(ladder.ladder->metric.name), ladder.ladder->metric.unit,
                                rung.ms.median, rung.ms.interval.low, rung.ms.interval.high, rung.to_cheapest.median, rung.to_cheapest.interval.low,
                                rung.to_cheapest.interval.high, rung.bytes_per_pixel, rung.deviation.mean, rung.deviation.p99, rung.deviation.largest,
                                rung.deviation.bias, rung.deviation.non_finite, rung.rung.bound, rung.rung.is_default, rung.dominated_by,
                                cell(rung.worst_input), cell(figures));
        }
    return text;
}

} // namespace passgraph::accuracy
