// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "planner/chips.h"

using namespace lumi::planner;

namespace
{

uint64_t misses_of(const CacheShape& shape, const std::vector<uint32_t>& addresses)
{
    CacheModel cache(shape);
    for (const uint32_t address : addresses) cache.read({address, 1});
    return cache.misses();
}

}  // namespace

TEST_CASE("a line is missed once and then hit anywhere within it", "[bench]")
{
    CHECK(misses_of({64, 2, 8}, {0, 7, 3, 8, 15, 0}) == 2);
}

TEST_CASE("two lines of a set stay in two ways, a third one drives out the least recently used", "[bench]")
{
    // 64 bytes in 2 ways of 8: four sets, so that addresses 32 apart share one.
    CHECK(misses_of({64, 2, 8}, {0, 32, 0, 32}) == 2);
    CHECK(misses_of({64, 2, 8}, {0, 32, 0, 64, 0}) == 3);       // 64 replaces 32
    CHECK(misses_of({64, 2, 8}, {0, 32, 0, 64, 0, 32}) == 4);   // which is missed again
    CHECK(misses_of({64, 2, 8}, {0, 32, 64, 0, 32, 64}) == 6);  // three in turn never hit
}

TEST_CASE("a fully associative cache holds any lines", "[bench]")
{
    CHECK(misses_of({32, 4, 8}, {0, 32, 64, 96, 0, 32, 64, 96}) == 4);
    CHECK(misses_of({32, 4, 8}, {0, 32, 64, 96, 128, 0}) == 6);
}

TEST_CASE("a read across a border touches both lines", "[bench]")
{
    CacheModel cache({64, 2, 8});
    cache.read({7, 2});
    CHECK(cache.misses() == 2);
    for (const uint32_t address : {32u, 64u, 0u}) cache.read({address, 1});
    CHECK(cache.misses() == 5);  // 32 and 64 drove 0 out
}
