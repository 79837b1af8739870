// The tables of signals and codecs, the guards, and decoding on the host.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include <passgraph/core/codec.hpp>

#include "support/catch.hpp"

using namespace passgraph;

namespace {

using Direction = std::array<double, 3>;

double sign_of(double x) { return x >= 0.0 ? 1.0 : -1.0; }

/// Cigolle et al. 2014 in double: the direction on the octahedron, folded onto the square [-1, 1]^2.
std::array<double, 2> folded(const Direction& n)
{
    const double sum = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
    const double x = n[0] / sum;
    const double y = n[1] / sum;
    if (n[2] >= 0.0)
        return {x, y};
    return {(1.0 - std::abs(y)) * sign_of(x), (1.0 - std::abs(x)) * sign_of(y)};
}

Direction unfolded(double x, double y)
{
    const double z = 1.0 - std::abs(x) - std::abs(y);
    Direction n = {x, y, z};
    if (z < 0.0)
        n = {(1.0 - std::abs(y)) * sign_of(x), (1.0 - std::abs(x)) * sign_of(y), z};
    const double length = std::hypot(n[0], n[1], n[2]);
    return {n[0] / length, n[1] / length, n[2] / length};
}

/// The angle by cross and dot product: an arc cosine would lose half the digits near 0.
double degrees_between(const Direction& a, const Direction& b)
{
    const Direction cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return std::atan2(std::hypot(cross[0], cross[1], cross[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180.0 / std::numbers::pi;
}

std::vector<Direction> fibonacci_sphere(int count)
{
    std::vector<Direction> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double radius = std::sqrt(1.0 - z * z);
        directions.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return directions;
}

Direction decoded(const std::vector<float>& texel, const char* codec)
{
    Picture raw({1, 1}, static_cast<int>(texel.size()));
    raw.texels = texel;
    const Picture value = decode_texels(raw, Signal::normal, *find_codec(Signal::normal, codec));
    REQUIRE(value.channels == 3);
    return {value.texels[0], value.texels[1], value.texels[2]};
}

double largest_error(const char* codec, double codes)
{
    double largest = 0.0;
    const double middle = (codes - 1.0) / 2.0;
    for (const Direction& n : fibonacci_sphere(10000)) {
        const auto [x, y] = folded(n);
        const auto stored = [&](double p) { return static_cast<float>(std::round(p * middle + middle + 1.0) / codes); };
        largest = std::max(largest, degrees_between(n, decoded({stored(x), stored(y)}, codec)));
    }
    return largest;
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<float> guarded(Signal signal, std::vector<float> texels, int channels)
{
    Picture picture({static_cast<int>(texels.size()) / channels, 1}, channels);
    picture.texels = std::move(texels);
    apply_guard(picture, signal);
    return picture.texels;
}

} // namespace

TEST_CASE("the table of signals is consistent", "[core][signal]")
{
    std::set<std::string_view> names;
    for (const SignalInfo& row : all_signals()) {
        CHECK(&info(row.signal) == &row);
        CHECK(find_signal(row.name) == row.signal);
        CHECK(names.insert(row.name).second);
        CHECK(row.components >= 1);
        CHECK(row.components <= 4);
        CHECK(row.cap > 0.0f);
        CHECK(std::isfinite(row.cap));
        CHECK(row.has_alpha == (row.components == 4));
        CHECK(!row.meaning.empty());
        CHECK(!row.unit.empty());
    }
    CHECK(names.size() == static_cast<size_t>(Signal::color) + 1);
    CHECK(!find_signal("colour"));
    CHECK(glsl_type(1) == "float");
    CHECK(glsl_type(4) == "vec4");
}

TEST_CASE("a port accepts its own signal, and a generic one the four colors", "[core][signal]")
{
    const std::set<Signal> colors = {Signal::radiance, Signal::radiance_alpha, Signal::display, Signal::display_alpha};
    for (const SignalInfo& port : all_signals()) {
        for (const SignalInfo& image : all_signals()) {
            const bool is_generic = port.signal == Signal::color && colors.contains(image.signal);
            CHECK(accepts(port.signal, image.signal) == (port.signal == image.signal || is_generic));
        }
    }
}

TEST_CASE("every signal has codecs that hold all its components, the exact one among them", "[core][codec]")
{
    const std::set<Format> one = {Format::r8, Format::r16f, Format::r32f, Format::depth24, Format::depth32f};
    const std::set<Format> two = {Format::rg8, Format::rg16, Format::rg16f, Format::rg32f};
    for (const SignalInfo& row : all_signals()) {
        INFO(row.name);
        std::set<std::string_view> names;
        for (const Codec& codec : codecs_of(row.signal)) {
            CHECK(names.insert(codec.name).second);
            CHECK(find_codec(row.signal, codec.name) == &codec);
            const int channels = one.contains(codec.format) ? 1 : two.contains(codec.format) ? 2 : codec.format == Format::r11f_g11f_b10f ? 3 : 4;
            CHECK(channels >= (codec.packing == Packing::octahedral || codec.packing == Packing::sphere_map ? 2 : row.components));
            CHECK(is_depth(codec.format) <= (row.signal == Signal::depth));
        }
        CHECK(codec_names(row.signal).size() == names.size());
        if (row.components >= 3)
            CHECK(find_codec(row.signal, "rgba32f"));
    }
    CHECK(find_codec(Signal::display, "octahedral_rg16") == nullptr);
    CHECK(bytes_per_texel(Format::rgba16f) == 8);
    CHECK(name(Format::r11f_g11f_b10f) == "r11f_g11f_b10f");
    CHECK(is_depth(Format::depth24));
    CHECK(!is_depth(Format::r32f));
}

TEST_CASE("decoding an octahedral texel agrees with the formula in double", "[core][codec]")
{
    for (int code_x = 1; code_x <= 65535; code_x += 4369) {
        for (int code_y = 1; code_y <= 65535; code_y += 1285) {
            const Direction expected = unfolded((code_x - 32768) / 32767.0, (code_y - 32768) / 32767.0);
            const Direction got = decoded({static_cast<float>(code_x) / 65535.0f, static_cast<float>(code_y) / 65535.0f}, "octahedral_rg16");
            // Each coordinate comes from a few roundings of numbers up to 65535: 8 of 2^-24 times 2, in radians.
            CHECK(degrees_between(expected, got) < 8.0 * 2.0 * std::ldexp(1.0, -24) * 180.0 / std::numbers::pi);
        }
    }
}

TEST_CASE("the axes survive storing exactly", "[core][codec]")
{
    for (const auto& [codec, codes] : {std::pair{"octahedral_rg16", 65535.0}, {"octahedral_rg8", 255.0}}) {
        const double middle = (codes - 1.0) / 2.0;
        for (const Direction& axis : {Direction{0, 0, 1}, Direction{1, 0, 0}, Direction{-1, 0, 0}, Direction{0, 1, 0}, Direction{0, -1, 0}}) {
            const auto [x, y] = folded(axis);
            const auto stored = [&](double p) { return static_cast<float>((p * middle + middle + 1.0) / codes); };
            const Direction got = decoded({stored(x), stored(y)}, codec);
            for (size_t c = 0; c < 3; ++c)
                CHECK(got[c] == Approx(axis[c]).margin(2e-7).epsilon(0.0)); // u * codes rounds at 65535 * 2^-24 / 32767
        }
    }
    CHECK(decoded({512.0f / 1023, 512.0f / 1023, 1.0f}, "rgb10_a2")[2] == Approx(1.0).margin(1e-7));
}

TEST_CASE("16-bit octahedral normals are at most 0.004 degrees off, 8-bit ones at most 1", "[core][codec]")
{
    CHECK(largest_error("octahedral_rg16", 65535.0) <= 0.004);
    CHECK(largest_error("octahedral_rg16", 65535.0) > 0.001); // it was quantised at all
    CHECK(largest_error("octahedral_rg8", 255.0) <= 1.0);
}

TEST_CASE("folding agrees with the table of an independent implementation", "[core][codec]")
{
    std::ifstream file(PASSGRAPH_SOURCE_DIR "/tests/data/normal_codes.csv");
    std::string line;
    REQUIRE(std::getline(file, line)); // nx,ny,nz,lambert_u,lambert_v,oct_x,oct_y,...
    int rows = 0;
    while (std::getline(file, line)) {
        std::stringstream cells(line);
        std::vector<double> row;
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(std::stod(cell));
        const Direction n = {row[0], row[1], row[2]};
        const auto [x, y] = folded(n);
        INFO(line);
        // A z of -0.0 or rounding at the fold changes the representation, not the direction.
        CHECK(degrees_between(unfolded(row[5], row[6]), unfolded(x, y)) < 1e-5);
        const auto stored = [](double p) { return static_cast<float>((p * 32767.0 + 32768.0) / 65535.0); };
        CHECK(degrees_between(n, decoded({stored(row[5]), stored(row[6])}, "octahedral_rg16")) < 1e-4);
        ++rows;
    }
    CHECK(rows > 200);
}

TEST_CASE("plain texels keep their channels, and an alpha that is missing is 1", "[core][codec]")
{
    Picture raw({1, 1}, 3);
    raw.texels = {0.25f, 0.5f, 0.75f};
    CHECK(decode_texels(raw, Signal::radiance, *find_codec(Signal::radiance, "rgba16f")).texels == raw.texels);
    CHECK(decode_texels(raw, Signal::radiance_alpha, *find_codec(Signal::radiance_alpha, "rgba16f")).texels ==
          std::vector<float>{0.25f, 0.5f, 0.75f, 1.0f});
    raw = Picture({1, 1}, 1);
    raw.texels = {0.25f};
    CHECK(decode_texels(raw, Signal::radiance, *find_codec(Signal::radiance, "rgba16f")).texels == std::vector<float>{0.25f, 0.0f, 0.0f});
    raw = Picture({1, 1}, 4);
    raw.texels = {0.25f, 0.5f, 0.75f, 0.9f};
    CHECK(decode_texels(raw, Signal::mask, *find_codec(Signal::mask, "r8")).texels == std::vector<float>{0.25f});
}

TEST_CASE("guards bring every value into the signal's domain", "[core][signal]")
{
    CHECK(guarded(Signal::radiance, {kNan, kInfinity, -kInfinity, -1.0f, -0.0f, 0.5f, 65504.0f, 65536.0f, 3.0f}, 3) ==
          std::vector<float>{0, 65504, 0, 0, 0, 0.5f, 65504, 65504, 3});
    CHECK(guarded(Signal::display, {kNan, 2.0f, -1.0f, 0.5f}, 4) == std::vector<float>{0, 1, 0, 0.5f});
    CHECK(guarded(Signal::position, {kNan, kInfinity, -kInfinity, -5.0f, 3.4e38f, -3.4e38f}, 3) ==
          std::vector<float>{0, 0, 0, -5, 3.4e38f, -3.4e38f});
    CHECK(guarded(Signal::exposure, {kNan, kInfinity, -1.0f, 0.0f, 2.0f}, 1) == std::vector<float>{1, 65504, 1, 1, 2});
}

TEST_CASE("a guarded normal has length 1, and what has no direction faces the viewer", "[core][signal]")
{
    const std::vector<float> up = {0, 0, 1};
    for (const std::vector<float>& none : {std::vector<float>{0, 0, 0}, {kNan, 0, 1}, {kInfinity, 0, 0}, {3e38f, 3e38f, 0}})
        CHECK(guarded(Signal::normal, none, 3) == up);
    const auto unit = guarded(Signal::normal, {3, 0, -4}, 3);
    CHECK(unit[0] == Approx(0.6));
    CHECK(unit[2] == Approx(-0.8));
}
