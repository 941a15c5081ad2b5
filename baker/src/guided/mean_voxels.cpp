// SPDX-License-Identifier: MIT
#include "guided/mean_voxels.h"

#include "image/k_means.h"

namespace lumi::baker
{
namespace
{

constexpr float kThickness = 1.0f / 128;  // radii to each side of the surface
constexpr uint64_t kPaletteSeed = 0x6D65616E;
constexpr size_t kPalettePoints = 16384;  // that the palette is fitted to
constexpr uint32_t kBrickSide = 4;

ColourPoint to_point(const Levels& c)
{
    return {c.r, c.g, c.b, 0};
}

uint8_t to_byte(float level)
{
    return static_cast<uint8_t>(std::clamp(std::lround(level), 0L, 255L));
}

Rgb8 to_bytes(const Levels& c)
{
    return {to_byte(c.r), to_byte(c.g), to_byte(c.b)};
}

Levels to_levels(const Rgb8& c)
{
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

std::vector<ColourPoint> fitted_palette(const std::vector<Levels>& colours)
{
    std::vector<ColourPoint> points;
    const size_t step = colours.size() / kPalettePoints + 1;
    for (size_t k = 0; k < colours.size(); k += step) {
        points.push_back(to_point(colours[k]));
    }
    std::vector<ColourPoint> centres = k_means(points, {}, format::kPaletteEntries, kPaletteSeed);
    for (ColourPoint& c : centres) {
        for (float& channel : c) {
            channel = static_cast<float>(to_byte(channel));
        }
    }
    return centres;
}

// The value that stands for each node's colour; colours become what those values mean.
std::vector<uint16_t> encoded(std::vector<Levels>& colours, format::MeanFormat format, std::vector<Rgb8>& palette)
{
    std::vector<uint16_t> values;
    values.reserve(colours.size());
    if (format == format::MeanFormat::rgb565) {
        for (Levels& c : colours) {
            values.push_back(pack_rgb565(to_bytes(c)));
            c = to_levels(unpack_rgb565(values.back()));
        }
        return values;
    }
    const std::vector<ColourPoint> centres = fitted_palette(colours);
    for (const ColourPoint& c : centres) {
        palette.push_back(to_bytes({c[0], c[1], c[2]}));
    }
    for (Levels& c : colours) {
        values.push_back(static_cast<uint16_t>(nearest_centre(centres, to_point(c)).index));
        c = to_levels(palette[values.back()]);
    }
    return values;
}

struct Box {
    std::array<uint32_t, 3> first = {~0u, ~0u, ~0u}, end = {0, 0, 0};  // bricks
};

std::array<uint32_t, 3> coordinates(const NodeGrid& grid, size_t node)
{
    const uint32_t place = grid.place(node), side = grid.side();
    return {place % side, place / side % side, place / side / side};
}

Box box_of(const NodeGrid& grid)
{
    Box box;
    for (size_t node = 0; node < grid.size(); ++node) {
        const std::array<uint32_t, 3> at = coordinates(grid, node);
        for (size_t axis = 0; axis < 3; ++axis) {
            box.first[axis] = std::min(box.first[axis], at[axis] / kBrickSide);
            box.end[axis] = std::max(box.end[axis], at[axis] / kBrickSide + 1);
        }
    }
    return grid.size() == 0 ? Box{{0, 0, 0}, {1, 1, 1}} : box;
}

// The values of a brick; nodes that the grid lacks take the one before them.
bool brick_values(const NodeGrid& grid, const std::array<uint32_t, 3>& brick, const std::vector<uint16_t>& values,
                  std::vector<uint16_t>& out)
{
    uint16_t nodes[format::kBrickNodes];
    uint16_t last = 0;
    bool any = false;
    const auto number = [&](uint32_t k) {
        const uint32_t x = brick[0] * kBrickSide + k % 4, y = brick[1] * kBrickSide + k / 4 % 4,
                       z = brick[2] * kBrickSide + k / 16;
        return std::max({x, y, z}) < grid.side() ? grid.at(x, y, z) : NodeGrid::kNone;
    };
    // Twice: the nodes before the first one take the last one's.
    for (uint32_t k = 0; k < 2 * format::kBrickNodes; ++k) {
        const uint32_t node = number(k % format::kBrickNodes);
        any = any || node != NodeGrid::kNone;
        last = node != NodeGrid::kNone ? values[node] : last;
        nodes[k % format::kBrickNodes] = last;
    }
    if (any) {
        out.insert(out.end(), std::begin(nodes), std::end(nodes));
    }
    return any;
}

}  // namespace

NodeGrid::NodeGrid(const Mesh& surface, uint32_t resolution)
    : resolution_(resolution), numbers_(size_t{side()} * side() * side(), kNone)
{
    for (size_t k = 0; k < surface.triangle_count(); ++k) {
        const Vec3 area = surface.area_vector(k);
        const Vec3 normal = length(area) > 0 ? normalized(area) : Vec3{};
        for (const float offset : {-kThickness, 0.0f, kThickness}) {
            const Vec3 by = normal * offset;
            mark_triangle(surface.position(k, 0) + by, surface.position(k, 1) + by, surface.position(k, 2) + by);
        }
    }
}

NodeGrid::Cell NodeGrid::cell(const Vec3& x) const
{
    Cell result;
    const float coordinate[3] = {x.x, x.y, x.z};
    for (size_t axis = 0; axis < 3; ++axis) {
        const float at = std::clamp((coordinate[axis] + 1) * 0.5f, 0.0f, 1.0f) * static_cast<float>(resolution_);
        result.corner[axis] = static_cast<uint32_t>(at);
        result.part[axis] = at - static_cast<float>(result.corner[axis]);
    }
    return result;
}

void NodeGrid::mark(const Vec3& x)
{
    const Cell c = cell(x);
    for (uint32_t k = 0; k < 8; ++k) {
        const size_t place =
            (size_t{c.corner[2] + (k >> 2)} * side() + c.corner[1] + (k >> 1 & 1)) * side() + c.corner[0] + (k & 1);
        if (numbers_[place] == kNone) {
            numbers_[place] = static_cast<uint32_t>(places_.size());
            places_.push_back(static_cast<uint32_t>(place));
        }
    }
}

void NodeGrid::mark_triangle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const float step = 0.5f / static_cast<float>(resolution_);  // a quarter of a cell
    const float longest = std::max({length(b - a), length(c - a), length(c - b)});
    const int steps = 1 + static_cast<int>(longest / step);
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const float u = static_cast<float>(i) / static_cast<float>(steps);
            const float v = static_cast<float>(j) / static_cast<float>(steps);
            mark(a + (b - a) * u + (c - a) * v);
        }
    }
}

NodeGrid::Lookup NodeGrid::lookup(const Vec3& x) const
{
    const Cell c = cell(x);
    Lookup result;
    for (uint32_t k = 0; k < 8; ++k) {
        result.node[k] = at(c.corner[0] + (k & 1), c.corner[1] + (k >> 1 & 1), c.corner[2] + (k >> 2));
        result.weight[k] = 1;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            result.weight[k] *= (k >> axis & 1) != 0 ? c.part[axis] : 1 - c.part[axis];
        }
    }
    return result;
}

Levels trilinear(const NodeGrid& grid, const std::vector<Levels>& colours, const Vec3& x)
{
    const NodeGrid::Lookup found = grid.lookup(x);
    Levels sum;
    for (size_t k = 0; k < 8; ++k) {
        if (found.node[k] != NodeGrid::kNone) {
            sum = sum + colours[found.node[k]] * found.weight[k];
        }
    }
    return sum;
}

PackedMean packed_mean(const NodeGrid& grid, std::vector<Levels>& colours, format::MeanFormat format)
{
    PackedMean mean;
    mean.resolution = grid.resolution();
    mean.format = format;
    const std::vector<uint16_t> values = encoded(colours, format, mean.palette);
    const Box box = box_of(grid);
    for (size_t axis = 0; axis < 3; ++axis) {
        mean.first_brick[axis] = static_cast<uint8_t>(box.first[axis]);
        mean.box[axis] = static_cast<uint8_t>(box.end[axis] - box.first[axis]);
    }
    uint16_t bricks = 0;
    for (uint32_t z = box.first[2]; z < box.end[2]; ++z) {
        for (uint32_t y = box.first[1]; y < box.end[1]; ++y) {
            for (uint32_t x = box.first[0]; x < box.end[0]; ++x) {
                bricks = static_cast<uint16_t>(bricks + (brick_values(grid, {x, y, z}, values, mean.bricks) ? 1 : 0));
                // Where no brick is, one before it stands in.
                mean.index.push_back(static_cast<uint16_t>(bricks == 0 ? 0 : bricks - 1));
            }
        }
    }
    if (bricks == 0) {
        mean.bricks.assign(format::kBrickNodes, 0);
    }
    return mean;
}

}  // namespace lumi::baker
