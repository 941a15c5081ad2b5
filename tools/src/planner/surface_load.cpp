// SPDX-License-Identifier: MIT
#include "planner/surface_load.h"

#include <algorithm>
#include <cmath>

#include "lumi/surface/detail/target.h"

namespace lumi::planner
{

namespace
{

struct Vector {
    double x, y, z;
};

// A vector of core in fixed point, as numbers; `one` stands for 1.
template <class Fixed>
Vector decoded(const Fixed& v, double one)
{
    return {v.x / one, v.y / one, v.z / one};
}

double dot(const Vector& a, const Vector& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct Place {
    double x, y;  // samples
};

class Projection
{
public:
    Projection(const tools::Eye& eye, SurfaceMode mode) : side_(mode == SurfaceMode::two_by_two ? 2 : 1)
    {
        SurfaceCamera camera;
        if (make_surface_camera(eye.pose, eye.image, camera) != CameraError::none) return;
        right_ = decoded(camera.right, kOneQ30);
        up_ = decoded(camera.up, kOneQ30);
        forward_ = decoded(camera.forward, kOneQ30);
        position_ = decoded(camera.position, kOneQ20);
        focal_ = camera.focal_q12 / 4096.0;
    }

    Place operator()(const detail::VertexQ14& v) const
    {
        constexpr double kOneQ14 = 16384, kNearest = 1e-3;
        const Vector p = {v.x / kOneQ14 - position_.x, v.y / kOneQ14 - position_.y, v.z / kOneQ14 - position_.z};
        const double scale = side_ * focal_ / std::max(kNearest, dot(p, forward_));
        return {dot(p, right_) * scale, -dot(p, up_) * scale};
    }

    double side() const { return side_; }

private:
    double side_, focal_ = 1;
    Vector right_ = {1, 0, 0}, up_ = {0, 0, 1}, forward_ = {0, 1, 0}, position_ = {0, 0, 0};
};

// Twice the area, positive for triangles that face the eye.
double winding(const Place& a, const Place& b, const Place& c)
{
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

// Whether no coordinate of a texture, which has so many columns from a to b and rows from a to c, changes by more than
// `most` texels from sample to sample. The triangle faces the eye.
bool is_magnified(const Place& a, const Place& b, const Place& c, const detail::SurfacePatch& patch, double most)
{
    const double area = winding(a, b, c);
    const auto fits = [&](const Place& end, uint32_t texels) {
        return texels * std::fabs(end.x - a.x) <= most * area && texels * std::fabs(end.y - a.y) <= most * area;
    };
    return fits(c, patch.columns) && fits(b, patch.rows);
}

// Texels a sample, as target_of (lumi/surface/detail/target.h) has them.
double most_magnified(SurfaceMode mode)
{
    constexpr double kMost = 1.0 / detail::kMagnifiedPx;
    return mode == SurfaceMode::one_sample ? -1 : mode == SurfaceMode::antialiased ? kMost : kMost / 2;
}

}  // namespace

SurfaceLoad load_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode)
{
    const Projection projected(eye, mode);
    std::vector<Place> places;
    for (uint32_t k = 0; k < field.vertex_count; ++k) places.push_back(projected(detail::surface_vertex(field, k)));
    SurfaceLoad load;
    load.vertices = field.vertex_count;
    load.patches = field.patch_count;
    load.image = 1.0 * eye.image.width_px * eye.image.height_px;
    std::vector<bool> is_lit(field.vertex_count);
    const double most = most_magnified(mode);
    double turned = 0;  // length of the sides of patches that have one triangle facing the eye and one not
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c, const detail::SurfacePatch& patch) {
        const double area = winding(places[a], places[b], places[c]);
        if (area <= 0) return false;
        const auto [low, high] = std::minmax({places[a].y, places[b].y, places[c].y});
        load.seen += 1;
        load.scanlines += high - low;
        load.samples += area / 2;
        if (is_magnified(places[a], places[b], places[c], patch, most)) load.magnified += area / 2;
        for (const uint32_t v : {a, b, c}) is_lit[v] = true;
        return true;
    };
    for (uint32_t k = 0; k < field.patch_count; ++k) {
        const detail::SurfacePatch patch = detail::surface_patch(field, k);
        const uint32_t* v = patch.corner;
        const bool first = add(v[0], v[1], v[2], patch);
        if (v[3] == detail::format::kNoVertex) continue;
        if (add(v[3], v[2], v[1], patch) != first)
            turned += std::hypot(places[v[1]].x - places[v[2]].x, places[v[1]].y - places[v[2]].y);
    }
    constexpr double kSidesAPatch = 5.0 / 2;  // four, each shared by two patches, and the one inside
    load.outline = kSidesAPatch * turned / projected.side();
    for (uint32_t k = 0; k < field.viewed_count; ++k) load.lit += is_lit[k] ? 1 : 0;
    return load;
}

}  // namespace lumi::planner
