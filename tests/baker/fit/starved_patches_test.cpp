// SPDX-License-Identifier: MIT
#include "fit/starved_patches.h"

#include <catch2/catch.hpp>

namespace lumi::baker::testing
{
namespace
{

// Squares in a row, side by side but for the last one, which lies apart.
FitShape row_of_squares(uint32_t count)
{
    PatchMesh mesh;
    for (uint32_t k = 0; k <= count + 1; ++k) {
        const float x = 0.1f * static_cast<float>(k) - 0.5f;
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x, 0.1f, 0}});
    }
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t left = 2 * (k + 1 == count ? k + 1 : k);
        mesh.patches.push_back({left, left + 2, left + 1, left + 3});
    }
    mesh.longest_edge = 0.15f;
    return FitShape(std::move(mesh), std::vector<float>(count, 40));
}

}  // namespace

TEST_CASE("patches that no path met take the colour of those around, and others keep theirs", "[surface]")
{
    constexpr LevelColour kRed = {200, 40, 30}, kWhite = {255, 255, 255}, kNothing = {0, 0, 0};
    const FitShape shape = row_of_squares(5);
    std::vector<LevelColour> texels(shape.layout.texels, kNothing);
    std::vector<uint32_t> counts(shape.layout.texels, 0);
    const auto set = [&](uint32_t patch, const LevelColour& colour, uint32_t paths) {
        const PatchRectangle& r = shape.layout.rectangles[patch];
        std::fill_n(texels.begin() + r.begin, r.size(), colour);
        std::fill_n(counts.begin() + r.begin, r.size(), paths);
    };
    set(0, kRed, 50);
    set(3, kRed, 50);
    const PatchRectangle& second = shape.layout.rectangles[1];
    set(1, kWhite, 0);  // a splinter, of one path
    counts[second.begin] = 1;
    fill_starved_patches(shape, counts, texels);
    const auto colour = [&](uint32_t patch, uint32_t texel) {
        return texels[shape.layout.rectangles[patch].begin + texel];
    };
    CHECK(colour(0, 0) == kRed);
    CHECK(colour(3, 0) == kRed);
    CHECK(colour(1, 0)[1] < 200);  // was 255
    CHECK(colour(1, 1)[1] < 160);
    CHECK(colour(2, 0)[0] > 190);
    CHECK(colour(4, 0) == kNothing);  // nothing is around it
}

}  // namespace lumi::baker::testing
