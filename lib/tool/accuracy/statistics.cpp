// Medians by bootstrap.
#include "tool/accuracy/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <random>

namespace passgraph::accuracy {

double median(std::vector<double> values)
{
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Estimate bootstrap_median(const std::vector<double>& values, std::uint32_t seed)
{
    constexpr int kResamples = 500;
    std::mt19937 engine(seed); // engines are the same everywhere, distributions are not
    std::vector<double> medians;
    std::vector<double> resample(values.size());
    for (int i = 0; i < kResamples; ++i) {
        for (double& value : resample)
            value = values[engine() % values.size()];
        medians.push_back(median(resample));
    }
    std::sort(medians.begin(), medians.end());
    const auto at = [&](double share) { return medians[static_cast<size_t>(share * (kResamples - 1))]; };
    return {median(values), {at(0.025), at(0.975)}};
}

std::vector<double> paired_ratios(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> ratios;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        ratios.push_back(a[i] / b[i]);
    return ratios;
}

} // namespace passgraph::accuracy
