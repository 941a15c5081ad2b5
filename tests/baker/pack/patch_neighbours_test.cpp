// SPDX-License-Identifier: MIT
#include "pack/patch_neighbours.h"

#include <catch2/catch.hpp>

using namespace lumi;
using namespace lumi::baker;

namespace
{

using detail::format::kCrease;
using detail::format::kNoNeighbour;

// Two squares that share the side from b to d of the first, whose texels are those of two functions of the row.
template <class Left, class Right>
std::vector<std::array<uint16_t, 4>> neighbours(Left left, Right right, uint32_t see_through = 0, Gloss gloss = {})
{
    PatchMesh mesh;
    mesh.longest_edge = 1;
    for (const float y : {-0.25f, 0.25f})
        for (const float x : {-0.5f, 0.0f, 0.5f}) mesh.positions.push_back({x, y, 0});
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    mesh.patches = {{0, 1, 3, 4}, {1, 2, 4, 5}};
    mesh.see_through_patches = see_through;
    const FitShape shape(mesh, {16, 16}, {}, std::move(gloss));
    FieldParts parts{};
    for (size_t k = 0; k < parts.palette.size(); ++k) parts.palette[k].g = static_cast<uint8_t>(k);
    parts.texels.resize(shape.layout.texels);
    for (uint32_t p = 0; p < 2; ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        for (uint32_t t = 0; t < r.size(); ++t)
            parts.texels[r.begin + t] = static_cast<uint8_t>(p == 0 ? left(t / r.n) : right(t / r.n));
    }
    return patch_neighbours(shape, parts);
}

}  // namespace

TEST_CASE("a side along which the colours of two patches differ is a crease, once")
{
    const auto grey = [](uint32_t) { return 100; };
    const auto lighter = [](uint32_t) { return 130; };
    const auto found = neighbours(grey, lighter);
    REQUIRE(found.size() == 2);
    CHECK(found[0][3] == (2 | kCrease));  // across the side from b to d of triangle 1 lies triangle 2
    CHECK(found[1][1] == 1);              // and back
    for (const uint16_t other : {found[0][0], found[0][1], found[0][2], found[1][0], found[1][2], found[1][3]})
        CHECK(other == kNoNeighbour);
}

TEST_CASE("neither small differences nor the texture's own detail nor see-through patches make creases")
{
    const auto grey = [](uint32_t) { return 100; };
    const auto nearly = [](uint32_t) { return 110; };
    const auto chequers = [](uint32_t row) { return row % 2 == 0 ? 60 : 140; };
    const auto opposite = [](uint32_t row) { return row % 2 == 0 ? 140 : 60; };
    CHECK(neighbours(grey, nearly)[0][3] == 2);
    CHECK(neighbours(chequers, opposite)[0][3] == 2);
    CHECK(neighbours(
              grey, [](uint32_t) { return 200; }, 1)[0][3] == kNoNeighbour);
}

TEST_CASE("what a gloss map adds in the mean counts as colour of its patch")
{
    Gloss gloss;
    gloss.maps.resize(1);
    gloss.maps[0].gains = {0, GlossMap::kGainUnit, 0};
    gloss.maps[0].texels.assign(detail::format::kGlossMapBytes, 30);
    gloss.choices = {1, 0};
    gloss.normals.assign(6, {0, 0, 1});
    const auto grey = [](uint32_t) { return 100; };
    const auto lighter = [](uint32_t) { return 130; };
    CHECK(neighbours(grey, lighter, 0, gloss)[0][3] == 2);
    CHECK(neighbours(grey, grey, 0, gloss)[0][3] == (2 | kCrease));
}
