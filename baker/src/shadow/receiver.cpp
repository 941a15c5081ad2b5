// SPDX-License-Identifier: MIT
#include "shadow/receiver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

constexpr float kFarthest = 0.5f;  // of the part's reach: a receiver farther off gets no shadow that shows

// Nothing if what lies on that side of the part is not flat.
std::optional<Receiver> receiver_towards(const SceneData& body, const PartMovement& movement,
                                         const std::vector<Vec3>& corners, float side)
{
    constexpr int kRings = 8, kSpokes = 24;
    constexpr float kAbove = 1e-3f;
    constexpr double kMostOfAll = 0.6;
    Receiver receiver;
    receiver.normal = movement.axis * side;
    float lowest = std::numeric_limits<float>::infinity(), reach = 0;
    for (const Vec3& p : corners) {
        const float height = dot(p - movement.pivot, receiver.normal);
        lowest = std::min(lowest, height);
        reach = std::max(reach, length(p - movement.pivot - receiver.normal * height));
    }
    if (!(reach > 0)) return std::nullopt;
    const Frame frame(receiver.normal);
    std::vector<float> depths;
    for (int k = 0; k < kRings * kSpokes; ++k) {
        const float r = reach * (static_cast<float>(k % kRings) + 1) / kRings;
        const float angle = 2 * kPi * static_cast<float>(k / kRings) / kSpokes;
        const Vec3 from = movement.pivot + frame.to_world({r * std::cos(angle), r * std::sin(angle), lowest + kAbove});
        const std::optional<Hit> hit = body.accelerator.closest({from, -receiver.normal});
        if (hit && hit->distance < kFarthest * reach + kAbove) depths.push_back(hit->distance - kAbove);
    }
    if (static_cast<double>(depths.size()) < kMostOfAll * kRings * kSpokes) return std::nullopt;
    std::nth_element(depths.begin(), depths.begin() + static_cast<ptrdiff_t>(depths.size() / 2), depths.end());
    receiver.gap = depths[depths.size() / 2];
    const auto flat = std::count_if(depths.begin(), depths.end(),
                                    [&](float d) { return std::abs(d - receiver.gap) <= kFlatReceiver; });
    if (receiver.gap <= 0 || static_cast<double>(flat) < kMostOfAll * kRings * kSpokes) return std::nullopt;
    receiver.origin = movement.pivot + receiver.normal * (lowest - receiver.gap);
    return receiver;
}

// A rectangle of the receiver.
struct Box {
    Vec2 low, high;

    Vec2 size() const { return {high.x - low.x, high.y - low.y}; }
};

Box box_of(const std::vector<Vec3>& corners, const Receiver& receiver)
{
    Box box = {{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (const Vec3& corner : corners) {
        const Vec2 p = receiver.of(corner);
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

// Turns the frame so that v is the direction in which the corners lie most spread: what is read beyond a rectangle of
// texels grows with its columns.
void turn_along(const std::vector<Vec3>& corners, Receiver& receiver)
{
    const Frame frame(receiver.normal);
    receiver.u = frame.tangent;
    receiver.v = frame.bitangent;
    float uu = 0, uv = 0, vv = 0;
    for (const Vec3& corner : corners) {
        const Vec2 p = receiver.of(corner);
        uu += p.x * p.x;
        uv += p.x * p.y;
        vv += p.y * p.y;
    }
    const float angle = 0.5f * std::atan2(2 * uv, uu - vv);
    const auto turn_to = [&](const Vec3& u) {
        receiver.u = u;
        receiver.v = cross(receiver.normal, u);
    };
    turn_to(receiver.u * std::cos(angle) + receiver.v * std::sin(angle));
    const Vec2 size = box_of(corners, receiver).size();
    if (size.x > size.y) turn_to(receiver.v);
}

}  // namespace

std::optional<Receiver> receiver_of(const SceneData& body, const PartMovement& movement,
                                    const std::vector<Vec3>& corners)
{
    std::optional<Receiver> nearer;
    for (const float side : {1.0f, -1.0f}) {
        const std::optional<Receiver> one = receiver_towards(body, movement, corners, side);
        if (one && (!nearer || one->gap < nearer->gap)) nearer = one;
    }
    if (nearer) turn_along(corners, *nearer);
    return nearer;
}

ShadowGrid grid_around(const std::vector<Vec3>& corners, const Receiver& receiver, uint32_t most_texels)
{
    constexpr float kMargin = 2.5f, kCell = 0.4f;  // gaps
    constexpr float kCoarser = 1.1f;
    const Box box = box_of(corners, receiver);
    const float margin = kMargin * receiver.gap;
    const Vec2 size = {box.size().x + 2 * margin, box.size().y + 2 * margin};
    const auto cells = [](float side, float cell) {
        return static_cast<uint32_t>(
            std::clamp(std::ceil(side / cell), float{kFewestCells}, float{detail::format::kMaxPatchSide}));
    };
    ShadowGrid grid;
    float cell = kCell * receiver.gap;
    do {
        grid.columns = cells(size.x, cell);
        grid.rows = cells(size.y, cell);
        cell *= kCoarser;
    } while (grid.size() > most_texels);
    grid.low = {box.low.x - margin, box.low.y - margin};
    grid.cell = {size.x / static_cast<float>(grid.columns), size.y / static_cast<float>(grid.rows)};
    return grid;
}

float value_at(const std::vector<float>& values, const ShadowGrid& grid, const Vec2& p)
{
    const float x = (p.x - grid.low.x) / grid.cell.x - 0.5f, y = (p.y - grid.low.y) / grid.cell.y - 0.5f;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    float sum = 0;
    for (int k = 0; k < 4; ++k) {
        const int c = column + k % 2, r = row + k / 2;
        if (c < 0 || r < 0 || c >= static_cast<int>(grid.columns) || r >= static_cast<int>(grid.rows)) continue;
        const float right = x - static_cast<float>(column), below = y - static_cast<float>(row);
        const float weight = (k % 2 == 0 ? 1 - right : right) * (k / 2 == 0 ? 1 - below : below);
        sum += weight * values[static_cast<size_t>(r) * grid.columns + static_cast<size_t>(c)];
    }
    return sum;
}

}  // namespace lumi::baker
