// Every term of the specular lobe and their products against 50-digit tables, for every model, over all rows.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

namespace {

// The tables' own advice for binary32: 5e-6 relative, 2e-5 where Beckmann's exponential takes part.
constexpr double kTerm = 5e-6;
constexpr double kBeckmann = 2e-5;
/// Below it binary32 has no relative precision, and llvmpipe flushes to 0.
constexpr double kSmallest = 2e-38;

std::vector<std::vector<float>> columns_of(const Table& table, const std::vector<std::string>& names)
{
    std::vector<std::vector<float>> rows;
    for (const auto& row : table.rows) {
        rows.emplace_back();
        for (const auto& name : names)
            rows.back().push_back(static_cast<float>(row[table.column(name)]));
    }
    return rows;
}

const std::vector<std::string> kCosines = {"roughness", "f0", "NoL", "NoV", "NoH", "VoH"};
const std::vector<std::string> kCommon = {"brdf.glsl"};
const std::string kAlphaSquared = "roughness * roughness * roughness * roughness";
const std::string kLight = "max(NoL, 0.0)";
const std::string kViewer = "max(NoV, 0.0)";
const std::string kRealCosines = "NoH * NoH, (1.0 - NoH) * (1.0 + NoH), 1.0, " + kAlphaSquared;

/// Checks that an expression gives a column, finite and never negative, in every row; `tolerance` is relative.
template <class Tolerance>
void check_column(const Table& table, const std::string& expression, const std::string& column, const Tolerance& tolerance)
{
    const auto got = evaluate(expression, kCommon, kCosines, columns_of(table, kCosines));
    REQUIRE(got.size() == table.rows.size());
    for (size_t i = 0; i < got.size(); ++i) {
        const double expected = table.rows[i][table.column(column)];
        CAPTURE(column, table.text[i][0], got[i][0], expected);
        CHECK(std::isfinite(got[i][0]));
        CHECK(got[i][0] >= 0.0f);
        CHECK(std::abs(got[i][0] - expected) <= tolerance(table.rows[i]) * std::abs(expected) + kSmallest);
    }
}

void check_column(const Table& table, const std::string& expression, const std::string& column, double tolerance)
{
    check_column(table, expression, column, [&](const auto&) { return tolerance; });
}

/// The items of the choices, in their order, with the columns of the tables.
struct Model {
    std::string terms; ///< distribution, fresnel, geometry, ggx_form, fresnel_power, beckmann_masking
    std::string g;     ///< column of G
    std::string whole; ///< column of the whole lobe, without its prefix
    bool is_beckmann;
};

const std::vector<Model> kModels = {
    {"Terms(0, 0, 0, 2, 1, 1)", "G_smith_corr_ggx", "smith_corr_ggx", false},
    {"Terms(0, 0, 1, 2, 1, 1)", "G_smith_sep_ggx", "smith_sep_ggx", false},
    {"Terms(0, 0, 2, 2, 1, 1)", "G_cooktorrance", "cooktorrance", false},
    {"Terms(0, 0, 3, 2, 1, 1)", "G_neumann", "neumann", false},
    {"Terms(0, 0, 4, 2, 1, 1)", "G_implicit", "implicit", false},
    {"Terms(1, 0, 0, 2, 1, 1)", "G_smith_corr_beck", "smith_corr_beck", true},
    {"Terms(1, 0, 1, 2, 1, 1)", "G_smith_sep_beck", "smith_sep_beck", true},
    {"Terms(1, 0, 1, 2, 1, 0)", "G_smith_sep_beckfit", "smith_sep_beckfit", true},
};

std::string visibility(const Model& model)
{
    const auto hidden = [&](const std::string& cosine) {
        return "hidden_of(" + model.terms + ", " + cosine + ", " + kAlphaSquared + ")";
    };
    return "visibility_of(" + model.terms + ", " + kLight + ", " + kViewer + ", NoH, VoH, " + hidden(kLight) + ", " +
           hidden(kViewer) + ")";
}

/// A surface that only mirrors, without make_surface's clamps, so that rows smoother than they allow count too.
std::string bare_surface(const std::string& terms)
{
    return "Surface(vec3(0.0), vec3(f0), vec3(f0), 0.0, 1.0, " + kAlphaSquared + ", Vz, hidden_of(" + terms + ", Vz, " + kAlphaSquared + "))";
}

} // namespace

TEST_CASE("each distribution is the table's, also as textbooks write it", "[passes][brdf][terms]")
{
    const Table table = read_table("brdf_terms.csv");
    // Where h is below the horizon the tables cut D off; here the whole product's factor n.l does.
    const std::string above = "NoH > 0.0 ? ";
    check_column(table, above + "ggx_distribution(" + kRealCosines + ") : 0.0", "D_ggx", kTerm);
    check_column(table, above + "beckmann_distribution(" + kRealCosines + ") : 0.0", "D_beckmann",
                 [&](const auto& row) { // exp magnifies its argument's 6 roundings by the argument, up to ln of 2^126
                     const double logarithm = -std::log(std::max(row[table.column("D_beckmann")], kSmallest));
                     return kBeckmann + 6.0 * kRounding * std::max(logarithm, 0.0);
                 });
    // The textbook's bracket magnifies the cosine's roundings; the table says by how much, per row.
    check_column(table, above + "ggx_textbook(NoH, " + kAlphaSquared + ") : 0.0", "D_ggx", [&](const auto& row) {
        return kTerm + 4.0 * std::abs(row[table.column("cond_D_ggx")]) * kRounding;
    });
}

TEST_CASE("each Fresnel term is the table's, with either power", "[passes][brdf][terms]")
{
    const Table table = read_table("brdf_terms.csv");
    check_column(table, "fresnel_schlick(f0, fresnel_weight(VoH, power_by_multiplications))", "F_schlick", kTerm);
    check_column(table, "fresnel_schlick(f0, fresnel_weight(VoH, power_by_pow))", "F_schlick", kTerm);
    check_column(table, "fresnel_exact(f0, VoH)", "F_exact", kTerm);
}

TEST_CASE("each geometry term is the table's", "[passes][brdf][terms]")
{
    const Table table = read_table("brdf_terms.csv");
    for (const Model& model : kModels)
        check_column(table, "4.0 * " + kLight + " * " + kViewer + " * " + visibility(model), model.g, kTerm);
}

TEST_CASE("each whole specular lobe is the table's", "[passes][brdf][terms]")
{
    const Table table = read_table("brdf_terms.csv");
    for (const Model& model : kModels) {
        const std::string density = model.is_beckmann ? "beckmann_distribution(" : "ggx_distribution(";
        check_column(table,
                     "NoL > 0.0 && NoV > 0.0 ? fresnel_schlick(f0, fresnel_weight(VoH, 1)) * " + density + kRealCosines +
                         ") * " + visibility(model) + " : 0.0",
                     "spec_" + model.whole, [&](const auto& row) {
                         const double logarithm = -std::log(std::max(row[table.column("D_beckmann")], kSmallest));
                         return model.is_beckmann ? kBeckmann + 6.0 * kRounding * std::max(logarithm, 0.0) : 2.0 * kTerm;
                     });
    }
}

TEST_CASE("the lobe of two directions is the table's, for every model and form", "[passes][brdf][terms]")
{
    const Table table = read_table("brdf_vectors.csv");
    const std::vector<std::string> names = {"roughness", "f0", "Vx", "Vy", "Vz", "Lx", "Ly", "Lz"};
    const auto rows = columns_of(table, names);
    const auto check = [&](const Model& model, const std::string& terms, int form) {
        const auto got = evaluate("reflected(" + bare_surface(terms) + ", vec3(0.0, 0.0, 1.0), "
                                  "vec3(Vx, Vy, Vz), vec3(Lx, Ly, Lz), " + terms + ").x",
                                  {"brdf.glsl"}, names, rows);
        for (size_t i = 0; i < got.size(); ++i) {
            const auto& row = table.rows[i];
            const double expected = row[table.column("specNoL_" + model.whole)];
            CAPTURE(model.whole, form, table.text[i][0], table.text[i][1], got[i][0], expected);
            CHECK(std::isfinite(got[i][0]));
            CHECK(got[i][0] >= 0.0f);
            if (row[table.column("Vz")] <= 0.0)
                continue; // the tables' policy for a viewer at the horizon is 0; ours, in make_surface, is the limit
            // Directions of binary32 are of length 1 within 2^-24; from the cosine alone D loses 4 / alpha^2 of that, and
            // Beckmann's exponent is as steep: tan^2 / alpha^2 with 8 roundings.
            const double roughness = row[table.column("roughness")];
            const double cosine = row[table.column("NoH")];
            const double alpha_squared = std::pow(roughness, 4.0);
            const double bracket = cosine * cosine * (alpha_squared - 1.0) + 1.0;
            const double magnified = form == 2 ? 0.0 : 8.0 * kRounding * cosine * cosine / bracket;
            const double steep = !model.is_beckmann ? 0.0 : 16.0 * kRounding * (1.0 - cosine * cosine) / (cosine * cosine * alpha_squared);
            CHECK(std::abs(got[i][0] - expected) <= (2e-5 + magnified + steep) * expected + kSmallest);
        }
    };
    for (const Model& model : kModels)
        check(model, model.terms, 2);
    for (const int form : {0, 1})
        check(kModels[0], "Terms(0, 0, 0, " + std::to_string(form) + ", 1, 1)", form);
}

TEST_CASE("the exact Fresnel term takes a cosine beyond its range for the nearest, and none for grazing", "[passes][brdf]")
{
    const auto got = evaluate("fresnel_exact(f0, cosine)", {"fresnel.glsl"}, {"f0", "cosine"},
                              {{0.04f, 0.0f}, {0.04f, -0.5f}, {0.04f, NAN}, {0.04f, -INFINITY}, {0.04f, 1.0f}, {0.04f, 1.5f}, {0.04f, INFINITY}});
    for (size_t i = 1; i < 4; ++i)
        CHECK(got[i][0] == got[0][0]);
    for (size_t i = 5; i < 7; ++i)
        CHECK(got[i][0] == got[4][0]);
    CHECK(got[0][0] == Approx(1.0).epsilon(1e-5));
    CHECK(got[4][0] == Approx(0.04).epsilon(1e-5));
}
