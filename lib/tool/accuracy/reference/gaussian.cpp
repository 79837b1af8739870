// The Gaussian: weights, and the blur of an image.
#include <algorithm>
#include <cmath>

#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::reference {

std::vector<double> gaussian_weights(double sigma)
{
    std::vector<double> weights;
    const int reach = static_cast<int>(std::ceil(9.0 * sigma));
    double total = 0.0;
    for (int i = 0; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        total += (i == 0 ? 1.0 : 2.0) * weights.back();
    }
    for (double& weight : weights)
        weight /= total;
    return weights;
}

namespace {

/// Along one line of `count` numbers, `stride` apart.
void blur_line(const double* from, double* to, int count, std::ptrdiff_t stride, const std::vector<double>& weights)
{
    const int reach = static_cast<int>(weights.size()) - 1;
    for (int i = 0; i < count; ++i) {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k)
            sum += weights[static_cast<size_t>(std::abs(k))] * from[std::clamp(i + k, 0, count - 1) * stride];
        to[i * stride] = sum;
    }
}

} // namespace

std::vector<double> gaussian_blur(const std::vector<double>& image, int width, int height, int channels, double sigma)
{
    const std::vector<double> weights = gaussian_weights(sigma);
    std::vector<double> rows(image.size());
    std::vector<double> both(image.size());
    const std::ptrdiff_t line = static_cast<std::ptrdiff_t>(width) * channels;
    for (int y = 0; y < height; ++y)
        for (int c = 0; c < channels; ++c)
            blur_line(&image[static_cast<size_t>(y * line + c)], &rows[static_cast<size_t>(y * line + c)], width, channels, weights);
    for (int x = 0; x < width; ++x)
        for (int c = 0; c < channels; ++c)
            blur_line(&rows[static_cast<size_t>(x * channels + c)], &both[static_cast<size_t>(x * channels + c)], height, line, weights);
    return both;
}

} // namespace passgraph::reference
