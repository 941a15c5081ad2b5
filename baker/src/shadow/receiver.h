// SPDX-License-Identifier: MIT
// The flat piece of a scene on which a moving part throws its shadow, and a grid of places on it.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene_data.h"

namespace lumi::baker
{

inline constexpr float kFlatReceiver = 0.01f;  // radii: a receiver strays by no more

// The plane of a receiver, and a frame in it that turns with the part: v along the part's length.
struct Receiver {
    Vec3 origin, u, v, normal;  // the axis meets the plane at the origin; the normal looks to the part
    float gap = 0;              // from there to the part

    Vec3 at(const Vec2& p) const { return origin + u * p.x + v * p.y; }
    Vec2 of(const Vec3& p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
};

// Nothing if what lies before neither end of the axis is flat; else the nearer one. `corners` are the part's.
std::optional<Receiver> receiver_of(const SceneData& body, const PartMovement& movement,
                                    const std::vector<Vec3>& corners);

// A grid of points of the receiver.
struct ShadowGrid {
    Vec2 low, cell;
    uint32_t columns = 0, rows = 0;

    Vec2 middle(uint32_t k) const
    {
        return {low.x + (static_cast<float>(k % columns) + 0.5f) * cell.x,
                low.y + (static_cast<float>(k / columns) + 0.5f) * cell.y};
    }
    uint32_t size() const { return columns * rows; }
    bool is_border(uint32_t k) const
    {
        const uint32_t x = k % columns, y = k / columns;
        return x == 0 || y == 0 || x + 1 == columns || y + 1 == rows;
    }
};

// Around the part, with no more columns than rows. most_texels >= kFewestCells squared.
inline constexpr uint32_t kFewestCells = 4;  // a side
ShadowGrid grid_around(const std::vector<Vec3>& corners, const Receiver& receiver, uint32_t most_texels);

// A value between the grid's points; 0 outside.
float value_at(const std::vector<float>& values, const ShadowGrid& grid, const Vec2& p);

}  // namespace lumi::baker
