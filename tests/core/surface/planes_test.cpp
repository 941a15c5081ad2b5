// SPDX-License-Identifier: MIT
#include "surface/planes.h"

#include <catch2/catch.hpp>

using namespace lumi::detail;

namespace
{

// Coordinates as a plane holds them, u in the lower half, which borrows from the upper one.
uint32_t both(int32_t u, int32_t v)
{
    return (static_cast<uint32_t>(v) << 16) + static_cast<uint32_t>(u);
}

}  // namespace

TEST_CASE("a texture's steps of any size tell whether it is magnified")
{
    constexpr int32_t kLeast = -32768, kMost = 32767, kMagnified = 512;
    const int32_t others[] = {kLeast, kLeast + 1, -kMagnified - 1, -kMagnified,    -1,
                              0,      1,          kMagnified,      kMagnified + 1, kMost};
    uint32_t wrong = 0;
    for (const int32_t other : others) {
        for (int32_t v = kLeast; v <= kMost; ++v) {
            const auto fits = [](int32_t step) { return -kMagnified <= step && step <= kMagnified; };
            const bool expected = fits(other) && fits(v);
            const auto is_wrong = [&](uint32_t right, uint32_t down) {
                return is_magnified(right, down, kMagnified) != expected;
            };
            wrong += is_wrong(both(other, v), 0) ? 1u : 0u;
            wrong += is_wrong(both(v, other), 0) ? 1u : 0u;
            wrong += is_wrong(0, both(other, v)) ? 1u : 0u;
            wrong += is_wrong(0, both(v, other)) ? 1u : 0u;
        }
    }
    CHECK(wrong == 0);
}
