// SPDX-License-Identifier: MIT
#include "mesh/mesh_outline.h"

#include <tuple>

#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kOutlineSeed = 0x6F75746C;
constexpr float kAway = 2;                             // where rays start before an outline, in radii
constexpr float kBehind = kAway + kMaxDepthError;      // what they meet from here on belongs to something else
constexpr float kBeside = 1e-3f;                       // an edge's two sides are looked at so far from it; in radii
constexpr float kSpacing = 0.02f;                      // between points along an edge, in radii
constexpr float kFirstStep = 0.0025f, kReach = 0.04f;  // how the scene's outline is searched for
constexpr int kHalvings = 6;

bool is_covered(const std::optional<Hit>& hit)
{
    return hit && hit->distance < kBehind;
}

std::pair<uint32_t, uint32_t> ends_of(uint32_t from, uint32_t to)
{
    return {std::min(from, to), std::max(from, to)};
}

// Where covers(t) changes that is near 0: steps that double, then bisection.
template <class Covers>
std::optional<float> border_of(const Covers& covers)
{
    const bool inside = covers(0.0f);
    float near = 0, far = inside ? kFirstStep : -kFirstStep;
    while (covers(far) == inside) {
        near = far;
        far *= 2;
        if (std::abs(far) > kReach) return std::nullopt;
    }
    for (int k = 0; k < kHalvings; ++k) {
        const float middle = 0.5f * (near + far);
        (covers(middle) == inside ? near : far) = middle;
    }
    return 0.5f * (near + far);
}

}  // namespace

MeshOutline::MeshOutline(const SceneData& scene, const MeshTracer& tracer, const ViewCap& cap)
    : scene_(scene), tracer_(tracer), cap_(cap)
{
    const Mesh& mesh = tracer.mesh();
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        const Mesh::Corners& c = mesh.corners[k];
        for (size_t i = 0; i < 3; ++i) sides_.push_back({c[i], c[(i + 1) % 3], k});
    }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
        return std::tuple(ends_of(a.from, a.to), a.triangle) < std::tuple(ends_of(b.from, b.to), b.triangle);
    });
}

std::vector<OutlinePoint> MeshOutline::seen_from(const Vec3& eye, uint32_t seed) const
{
    std::vector<OutlinePoint> result;
    if (scene_.has_transparency || scene_.medium) return result;
    Sampler sampler(kOutlineSeed, seed, 0);
    for (auto begin = sides_.begin(), end = begin; begin != sides_.end(); begin = end) {
        const auto ends = ends_of(begin->from, begin->to);
        while (end != sides_.end() && ends_of(end->from, end->to) == ends) ++end;
        const std::optional<Side> side = outer_side(begin, end, eye);
        if (!side) continue;
        sampler.start(static_cast<uint32_t>(begin - sides_.begin()));
        const Vec3 along = tracer_.mesh().positions[side->to] - tracer_.mesh().positions[side->from];
        const int points = 1 + static_cast<int>(length(cross(along, eye)) / kSpacing);
        for (int k = 0; k < points; ++k) {
            const float share = (static_cast<float>(k) + sampler.next_1d()) / static_cast<float>(points);
            if (const auto found = point(*side, share, eye, sampler)) result.push_back(*found);
        }
    }
    return result;
}

// That side of an edge whose triangle faces the eye; the border of a sheet that is seen from behind, as its back has
// it. Nothing if several triangles face the eye, or none.
std::optional<MeshOutline::Side> MeshOutline::outer_side(Sides::const_iterator begin, Sides::const_iterator end,
                                                         const Vec3& eye) const
{
    const auto faces = [&](const Side& side) { return dot(tracer_.mesh().area_vector(side.triangle), eye) > 0; };
    const auto first = std::find_if(begin, end, faces);
    if (first != end) return std::none_of(first + 1, end, faces) ? std::optional(*first) : std::nullopt;
    const bool is_border = tracer_.faces() == Faces::both && end - begin == 1;
    return is_border ? std::optional(Side{begin->to, begin->from, begin->triangle}) : std::nullopt;
}

std::optional<OutlinePoint> MeshOutline::point(const Side& side, float share, const Vec3& eye, Sampler& sampler) const
{
    const Vec3& from = tracer_.mesh().positions[side.from];
    const Vec3 along = tracer_.mesh().positions[side.to] - from;
    const Vec3 across = cross(along, eye);
    if (!(length(across) > 0)) return std::nullopt;
    const Vec3 outwards = normalized(across);
    const auto ray = [&](float t) { return Ray{from + along * share + eye * kAway + outwards * t, -eye}; };
    if (!cap_.sees(ray(0)) || !is_outline(ray(-kBeside), ray(kBeside))) return std::nullopt;
    const auto in_scene = [&](float t) { return first_meeting(scene_, ray(t), sampler) < kBehind; };
    if (const auto offset = border_of(in_scene)) return OutlinePoint{side.from, side.to, share, outwards, *offset};
    if (!in_scene(0)) return std::nullopt;
    // A gap in the mesh: what lies beyond it comes the other half of the way.
    const auto gap = border_of([&](float t) { return t <= kBeside || !is_covered(tracer_.closest(ray(t))); });
    if (!gap) return std::nullopt;
    return OutlinePoint{side.from, side.to, share, outwards, 0.5f * *gap};
}

// Whether the mesh is there beside one of its edges and not on the edge's other side, and nothing lies before it.
bool MeshOutline::is_outline(const Ray& inside, const Ray& outside) const
{
    const std::optional<Hit> in = tracer_.closest(inside);
    return in && std::abs(in->distance - kAway) < kMaxDepthError && !is_covered(tracer_.closest(outside));
}

}  // namespace lumi::baker
