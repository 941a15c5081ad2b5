// SPDX-License-Identifier: MIT
// What the noise of few light paths costs a plan.
#include "planner/trials.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace lumi::planner
{

namespace
{

double psnr_of(double squared_error)
{
    return -10 * std::log10(squared_error);
}

}  // namespace

TEST_CASE("two trials tell how much noise the final bake is spared")
{
    // A blur of 0.004, and noise of 0.008 for the paths of a trial.
    const double few = psnr_of(0.004 + 0.008), twice = psnr_of(0.004 + 0.008 / 2);
    for (const double share : {1.0, 2.0, 8.0, 100.0})
        CHECK(noise_gain_db(few, twice, share) == Approx(psnr_of(0.004 + 0.008 / share) - few).margin(1e-9));
}

TEST_CASE("a layout is neither blamed for its noise nor praised beyond reason")
{
    CHECK(noise_gain_db(30, 30, 16) == 0);
    CHECK(noise_gain_db(30, 29.8, 16) == 0);           // by chance worse with more paths
    CHECK(noise_gain_db(30, 33.5, 16) == Approx(10));  // by chance better than without any noise
    CHECK(noise_gain_db(30, 31, 1) == 0);              // the final bake has no more paths
}

}  // namespace lumi::planner
