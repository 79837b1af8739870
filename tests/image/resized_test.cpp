// Resampling: constants stay, brightness stays, nothing turns negative.
#include "support/catch.hpp"

#include <algorithm>
#include <numeric>

#include "image/scratch.hpp"

using passgraph::Extent;
using passgraph::Picture;
using passgraph::resized;

TEST_CASE("a constant picture stays constant at every size", "[image][resized]")
{
    const int channels = GENERATE(1, 2, 3, 4);
    const Extent extent = GENERATE(Extent{1, 1}, Extent{40, 3}, Extent{7, 50});
    Picture picture({17, 13}, channels);
    std::fill(picture.texels.begin(), picture.texels.end(), 0.75f);
    const Picture result = resized(picture, extent);
    CHECK(result.extent == extent);
    CHECK(result.channels == channels);
    for (const float value : result.texels)
        CHECK(value == Approx(0.75).epsilon(1e-5)); // the filter's weights sum to 1 within a few roundings
}

TEST_CASE("a picture resized to its own extent is itself", "[image][resized]")
{
    const Picture picture = gradient({9, 5}, 3);
    CHECK(resized(picture, {9, 5}).texels == picture.texels);
}

TEST_CASE("halving keeps the mean, and a lamp throws no negative ring", "[image][resized]")
{
    Picture picture({32, 32}, 1);
    picture.at(15, 17) = 1000.0f;
    const Picture half = resized(picture, {16, 16});
    CHECK(std::accumulate(half.texels.begin(), half.texels.end(), 0.0) == Approx(250.0).epsilon(1e-4));
    CHECK(*std::min_element(half.texels.begin(), half.texels.end()) >= 0.0f);
    const Picture doubled = resized(picture, {64, 64});
    CHECK(*std::min_element(doubled.texels.begin(), doubled.texels.end()) >= 0.0f);
}

TEST_CASE("the bottom row stays at the bottom", "[image][resized]")
{
    Picture picture({4, 4}, 1);
    std::fill_n(picture.texels.begin(), 8, 1.0f);
    const Picture result = resized(picture, {8, 8});
    CHECK(result.at(3, 0) == Approx(1.0));
    CHECK(result.at(3, 7) == Approx(0.0).margin(1e-6));
}
