// Compares results with the truth, texel by texel.
#include "tool/accuracy/metric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tool/accuracy/ladder.hpp"
#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::accuracy {
namespace {

bool is_finite(const float* got, int components)
{
    return std::all_of(got, got + components, [](float value) { return std::isfinite(value); });
}

double length(const double* v, int components)
{
    double squared = 0.0;
    for (int c = 0; c < components; ++c)
        squared += v[c] * v[c];
    return std::sqrt(squared);
}

double relative(const Metric& metric, const double* truth, const float* got, int components)
{
    double difference = 0.0;
    double worst = 0.0;
    for (int c = 0; c < components; ++c) {
        const double off = std::abs(got[c] - truth[c]);
        difference += off * off;
        worst = std::max(worst, off / std::max(std::abs(truth[c]), metric.smallest));
    }
    return metric.is_per_component ? worst : std::sqrt(difference) / std::max(length(truth, components), metric.smallest);
}

double distance(const Metric& metric, const double* truth, const float* got, int components)
{
    switch (metric.distance) {
    case Distance::angle:
        return reference::angle_degrees({truth[0], truth[1], truth[2]}, {got[0], got[1], got[2]});
    case Distance::relative:
        return relative(metric, truth, got, components);
    case Distance::absolute: {
        double worst = 0.0;
        for (int c = 0; c < components; ++c)
            worst = std::max(worst, std::abs(got[c] - truth[c]));
        return worst;
    }
    case Distance::is_wrong:
        for (int c = 0; c < components; ++c)
            if (!(std::abs(got[c] - truth[c]) <= metric.tolerance * std::abs(truth[c]) + 1e-3))
                return 1.0;
        return 0.0;
    }
    return 0.0;
}

double percentile_99(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

} // namespace

Deviation compare(const Metric& metric, const Truth& truth, const Picture& result)
{
    Deviation errors;
    std::vector<double> all;
    all.reserve(truth.values.size());
    double bias = 0.0;
    std::int64_t broken = 0;
    for (int y = 0; y < truth.extent.height; ++y) {
        for (int x = 0; x < truth.extent.width; ++x) {
            const float* got = &result.texels[result.index(x, y)];
            if (!is_finite(got, truth.components)) {
                if (broken++ == 0)
                    errors.worst = {x, y};
                if (metric.distance != Distance::is_wrong)
                    continue;
            }
            all.push_back(distance(metric, truth.at(x, y), got, truth.components));
            errors.mean += all.back();
            const double off = signed_difference(metric, truth, result, x, y);
            bias += std::isfinite(off) ? off : 0.0;
            if (all.back() > errors.largest) {
                errors.largest = all.back();
                if (broken == 0)
                    errors.worst = {x, y};
            }
        }
    }
    const double texels = static_cast<double>(truth.extent.width) * truth.extent.height;
    const double counted = std::max(static_cast<double>(all.size()), 1.0);
    errors.mean /= counted;
    errors.bias = bias / counted;
    errors.non_finite = static_cast<double>(broken) / texels;
    errors.p99 = percentile_99(std::move(all));
    errors.error = metric.summary == Summary::mean  ? errors.mean
                   : metric.summary == Summary::p99 ? errors.p99
                                                    : errors.largest;
    return errors;
}

double signed_difference(const Metric& metric, const Truth& truth, const Picture& result, int x, int y)
{
    const double* exact = truth.at(x, y);
    const float* got = &result.texels[result.index(x, y)];
    const bool is_relative = metric.distance == Distance::relative || metric.distance == Distance::is_wrong;
    const double whole = std::max(length(exact, truth.components), metric.smallest);
    double worst = 0.0;
    for (int c = 0; c < truth.components; ++c) {
        if (!std::isfinite(got[c]))
            return std::numeric_limits<double>::quiet_NaN();
        double off = got[c] - exact[c];
        if (is_relative)
            off /= metric.is_per_component ? std::max(std::abs(exact[c]), metric.smallest) : whole;
        if (std::abs(off) > std::abs(worst))
            worst = off;
    }
    return worst;
}

} // namespace passgraph::accuracy
