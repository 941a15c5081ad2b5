// SPDX-License-Identifier: MIT
#include "volume/volume.h"

#include <catch2/catch.hpp>

#include "support/volumes.h"
#include "volume/medium.h"

namespace lumi::baker
{

TEST_CASE("transfer function: it is linear between its points and level beyond them")
{
    const TransferFunction f({{-100, {0, 0, 1}, 2}, {0, {1, 0.5f, 0}, 6}, {50, {0, 0, 0}, 1}});
    CHECK(f.density(-1e6f) == 2);
    CHECK(f.density(-100) == 2);
    CHECK(f.density(-50) == 4);
    CHECK(f.density(0) == 6);
    CHECK(f.density(40) == 2);
    CHECK(f.density(1e6f) == 1);
    CHECK(f.colour(-25).r == 0.75f);
    CHECK(f.colour(-25).g == 0.375f);
    CHECK(f.colour(-25).b == 0.25f);
}

TEST_CASE("transfer function: the largest density of a range counts the points inside it")
{
    const TransferFunction f({{0, {}, 0}, {10, {}, 0}, {11, {}, 7}, {12, {}, 0}});
    CHECK(f.most_density(0, 10) == 0);
    CHECK(f.most_density(0, 20) == 7);
    CHECK(f.most_density(10.5f, 10.5f) == 3.5f);
    CHECK(f.most_density(11.5f, 30) == 3.5f);
}

TEST_CASE("majorants: along any ray each block's bound holds, and the parts lie end to end")
{
    const Volume volume = testing::smoke();
    const Majorants majorants(volume.grid, volume.transfer);
    const Medium medium(volume, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, 1);
    const Affine voxels = inverse(volume.grid.voxel_to_world);
    for (uint32_t r = 0; r < 300; ++r) {
        Sampler sampler(5, r, 0);
        const auto inside = [&] {
            const Vec2 xy = sampler.next_2d();
            return Vec3{xy.x - 0.5f, 0.85f * xy.y - 0.45f, 0.95f * sampler.next_1d() - 0.5f};
        };
        const Vec3 from = inside(), to = inside();
        const auto voxel = [&](const Vec3& p) {
            const auto v =
                point_of(voxels, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
            return Vec3{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
        };
        const VoxelRay ray = {voxel(from), voxel(to) - voxel(from)};
        float last = 0;
        majorants.walk(ray, 0, 1, [&](float t0, float t1, float most) {
            CHECK(t0 == last);
            CHECK(t1 > t0);
            for (int k = 0; k <= 8; ++k) {
                const float t = t0 + (t1 - t0) * static_cast<float>(k) / 8;
                CHECK(medium.density(from + (to - from) * t) <= most + 1e-4f);
            }
            last = t1;
            return true;
        });
        CHECK(last == 1);
    }
}

}  // namespace lumi::baker
