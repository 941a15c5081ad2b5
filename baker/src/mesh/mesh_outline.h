// SPDX-License-Identifier: MIT
// How far the outlines of a mesh lie from the scene's, seen from far away. An outline is where something nearer ends
// before the background or what lies more than kMaxDepthError behind.
#pragma once

#include "math/sampler.h"
#include "mesh/survey.h"

namespace lumi::baker
{

// A point on an edge of the mesh that is an outline.
struct OutlinePoint {
    uint32_t from, to;  // vertices of the edge
    float share;        // how far the point is on the way from `from` to `to`, 0 .. 1
    Vec3 outwards;      // across the edge, in the plane of the image; unit length
    float offset;       // how far outwards the scene's outline lies, or half of a gap in the mesh; in radii
};

class MeshOutline
{
public:
    // Borrows scene and tracer.
    MeshOutline(const SceneData& scene, const MeshTracer& tracer, const ViewCap& cap = {});

    // Seen in parallel rays, the eye far away in this direction (unit length): points spread along the outlines, of
    // those that have an outline of the scene nearby, or where the scene goes on, another part of the tracer. None of
    // scenes that light may pass: cut-outs would get holes. The random numbers are of `seed`. Thread-safe.
    std::vector<OutlinePoint> seen_from(const Vec3& eye, uint32_t seed) const;

private:
    // A triangle's side, counter-clockwise.
    struct Side {
        uint32_t from, to, triangle;
    };
    using Sides = std::vector<Side>;

    std::optional<Side> outer_side(Sides::const_iterator begin, Sides::const_iterator end, const Vec3& eye) const;
    std::optional<OutlinePoint> point(const Side& side, float share, const Vec3& eye, Sampler& sampler) const;
    bool is_outline(const Ray& inside, const Ray& outside) const;

    const SceneData& scene_;
    const MeshTracer& tracer_;
    const ViewCap cap_;
    Sides sides_;  // an edge's sides lie together
};

}  // namespace lumi::baker
