// SPDX-License-Identifier: MIT
// Holds the maps over mirrored directions that smooth surfaces of a field mirror (lumi/surface/format.h), and finds
// where a line to the mesh meets them, as core finds it for an eye (lumi/surface/detail/gloss.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lumi/surface/format.h"
#include "math/vec3.h"

namespace lumi::baker
{

struct PatchMesh;

struct GlossMap {
    static constexpr int kGainUnit = 64;  // a gain of 1 level a step

    std::array<uint8_t, 3> gains{};  // levels of a texel's steps, times kGainUnit
    std::vector<uint8_t> texels;     // with their border

    // One of those without.
    uint8_t texel(uint32_t k) const
    {
        using namespace detail::format;
        return texels[(k / kGlossSide + 1) * kGlossStride + k % kGlossSide + 1];
    }
};

struct Gloss {
    std::vector<GlossMap> maps;
    std::vector<uint8_t> choices;  // by patch: 0, or the number of its map from 1 on; empty where there are no maps
    std::vector<Vec3> normals;     // by vertex, of unit length; empty likewise

    bool is_there() const { return !maps.empty(); }
    bool has(uint32_t patch) const { return is_there() && choices[patch] != 0; }
};

template <class Io>
void fields(Io& io, GlossMap& map)
{
    io(map.gains[0], map.gains[1], map.gains[2], map.texels);
}
template <class Io>
void fields(Io& io, Gloss& gloss)
{
    io(gloss.maps, gloss.choices, gloss.normals);
}
// Whether all of it fits a mesh.
bool is_sound(const Gloss& gloss, const PatchMesh& mesh);

// The texels of a map around a mirrored direction, without its border, and their weights.
struct GlossTaps {
    std::array<uint16_t, 4> texels;
    std::array<float, 4> weights;
};

// A corner of a triangle.
struct GlossCorner {
    Vec3 position, normal;
    float weight;  // barycentric
};

// For an eye that looks at the sphere's centre.
GlossTaps gloss_taps(const std::array<GlossCorner, 3>& corners, const Vec3& eye);

// A map's texel in a column and a row, of which one may lie a texel beyond a side: there lies the mirrored texel of the
// same side of the octahedral square.
uint16_t gloss_texel(int column, int row);

// A map's texels with their border.
std::vector<uint8_t> bordered(const std::vector<uint8_t>& texels);

}  // namespace lumi::baker
