// SPDX-License-Identifier: MIT
#include "fit/fit_shape.h"

#include <catch2/catch.hpp>

#include "lumi/baker/bake.h"
#include "lumi/surface/format.h"

namespace lumi::baker::testing
{
namespace
{

// Pairs of many sizes, and lone triangles between them.
PatchMesh strips()
{
    PatchMesh mesh;
    for (uint32_t k = 0; k < 40; ++k) {
        const float wide = 0.01f * static_cast<float>(1 + k * 7 % 23), high = 0.02f * static_cast<float>(1 + k % 11);
        const uint32_t first = 4 * k;
        mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {wide, 0, 0}, {0, high, 0}, {wide, high, 0}});
        mesh.patches.push_back({first, first + 1, first + 2, k % 3 == 0 ? PatchMesh::kNone : first + 3});
    }
    return mesh;
}

}  // namespace

TEST_CASE("rectangles of texels do not overlap and all that a reader may read is there")
{
    const TexelLayout layout = layout_of(strips(), 150);
    std::vector<int> owners(layout.texels, 0);
    uint32_t used = 0;
    for (const PatchRectangle& r : layout.rectangles) {
        CHECK(r.n >= 1);
        CHECK(r.n <= detail::format::kMaxPatchSide);
        CHECK(r.m >= 1);
        CHECK(r.m <= detail::format::kMaxPatchSide);
        REQUIRE(r.begin + detail::format::patch_reach(r.n) <= layout.texels);
        for (uint32_t k = 0; k < r.size(); ++k) ++owners[r.begin + k];
        used += r.size();
    }
    CHECK(*std::max_element(owners.begin(), owners.end()) == 1);
    CHECK(layout.texels - used <= 2 * detail::format::patch_reach(1));
}

TEST_CASE("corners of a patch lie in the corners of its rectangle")
{
    const PatchRectangle r = {100, 7, 5};
    CHECK(texel_at(r, false, 0, 0) == 100);
    CHECK(texel_at(r, false, 1, 0) == 106);
    CHECK(texel_at(r, false, 0, 1) == 128);
    CHECK(texel_at(r, true, 0, 0) == 134);  // d
    CHECK(texel_at(r, true, 1, 0) == 128);  // c
    CHECK(texel_at(r, true, 0, 1) == 106);  // b
}

TEST_CASE("both triangles of a patch have the same texels along their diagonal")
{
    const PatchRectangle r = {0, 13, 9};
    for (int k = 0; k < 100; ++k) {
        const float from_b = (static_cast<float>(k) + 0.37f) / 100;  // to c
        CHECK(texel_at(r, false, 1 - from_b, from_b) == texel_at(r, true, from_b, 1 - from_b));
    }
}

TEST_CASE("more texels than the format holds are refused by name, but may be counted")
{
    constexpr size_t kPatches = 400;
    PatchMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.patches.assign(kPatches, {0, 1, 2, PatchMesh::kNone});
    CHECK_THROWS_AS(layout_of(mesh, 100), BakeError);
    CHECK(unlimited_layout(mesh, std::vector<float>(kPatches, 100)).texels > detail::format::kMaxSurfaceTexels);
}

}  // namespace lumi::baker::testing
