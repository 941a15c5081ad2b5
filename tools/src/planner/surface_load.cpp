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

// A field's triangles as an eye sees them.
class Triangles
{
public:
    Triangles(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode)
        : field_(field), most_(most_magnified(mode)), is_seen_(field.vertex_count)
    {
        const Projection projected(eye, mode);
        side_ = projected.side();
        for (uint32_t k = 0; k < field.vertex_count; ++k)
            places_.push_back(projected(detail::surface_vertex(field, k)));
    }

    // Adds a patch. The length of the side between its triangles in pixels, if one of them faces the eye and one does
    // not.
    double add(uint32_t k, TriangleLoad& load)
    {
        const detail::SurfacePatch patch = detail::surface_patch(field_, k);
        const uint32_t* v = patch.corner;
        const bool first = add(v[0], v[1], v[2], patch, load);
        if (v[3] == detail::format::kNoVertex || add(v[3], v[2], v[1], patch, load) == first) return 0;
        return std::hypot(places_[v[1]].x - places_[v[2]].x, places_[v[1]].y - places_[v[2]].y) / side_;
    }

    double lit() const
    {
        return static_cast<double>(std::count(is_seen_.begin(), is_seen_.begin() + field_.viewed_count, true));
    }

private:
    bool add(uint32_t a, uint32_t b, uint32_t c, const detail::SurfacePatch& patch, TriangleLoad& load)
    {
        const double area = winding(places_[a], places_[b], places_[c]);
        if (area <= 0) return false;
        const auto [low, high] = std::minmax({places_[a].y, places_[b].y, places_[c].y});
        load.seen += 1;
        load.scanlines += high - low;
        load.samples += area / 2;
        if (is_magnified(places_[a], places_[b], places_[c], patch, most_)) load.magnified += area / 2;
        for (const uint32_t v : {a, b, c}) is_seen_[v] = true;
        return true;
    }

    const SurfaceField& field_;
    double most_, side_;
    std::vector<Place> places_;
    std::vector<bool> is_seen_;
};

}  // namespace

SurfaceLoad load_of(const SeeThroughField& field, const tools::Eye& eye, SurfaceMode mode)
{
    Triangles triangles(field, eye, mode);
    SurfaceLoad load;
    load.vertices = field.vertex_count;
    load.patches = field.patch_count;
    load.see_through_patches = field.see_through_count;
    load.image = 1.0 * eye.image.width_px * eye.image.height_px;
    constexpr double kSidesAPatch = 5.0 / 2;  // four, each shared by two patches, and the one inside
    for (uint32_t k = 0; k < field.patch_count; ++k) load.outline += kSidesAPatch * triangles.add(k, load);
    for (uint32_t k = 0; k < field.see_through_count; ++k) triangles.add(field.patch_count + k, load.see_through);
    load.lit = triangles.lit();
    return load;
}

}  // namespace lumi::planner
