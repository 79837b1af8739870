// Hard normals through every codec, and normals and depths that no filter may touch.
#include <cmath>

#include <passgraph/core/codec.hpp>
#include <passgraph/shader/pass_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

using Vector = std::array<double, 3>;

/// Degrees between two vectors, without acos, which is blind below 0.02 degrees in binary32.
double angle(const Vector& a, const Vector& b)
{
    const Vector cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double sine = std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
    return std::atan2(sine, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 57.29577951308232;
}

Vector unit(double x, double y, double z)
{
    const double length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}

/// What a normal comes back as after being stored with a codec.
std::vector<Vector> stored(const std::vector<Vector>& normals, const std::string& codec)
{
    static const PassLibrary library = [] {
        PassLibrary made = builtin_passes();
        const auto pass = read_pass(R"(/*{ "pass": "hold", "summary": "", "source": "", "inputs": { "facing": "normal" },
  "outputs": { "held": "normal" } }*/
vec3 hold(vec2 uv) { return facing(uv); }
)",
                                    "hold.glsl", "test", {});
        REQUIRE(pass);
        made.add(*pass);
        return made;
    }();
    Picture picture({static_cast<int>(normals.size()), 1}, 3);
    for (size_t i = 0; i < normals.size(); ++i)
        for (size_t c = 0; c < 3; ++c)
            picture.texels[i * 3 + c] = static_cast<float>(normals[i][c]);
    const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "facing": "normal" },
  "passes": { "held": { "pass": "hold", "inputs": { "facing": "facing" }, "codecs": { "held": ")" + codec + R"(" } } },
  "outputs": { "held": "held" } })",
                                 library);
    const Picture held = run_graph(graph, {.pictures = {{"facing", picture}}}).at("held");
    std::vector<Vector> result;
    for (int x = 0; x < held.extent.width; ++x)
        result.push_back({held.at(x, 0, 0), held.at(x, 0, 1), held.at(x, 0, 2)});
    return result;
}

/// The directions on which encodings stumble: poles, axes, edges of the fold, and all around close to the far pole.
std::vector<Vector> hard_normals()
{
    std::vector<Vector> all;
    for (const double sign : {1.0, -1.0}) {
        all.push_back({sign, 0.0, 0.0});
        all.push_back({0.0, sign, 0.0});
        all.push_back({0.0, 0.0, sign});
        for (const double other : {1.0, -1.0}) {
            all.push_back(unit(sign, other, 1e-5));
            all.push_back(unit(sign, other, -1e-5));
            all.push_back(unit(sign, 0.0, 0.5 * other));
            all.push_back(unit(0.0, sign, 0.5 * other));
        }
    }
    for (int i = 0; i < 8; ++i)
        all.push_back(unit(4.5e-4 * std::cos(i), 4.5e-4 * std::sin(i), -1.0)); // z = -1 + 1e-7
    return all;
}

} // namespace

TEST_CASE("hard normals come back from every codec with length 1 and near where they were", "[catalogue][normal]")
{
    // Degrees. Octahedral: Cigolle et al. 2014, table 2, with 8 bits (0.95) and 16 bits (0.0037). Codes of 10 bits a component
    // and 511 steps: half a step each way is 0.5 / 511 * sqrt(3) radians. Halves: 2^-12 of each component.
    const std::map<std::string, double> bounds = {{"octahedral_rg16", 0.004}, {"octahedral_rg8", 0.95}, {"octahedral_rgb10", 0.24},
                                                  {"rgb10_a2", 0.098},        {"rgba16f", 0.0243},      {"rgba32f", 1e-5}};
    const std::vector<Vector> normals = hard_normals();
    for (const std::string& codec : codec_names(Signal::normal)) {
        if (codec.starts_with("sphere_map"))
            continue;
        const auto found = bounds.find(codec);
        const double bound = found == bounds.end() ? 1.0 : found->second; // a codec of 8 bits is within a degree
        const std::vector<Vector> back = stored(normals, codec);
        for (size_t i = 0; i < normals.size(); ++i) {
            INFO(codec << " of " << normals[i][0] << " " << normals[i][1] << " " << normals[i][2]);
            CHECK(angle(back[i], normals[i]) <= bound);
        }
    }
}

TEST_CASE("the sphere map loses sight of directions near -Z only, and holds -Z itself", "[catalogue][normal]")
{
    // f = n.xy / sqrt(2 n.z + 2) has length 2 sin(a / 2) for the angle a from +Z: near 180 degrees da = 2 df / (2 cos(a / 2)),
    // so that an error of half a code of 16 bits, 2 / 65535 in f, or of one rounding of binary32, 1.2e-7 in |f| = 2, becomes
    // sqrt(4 * error): 0.63 and 0.04 degrees.
    const std::map<std::string, double> bounds = {{"sphere_map_rg16", 0.8}, {"sphere_map_rg32f", 0.06}};
    const std::vector<Vector> normals = hard_normals();
    for (const auto& [codec, bound] : bounds) {
        const std::vector<Vector> back = stored(normals, codec);
        for (size_t i = 0; i < normals.size(); ++i) {
            INFO(codec << " of " << normals[i][0] << " " << normals[i][1] << " " << normals[i][2]);
            const double length = std::sqrt(back[i][0] * back[i][0] + back[i][1] * back[i][1] + back[i][2] * back[i][2]);
            CHECK(std::abs(length - 1.0) < 1e-3);
            CHECK(angle(back[i], normals[i]) <= bound);
        }
    }
}

TEST_CASE("no pass reads a normal, a place or a depth through a filter", "[catalogue][normal][depth]")
{
    int count = 0;
    for (const auto& [name, pass] : builtin_passes().passes())
        for (const InputPort& port : pass->inputs) {
            const bool is_surface = port.signal == Signal::normal || port.signal == Signal::position || port.signal == Signal::depth ||
                                    port.signal == Signal::atlas_uv;
            if (!is_surface || port.over != Over::image)
                continue;
            INFO(name << "." << port.name);
            CHECK(port.filter == Filter::nearest);
            CHECK(port.filter_by.empty());
            ++count;
        }
    CHECK(count >= 4);
}
