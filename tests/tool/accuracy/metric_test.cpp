// Distances of results from the truth.
#include <cmath>

#include "support/catch.hpp"
#include "tool/accuracy/ladder.hpp"

using namespace passgraph;
using namespace passgraph::accuracy;

namespace {

Truth truth_of_one(std::vector<double> value)
{
    const int components = static_cast<int>(value.size());
    return {{1, 1}, components, std::move(value)};
}

Picture result_of_one(std::vector<float> value)
{
    Picture picture({1, 1}, static_cast<int>(value.size()));
    picture.texels = std::move(value);
    return picture;
}

} // namespace

TEST_CASE("each distance measures what its name says", "[accuracy][metric]")
{
    CHECK(compare({.name = "", .unit = "", .distance = Distance::angle}, truth_of_one({0, 0, 1}), result_of_one({0, 1, 0})).largest == Approx(90.0));
    CHECK(compare({.name = "", .unit = "", .distance = Distance::relative}, truth_of_one({3, 4}), result_of_one({3, 4.5f})).largest == Approx(0.1));
    CHECK(compare({.name = "", .unit = "", .distance = Distance::relative, .is_per_component = true}, truth_of_one({3, 4}), result_of_one({3.3f, 4})).largest == Approx(0.1).epsilon(1e-6));
    CHECK(compare({.name = "", .unit = ""}, truth_of_one({1, 2}), result_of_one({1, 1.75f})).largest == 0.25);
    const Metric wrong{.name = "", .unit = "", .distance = Distance::is_wrong, .summary = Summary::mean, .tolerance = 0.01};
    CHECK(compare(wrong, truth_of_one({100}), result_of_one({100.9f})).error == 0.0);
    CHECK(compare(wrong, truth_of_one({100}), result_of_one({102})).error == 1.0);
    CHECK(compare(wrong, truth_of_one({100}), result_of_one({NAN})).error == 1.0);
}

TEST_CASE("what is not finite is counted apart and named as the worst", "[accuracy][metric]")
{
    const Truth truth{{4, 1}, 1, {1.0, 1.0, 1.0, 1.0}};
    Picture result({4, 1}, 1);
    result.texels = {1.0f, 1.5f, NAN, INFINITY};
    const Deviation deviation = compare({.name = "", .unit = ""}, truth, result);
    CHECK(deviation.non_finite == 0.5);
    CHECK(deviation.largest == 0.5);
    CHECK(deviation.mean == 0.25);
    CHECK(deviation.bias == 0.25);
    CHECK(deviation.worst[0] == 2);
}

TEST_CASE("the 99th percentile leaves one in a hundred out", "[accuracy][metric]")
{
    Truth truth{{200, 1}, 1, std::vector<double>(200, 0.0)};
    Picture result({200, 1}, 1);
    for (int x = 0; x < 200; ++x)
        result.at(x, 0) = static_cast<float>(x);
    const Deviation deviation = compare({.name = "", .unit = "", .summary = Summary::p99}, truth, result);
    CHECK(deviation.error == 197.0);
    CHECK(deviation.largest == 199.0);
    CHECK(deviation.worst[0] == 199);
}
