// Filtering of cube maps on the CPU, in binary32.
#include "gl/cube_filter.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <thread>

namespace passgraph::gl {
namespace {

constexpr int kSmallestFace = 4;
constexpr int kFewestLevels = 4;

/// The direction through a place of a face, s and t from -1 to 1; table 8.19 of the OpenGL 4.6 specification, inverted.
glm::vec3 direction_at(int face, float s, float t)
{
    switch (face) {
    case 0: return {1.0f, -t, -s};
    case 1: return {-1.0f, -t, s};
    case 2: return {s, 1.0f, t};
    case 3: return {s, -1.0f, -t};
    case 4: return {s, -t, 1.0f};
    default: return {-s, -t, -1.0f};
    }
}

struct FacePlace {
    int face = 0;
    float s = 0.0f;
    float t = 0.0f;
};

FacePlace place_of(glm::vec3 d)
{
    const glm::vec3 size = glm::abs(d);
    if (size.x >= size.y && size.x >= size.z) {
        const float per = 1.0f / size.x;
        return d.x > 0.0f ? FacePlace{0, -d.z * per, -d.y * per} : FacePlace{1, d.z * per, -d.y * per};
    }
    if (size.y >= size.z) {
        const float per = 1.0f / size.y;
        return d.y > 0.0f ? FacePlace{2, d.x * per, d.z * per} : FacePlace{3, d.x * per, -d.z * per};
    }
    const float per = 1.0f / size.z;
    return d.z > 0.0f ? FacePlace{4, d.x * per, -d.y * per} : FacePlace{5, -d.x * per, -d.y * per};
}

/// Six faces with one texel of their neighbours around each, so that a bilinear read knows no edge.
struct PaddedCube {
    int size = 0;
    std::vector<glm::vec4> texels;

    size_t row_length() const { return static_cast<size_t>(size) + 2; }
    size_t index(int face, int x, int y) const // from -1 to size
    {
        return (static_cast<size_t>(face) * row_length() + static_cast<size_t>(y + 1)) * row_length() +
               static_cast<size_t>(x + 1);
    }
    float center(int i) const { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; }

    explicit PaddedCube(int faces_size) : size(faces_size), texels(6 * row_length() * row_length()) {}

    void pad()
    {
        const auto texel = [&](float place) {
            return std::clamp(static_cast<int>((place * 0.5f + 0.5f) * static_cast<float>(size)), 0, size - 1);
        };
        const auto fill = [&](int face, int x, int y) {
            const FacePlace from = place_of(direction_at(face, center(x), center(y)));
            texels[index(face, x, y)] = texels[index(from.face, texel(from.s), texel(from.t))];
        };
        for (int face = 0; face < 6; ++face)
            for (int i = -1; i <= size; ++i)
                for (const int edge : {-1, size}) {
                    fill(face, i, edge);
                    fill(face, edge, i);
                }
    }

    glm::vec4 bilinear(glm::vec3 direction) const
    {
        const FacePlace place = place_of(direction);
        const float scale = 0.5f * static_cast<float>(size);
        const float x = place.s * scale + (scale + 0.5f); // of the padded face
        const float y = place.t * scale + (scale + 0.5f);
        const int left = std::min(static_cast<int>(x), size);
        const int low = std::min(static_cast<int>(y), size);
        const float fx = x - static_cast<float>(left);
        const float fy = y - static_cast<float>(low);
        const glm::vec4* at = &texels[index(place.face, left - 1, low - 1)];
        const glm::vec4* above = at + row_length();
        const glm::vec4 one = at[0] + (at[1] - at[0]) * fx;
        const glm::vec4 other = above[0] + (above[1] - above[0]) * fx;
        return one + (other - one) * fy;
    }
};

/// Half as wide, each texel the mean of the area it covers, odd sizes included.
PaddedCube reduced(const PaddedCube& cube, int size)
{
    PaddedCube half(size);
    const double ratio = static_cast<double>(cube.size) / size;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                glm::vec4 sum(0.0f);
                float weights = 0.0f;
                const auto share = [&](int from, int to) {
                    return static_cast<float>(std::min<double>(from + 1, (to + 1) * ratio) -
                                              std::max<double>(from, to * ratio));
                };
                for (int j = static_cast<int>(y * ratio); j < cube.size && j < (y + 1) * ratio; ++j)
                    for (int i = static_cast<int>(x * ratio); i < cube.size && i < (x + 1) * ratio; ++i) {
                        const float weight = share(i, x) * share(j, y);
                        sum += cube.texels[cube.index(face, i, j)] * weight;
                        weights += weight;
                    }
                half.texels[half.index(face, x, y)] = sum / weights;
            }
    half.pad();
    return half;
}

PaddedCube padded(const CubeFaces& faces)
{
    PaddedCube cube(faces[0].extent.width);
    for (int face = 0; face < 6; ++face) {
        const Picture& picture = faces[static_cast<size_t>(face)];
        assert(picture.channels == 4 && picture.extent == faces[0].extent);
        for (int y = 0; y < cube.size; ++y)
            for (int x = 0; x < cube.size; ++x) {
                const float* texel = &picture.texels[picture.index(x, y)];
                cube.texels[cube.index(face, x, y)] = {texel[0], texel[1], texel[2], texel[3]};
            }
    }
    cube.pad();
    return cube;
}

std::vector<PaddedCube> box_levels(const CubeFaces& faces)
{
    std::vector<PaddedCube> levels = {padded(faces)};
    while (levels.back().size > 1)
        levels.push_back(reduced(levels.back(), std::max(levels.back().size / 2, 1)));
    return levels;
}

/// A direction of the lobe around +Z, its share, and the box level it reads.
struct LobeSample {
    glm::vec3 direction;
    float share = 0.0f;
    int level = 0;
};

/// Half vectors of GGX's density on a golden spiral, mirrored; shares n.l sum to 1.
std::vector<LobeSample> lobe_samples(double roughness, int count, int size, int levels)
{
    const double alpha_squared = std::pow(roughness, 4.0);
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double texel = 4.0 * std::numbers::pi / (6.0 * size * size);
    std::vector<LobeSample> samples;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count;
        const double cos_squared = (1.0 - u) / (1.0 + (alpha_squared - 1.0) * u);
        const double z = 2.0 * cos_squared - 1.0;
        if (z <= 0.0)
            continue;
        const double bracket = cos_squared * (alpha_squared - 1.0) + 1.0;
        const double density = alpha_squared / (std::numbers::pi * bracket * bracket) / 4.0; // n.h = v.h
        // Twice as wide in each direction as the sample's own part of the lobe: neighbours overlap, and leave no spots.
        const double level = 0.5 * std::log2(1.0 / (count * density) / texel) + 1.0;
        const double r = std::sqrt(1.0 - z * z);
        samples.push_back({{static_cast<float>(r * std::cos(golden_angle * i)),
                            static_cast<float>(r * std::sin(golden_angle * i)), static_cast<float>(z)},
                           static_cast<float>(z),
                           std::clamp(static_cast<int>(std::lround(level)), 0, levels - 1)});
        sum += z;
    }
    for (LobeSample& sample : samples)
        sample.share = static_cast<float>(sample.share / sum);
    return samples;
}

/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
glm::mat3 basis_around(glm::vec3 n)
{
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

void filter_row(Picture& into, int face, int y, const std::vector<LobeSample>& lobe,
                const std::vector<PaddedCube>& boxes)
{
    const float per_size = 1.0f / static_cast<float>(into.extent.width);
    const float t = (2.0f * static_cast<float>(y) + 1.0f) * per_size - 1.0f;
    for (int x = 0; x < into.extent.width; ++x) {
        const float s = (2.0f * static_cast<float>(x) + 1.0f) * per_size - 1.0f;
        const glm::mat3 basis = basis_around(glm::normalize(direction_at(face, s, t)));
        glm::vec4 sum(0.0f);
        for (const LobeSample& sample : lobe)
            sum += boxes[static_cast<size_t>(sample.level)].bilinear(basis * sample.direction) * sample.share;
        float* texel = &into.texels[into.index(x, y)];
        for (int c = 0; c < 4; ++c)
            texel[c] = sum[c];
    }
}

CubeFaces filtered(int size, const std::vector<LobeSample>& lobe, const std::vector<PaddedCube>& boxes)
{
    CubeFaces faces;
    faces.fill(Picture({size, size}, 4));
    const auto rows_from = [&](int first, int step) {
        for (int row = first; row < 6 * size; row += step)
            filter_row(faces[static_cast<size_t>(row / size)], row / size, row % size, lobe, boxes);
    };
    // Every texel is computed alone, so how rows are shared out changes no bit. Small levels are not worth a thread.
    const int workers = size < 32 ? 1 : static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u));
    std::vector<std::thread> threads;
    for (int worker = 1; worker < workers; ++worker)
        threads.emplace_back(rows_from, worker, workers);
    rows_from(0, workers);
    for (std::thread& thread : threads)
        thread.join();
    return faces;
}

/// The nearest binary16, to even, as a binary32. Some drivers truncate on upload, which would darken each level by half a unit.
float nearest_half(float x)
{
    constexpr float kSmallestNormal = 6.103515625e-05f;
    constexpr float kPerSubnormal = 16777216.0f;
    if (!(std::abs(x) >= kSmallestNormal))
        return std::nearbyint(x * kPerSubnormal) / kPerSubnormal;
    auto bits = std::bit_cast<std::uint32_t>(x);
    bits += 0xfffu + ((bits >> 13) & 1u); // 13 bits fewer
    return std::clamp(std::bit_cast<float>(bits & ~0x1fffu), -65504.0f, 65504.0f);
}

} // namespace

CubeFaces rounded_to_half(CubeFaces faces)
{
    for (Picture& face : faces)
        for (float& texel : face.texels)
            texel = nearest_half(texel);
    return faces;
}

int prefiltered_levels(int size)
{
    int levels = 1;
    while (size >> levels > 0)
        ++levels;
    const int down_to_smallest = levels - static_cast<int>(std::log2(kSmallestFace));
    return std::min(levels, std::max(down_to_smallest, kFewestLevels));
}

std::vector<CubeFaces> prefiltered(const CubeFaces& faces)
{
    constexpr int kFewestSamples = 24; // of the widest level, whose texels are most and whose lobe is narrowest
    constexpr int kMostSamples = 192;
    const int size = faces[0].extent.width;
    const int levels = prefiltered_levels(size);
    if (levels == 1)
        return {};
    const std::vector<PaddedCube> boxes = box_levels(faces);
    std::vector<CubeFaces> result;
    for (int level = 1; level < levels; ++level) {
        const double roughness = static_cast<double>(level) / (levels - 1);
        const int samples = size >> level <= 16 ? kMostSamples : std::min(kFewestSamples << (level - 1), kMostSamples);
        result.push_back(
            filtered(size >> level, lobe_samples(roughness, samples, size, static_cast<int>(boxes.size())), boxes));
    }
    return result;
}

Harmonics irradiance_harmonics(const CubeFaces& faces)
{
    constexpr int kMostTexels = 64;
    PaddedCube cube = padded(faces);
    if (cube.size > kMostTexels)
        cube = reduced(cube, kMostTexels);
    // Radiance's harmonics without their constants: 1, y, z, x, xy, yz, 3 z^2 - 1, xz, x^2 - y^2.
    std::array<glm::dvec3, glsl::kHarmonics> moments{};
    double total = 0.0;
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < cube.size; ++j)
            for (int i = 0; i < cube.size; ++i) {
                const glm::dvec3 place(direction_at(face, cube.center(i), cube.center(j)));
                const glm::dvec3 d = glm::normalize(place);
                const double angle = std::pow(glm::dot(place, place), -1.5); // times a constant: the texel's solid angle
                const glm::dvec3 light = angle * glm::dvec3(cube.texels[cube.index(face, i, j)]);
                const double basis[] = {1.0,       d.y,       d.z, d.x, d.x * d.y, d.y * d.z, 3.0 * d.z * d.z - 1.0,
                                        d.x * d.z, d.x * d.x - d.y * d.y};
                for (size_t k = 0; k < moments.size(); ++k)
                    moments[k] += basis[k] * light;
                total += angle;
            }
    // Squared constants of the harmonics, times the cosine lobe's pi, 2 pi / 3, pi / 4, over a sphere of 4 pi.
    for (glm::dvec3& moment : moments)
        moment *= 4.0 * std::numbers::pi / total;
    Harmonics c;
    const auto store = [&](size_t k, double factor) { c[k] = glm::vec3(moments[k] * factor); };
    for (const size_t k : {1, 2, 3})
        store(k, 0.5);
    for (const size_t k : {4, 5, 7})
        store(k, 15.0 / 16.0);
    store(8, 15.0 / 64.0);
    // 5/64 (3 z^2 - 1) m: its constant part joins the first coefficient.
    store(6, 15.0 / 64.0);
    c[0] = glm::vec3(moments[0] * 0.25 - moments[6] * (5.0 / 64.0));
    return c;
}

} // namespace passgraph::gl
