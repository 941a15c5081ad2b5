// SPDX-License-Identifier: MIT
#include "model/part_motion.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lumi::baker
{
namespace
{

constexpr double kRadians = static_cast<double>(kPi) / 180;

using Vec3d = std::array<double, 3>;

// A turn about an axis of unit length (Rodrigues' formula).
Affine turn_about(const Vec3d& axis, const Vec3d& pivot, double radians)
{
    const double c = std::cos(radians), s = std::sin(radians);
    const Vec3d cross_row[3] = {{0, -axis[2], axis[1]}, {axis[2], 0, -axis[0]}, {-axis[1], axis[0], 0}};
    Affine turn{};
    for (size_t row = 0; row < 3; ++row) {
        turn[row][3] = pivot[row];
        for (size_t k = 0; k < 3; ++k) {
            turn[row][k] = (row == k ? c : 0) + s * cross_row[row][k] + (1 - c) * axis[row] * axis[k];
            turn[row][3] -= turn[row][k] * pivot[k];
        }
    }
    return turn;
}

// A point by its height along an axis, and its distance from it.
struct AxialPlace {
    float height, distance;
};

// Points that turn all the way round count only where no others, farther out, lie around them: at the corners of the
// convex hull of their places.
std::vector<AxialPlace> outermost(std::vector<AxialPlace> places)
{
    std::sort(places.begin(), places.end(), [](const AxialPlace& a, const AxialPlace& b) {
        return a.height != b.height ? a.height < b.height : a.distance < b.distance;
    });
    std::vector<AxialPlace> hull;
    const auto is_inside = [&](const AxialPlace& next) {
        const AxialPlace &a = hull[hull.size() - 2], &b = hull.back();
        return (b.height - a.height) * (next.distance - a.distance) >=
               (b.distance - a.distance) * (next.height - a.height);
    };
    for (const AxialPlace& place : places) {
        while (hull.size() >= 2 && is_inside(place)) hull.pop_back();
        hull.push_back(place);
    }
    return hull;
}

void add_circles(const PartMovement& motion, const std::vector<Vec3>& corners, std::vector<Vec3>& points)
{
    constexpr int kSides = 64;  // of a polygon around each circle
    std::vector<AxialPlace> places;
    for (const Vec3& p : corners) {
        const float height = dot(p - motion.pivot, motion.axis);
        places.push_back({height, length(p - motion.pivot - motion.axis * height)});
    }
    const Frame frame(motion.axis);
    for (const AxialPlace& place : outermost(places)) {
        const float reach = place.distance / std::cos(kPi / kSides);
        for (int k = 0; k < kSides; ++k) {
            const float angle = 2 * kPi * static_cast<float>(k) / kSides;
            points.push_back(motion.pivot +
                             frame.to_world({reach * std::cos(angle), reach * std::sin(angle), place.height}));
        }
    }
}

void add_poses(const PartMovement& motion, const std::vector<Vec3>& corners, std::vector<Vec3>& points)
{
    constexpr double kStep = 3;  // degrees: between two of them a corner comes less than 1/2900 farther out
    const int steps = motion.slides ? 1 : static_cast<int>(std::ceil((motion.to - motion.from) / kStep));
    for (int k = 0; k <= steps; ++k) {
        const Affine pose = motion.pose(motion.from + (motion.to - motion.from) * k / std::max(steps, 1));
        for (const Vec3& p : corners) points.push_back(moved(pose, p));
    }
}

}  // namespace

Affine PartMovement::pose(double value_of_pose) const
{
    const Vec3d a = in_doubles(axis);
    if (!slides) return turn_about(a, in_doubles(pivot), value_of_pose * kRadians);
    Affine slide = kIdentity;
    for (size_t k = 0; k < 3; ++k) slide[k][3] = a[k] * value_of_pose;
    return slide;
}

std::vector<double> PartMovement::lit_poses(size_t count) const
{
    constexpr double kTurn = 360;
    if (lit_at) return {*lit_at};
    const double step = (is_limited ? to - from : kTurn) / static_cast<double>(count);
    const double first = is_limited ? from + step / 2 : 0;
    std::vector<double> poses;
    for (size_t k = 0; k < count; ++k) poses.push_back(first + step * static_cast<double>(k));
    return poses;
}

bool MovingParts::are_at_rest() const
{
    return std::all_of(
        motions.begin(), motions.end(), [](const PartMovement& m) { return m.value == 0; });
}

std::vector<Vec3> MovingParts::swept(const Mesh& mesh) const
{
    constexpr double kWholeTurn = 360;
    std::vector<Vec3> points;
    for (size_t k = 0; k < motions.size(); ++k) {
        std::vector<bool> is_corner(mesh.positions.size(), false);
        for (size_t t = 0; t < owners.size(); ++t)
            for (size_t c = 0; c < 3 && owners[t] == k + 1; ++c) is_corner[mesh.corners[t][c]] = true;
        std::vector<Vec3> corners;
        for (size_t v = 0; v < is_corner.size(); ++v)
            if (is_corner[v]) corners.push_back(mesh.positions[v]);
        const PartMovement& motion = motions[k];
        const bool goes_round = !motion.slides && (!motion.is_limited || motion.to - motion.from >= kWholeTurn);
        goes_round ? add_circles(motion, corners, points) : add_poses(motion, corners, points);
    }
    return points;
}

Mesh MovingParts::posed(Mesh mesh) const
{
    for (size_t k = 0; k < motions.size(); ++k) {
        if (motions[k].value == 0) continue;
        const Affine pose = motions[k].pose(motions[k].value);
        std::map<uint32_t, uint32_t> positions;  // the part's own copies: the body may share what it has
        std::map<int32_t, int32_t> normals;
        for (size_t t = 0; t < owners.size(); ++t) {
            for (size_t c = 0; c < 3 && owners[t] == k + 1; ++c) {
                uint32_t& corner = mesh.corners[t][c];
                const auto place = positions.emplace(corner, static_cast<uint32_t>(mesh.positions.size()));
                if (place.second) mesh.positions.push_back(moved(pose, Vec3(mesh.positions[corner])));
                corner = place.first->second;
                int32_t& normal = mesh.shading[t][c];
                if (normal == kNoIndex) continue;
                const auto way = normals.emplace(normal, static_cast<int32_t>(mesh.normals.size()));
                if (way.second)
                    mesh.normals.push_back(direction_of(pose, Vec3(mesh.normals[static_cast<size_t>(normal)])));
                normal = way.first->second;
            }
        }
    }
    return mesh;
}

}  // namespace lumi::baker
