// SPDX-License-Identifier: MIT
#include "mesh/outside.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/components.h"
#include "math/sampler.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "mesh/copies.h"
#include "mesh/cut_outs.h"
#include "mesh/sheets.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kDirections = 24;  // directions over each side of a triangle
constexpr uint32_t kPlaces = 4;       // places on a triangle that are tried before it counts as never seen
constexpr float kPlaceArea = 4e-4f;   // large triangles get one more place for each so many square radii
constexpr float kMaxPlaces = 1024;
constexpr uint32_t kTrianglesATask = 512;
constexpr float kAbove = 1e-4f;          // the rays' starts, in radii: sheets closer together count as one
constexpr double kMaxBothSides = 0.005;  // the share of what is seen that culling may lose; a wash basin has 0.015
constexpr float kWeldSteps = 1 << 17;    // vertices that round to the same 1/kWeldSteps radius are one
constexpr uint64_t kOutsideSeed = 0x6F757473;

// The shares of directions in which each side of a triangle is open to the outside.
struct Openness {
    float front = 0, back = 0;
    bool any() const { return front > 0 || back > 0; }
};

class Surveyor
{
public:
    // Borrows mesh and accelerator.
    Surveyor(const Mesh& mesh, const Accelerator& accelerator, const ViewCap& cap)
        : mesh_(mesh), accelerator_(accelerator), cap_(cap)
    {
    }

    Openness openness(uint32_t triangle) const
    {
        const Vec3 area = mesh_.area_vector(triangle);
        if (!(length(area) > 0)) return {};
        const Frame frame(normalized(area));
        Sampler sampler(kOutsideSeed, triangle, 0);
        const uint32_t places = kPlaces + static_cast<uint32_t>(std::min(kMaxPlaces, 0.5f * length(area) / kPlaceArea));
        for (uint32_t k = 0; k < places; ++k) {
            sampler.start(k);
            const Vec3 place = at(triangle, k == 0 ? Vec2{1.0f / 3, 1.0f / 3} : square_to_triangle(sampler.next_2d()));
            const Openness result = {open_share(place, frame, 1, sampler), open_share(place, frame, -1, sampler)};
            if (result.any()) return result;
        }
        return {};
    }

private:
    Vec3 at(uint32_t triangle, const Vec2& weights) const
    {
        const Vec3& a = mesh_.position(triangle, 0);
        return a + (mesh_.position(triangle, 1) - a) * weights.x + (mesh_.position(triangle, 2) - a) * weights.y;
    }

    float open_share(const Vec3& place, const Frame& frame, float side, Sampler& sampler) const
    {
        const Vec3 start = place + frame.normal * (side * kAbove);
        const Vec2 turn = sampler.next_2d();
        uint32_t open = 0;
        for (uint32_t k = 0; k < kDirections; ++k) {
            // A Fibonacci set on the hemisphere, turned at random; the lowest heights stay clear of the triangle.
            const float z = (static_cast<float>(k) + 0.25f + 0.5f * turn.y) / kDirections;
            const Vec3 local = direction_at(z, static_cast<float>(k) * 0.618034f + turn.x);
            const Vec3 outwards = frame.to_world(local * side);
            const bool seen = cap_.sees({start, -outwards}) && !accelerator_.blocked({start, outwards});
            open += seen ? 1u : 0u;
        }
        return static_cast<float>(open) / kDirections;
    }

    const Mesh& mesh_;
    const Accelerator& accelerator_;
    const ViewCap cap_;
};

class Welder
{
public:
    explicit Welder(Mesh& mesh) : mesh_(mesh) {}

    uint32_t add(const Vec3& p)
    {
        const auto step = [](float c) {
            return static_cast<uint64_t>(static_cast<int64_t>(std::lround(c * kWeldSteps)) & 0x1FFFFF);
        };
        const uint64_t key = step(p.x) << 42 | step(p.y) << 21 | step(p.z);
        const auto [found, added] = numbers_.emplace(key, static_cast<uint32_t>(mesh_.positions.size()));
        if (added) mesh_.positions.push_back(p);
        return found->second;
    }

private:
    Mesh& mesh_;
    std::unordered_map<uint64_t, uint32_t> numbers_;
};

// Welds all triangles; those that are degenerate then have equal corners.
Mesh all_welded(const Mesh& mesh)
{
    Mesh result;
    Welder welder(result);
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        result.corners.push_back(
            {welder.add(mesh.position(k, 0)), welder.add(mesh.position(k, 1)), welder.add(mesh.position(k, 2))});
    }
    return result;
}

std::vector<Openness> survey(const Mesh& mesh, const Accelerator& accelerator, const ViewCap& cap, Job& job)
{
    const uint32_t triangles = static_cast<uint32_t>(mesh.triangle_count());
    const Surveyor surveyor(mesh, accelerator, cap);
    std::vector<Openness> all(triangles);
    job.run((triangles + kTrianglesATask - 1) / kTrianglesATask, [&](uint32_t task) {
        const uint32_t end = std::min(triangles, (task + 1) * kTrianglesATask);
        for (uint32_t k = task * kTrianglesATask; k < end && !job.stopping(); ++k) all[k] = surveyor.openness(k);
    });
    return all;
}

// All triangles but the first that are seen at one place get equal corners. A wall between two bodies that touch is
// not seen; it stays double, so that both bodies stay closed.
void drop_seen_copies(Mesh& mesh, const std::vector<Openness>& open)
{
    const std::vector<uint32_t> first = first_copies(mesh);
    std::vector<bool> is_seen(open.size(), false);
    for (size_t k = 0; k < open.size(); ++k) is_seen[first[k]] = is_seen[first[k]] || open[k].any();
    for (size_t k = 0; k < open.size(); ++k)
        if (first[k] != k && is_seen[first[k]]) mesh.corners[k].fill(mesh.corners[k][0]);
}

// How much of a sheet is seen from which side of its first triangle: areas times openness.
struct Seen {
    double front = 0, back = 0;
    double total() const { return front + back; }
};

// Turns whole sheets; keeps components of which anything is seen.
class Turner
{
public:
    Turner(const Mesh& mesh, const std::vector<Openness>& open)
        : mesh_(mesh),
          sheets_(mesh),
          components_(mesh),
          seen_(mesh.triangle_count()),
          component_seen_(mesh.positions.size())
    {
        for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
            const double area = static_cast<double>(mesh.area(k));
            double front = area * static_cast<double>(open[k].front), back = area * static_cast<double>(open[k].back);
            component_seen_[components_.of(mesh.corners[k])] += front + back;
            const SheetPlace place = sheets_.of(k);
            if (place.reversed) std::swap(front, back);
            seen_[place.sheet].front += front;
            seen_[place.sheet].back += back;
        }
    }

    std::vector<Mesh::Corners> turned()
    {
        std::vector<Mesh::Corners> result;
        for (uint32_t k = 0; k < mesh_.triangle_count(); ++k) {
            Mesh::Corners corners = mesh_.corners[k];
            const SheetPlace place = sheets_.of(k);
            if (place.reversed != (seen_[place.sheet].back > seen_[place.sheet].front))
                std::swap(corners[1], corners[2]);
            if (component_seen_[components_.of(corners)] > 0 && !is_degenerate(corners)) result.push_back(corners);
        }
        return result;
    }

    // The share of all that is seen which culling of back faces would lose.
    double lost_share() const
    {
        double lost = 0, total = 0;
        for (const Seen& sheet : seen_) {
            lost += std::min(sheet.front, sheet.back);
            total += sheet.total();
        }
        return total > 0 ? lost / total : 0;
    }

private:
    const Mesh& mesh_;
    Sheets sheets_;
    Components components_;
    std::vector<Seen> seen_;              // by sheet
    std::vector<double> component_seen_;  // by component
};

// By vertex, the mean over the triangles around it by their area.
std::vector<float> vertex_openness(const Mesh& mesh, const std::vector<Openness>& open)
{
    std::vector<float> areas(mesh.positions.size(), 0), seen(mesh.positions.size(), 0);
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        for (const uint32_t v : mesh.corners[k]) {
            areas[v] += mesh.area(k);
            seen[v] += mesh.area(k) * std::max(open[k].front, open[k].back);
        }
    }
    for (size_t v = 0; v < areas.size(); ++v) seen[v] = areas[v] > 0 ? seen[v] / areas[v] : 0;
    return seen;
}

Outside outside_of(const Mesh& mesh, const Accelerator& accelerator, const ViewCap& cap, Job& job)
{
    const std::vector<Openness> open = survey(mesh, accelerator, cap, job);
    Outside result;
    job.run(1, [&](uint32_t) {
        result.mesh = all_welded(mesh);
        result.openness = vertex_openness(result.mesh, open);
        drop_seen_copies(result.mesh, open);
        Turner turner(result.mesh, open);
        std::vector<Mesh::Corners> turned = turner.turned();
        result.two_sided = turner.lost_share() > kMaxBothSides;
        result.mesh.corners = std::move(turned);
    });
    return result;
}

}  // namespace

Mesh welded(const Mesh& mesh)
{
    Mesh result = all_welded(mesh);
    std::vector<Mesh::Corners>& corners = result.corners;
    corners.erase(std::remove_if(corners.begin(), corners.end(), is_degenerate), corners.end());
    return result;
}

Outside outside_of(const SceneData& scene, Job& job, const ViewCap& cap)
{
    const std::optional<Mesh> cut = cut_out(scene);
    return cut ? outside_of(*cut, Accelerator(*cut), cap, job) : outside_of(scene.mesh, scene.accelerator, cap, job);
}

}  // namespace lumi::baker
