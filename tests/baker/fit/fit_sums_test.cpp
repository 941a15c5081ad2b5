// SPDX-License-Identifier: MIT
#include "fit/fit_sums.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

namespace lumi::baker::testing
{

TEST_CASE("sums of node pairs do not depend on the order of what is added")
{
    std::vector<std::array<uint16_t, 2>> added;
    Sampler sampler(1, 0, 0);
    for (uint32_t k = 0; k < 20000; ++k) {
        sampler.start(k);
        const auto node = [&] { return static_cast<uint16_t>(sampler.next_1d() * static_cast<float>(kPatchNodes)); };
        const uint16_t a = node();
        added.push_back({a, node()});
    }
    std::map<std::pair<uint32_t, uint32_t>, int64_t> truth;
    NodePairs forwards, backwards;
    for (const auto& [a, b] : added) {
        truth[{std::min(a, b), std::max(a, b)}] += a + 2 * b;
        forwards.add(a, b, a + 2 * b);
    }
    std::reverse(added.begin(), added.end());
    for (const auto& [a, b] : added) backwards.add(b, a, a + 2 * b);
    forwards.sort();
    backwards.sort();
    std::vector<std::array<int64_t, 3>> first, second;
    forwards.each([&](uint32_t a, uint32_t b, int64_t sum) {
        CHECK(truth[{a, b}] == sum);
        first.push_back({a, b, sum});
    });
    backwards.each([&](uint32_t a, uint32_t b, int64_t sum) { second.push_back({a, b, sum}); });
    CHECK(first.size() == truth.size());
    CHECK(first == second);
}

}  // namespace lumi::baker::testing
