// SPDX-License-Identifier: MIT
#include "planner/surface_load.h"

#include <algorithm>
#include <cmath>

#include "lumi/reference/geometry.h"

namespace lumi::planner
{

namespace
{

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
        right_ = reference::decoded(camera.right);
        up_ = reference::decoded(camera.up);
        forward_ = reference::decoded(camera.forward);
        position_ = reference::decoded(camera.position);
        focal_ = camera.focal_q12 / 4096.0;
    }

    Place operator()(const VertexQ14& v) const
    {
        constexpr double kOneQ14 = 16384, kNearest = 1e-3;
        const reference::Vec3 p = {v.x / kOneQ14 - position_.x, v.y / kOneQ14 - position_.y,
                                   v.z / kOneQ14 - position_.z};
        const double scale = side_ * focal_ / std::max(kNearest, reference::dot(p, forward_));
        return {reference::dot(p, right_) * scale, -reference::dot(p, up_) * scale};
    }

    double side() const { return side_; }

private:
    double side_, focal_ = 1;
    reference::Vec3 right_ = {1, 0, 0}, up_ = {0, 0, 1}, forward_ = {0, 1, 0}, position_ = {0, 0, 0};
};

// Twice the area, positive for triangles that face the eye.
double winding(const Place& a, const Place& b, const Place& c)
{
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

}  // namespace

SurfaceLoad load_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode)
{
    const Projection projected(eye, mode);
    std::vector<Place> places;
    for (uint32_t k = 0; k < field.vertex_count; ++k) places.push_back(projected(surface_vertex(field, k)));
    SurfaceLoad load;
    load.vertices = field.vertex_count;
    load.patches = field.patch_count;
    load.image = 1.0 * eye.image.width_px * eye.image.height_px;
    std::vector<bool> is_lit(field.vertex_count);
    double turned = 0;  // length of the sides of patches that have one triangle seen and one unseen
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        const double area = winding(places[a], places[b], places[c]);
        if (area <= 0 && !field.two_sided) return false;
        const auto [low, high] = std::minmax({places[a].y, places[b].y, places[c].y});
        load.seen += 1;
        load.rows += high - low;
        load.samples += std::fabs(area) / 2;
        for (const uint32_t v : {a, b, c}) is_lit[v] = true;
        return true;
    };
    for (uint32_t k = 0; k < field.patch_count; ++k) {
        const SurfacePatch patch = surface_patch(field, k);
        const uint32_t* v = patch.corner;
        const bool first = add(v[0], v[1], v[2]);
        if (v[3] == format::kNoVertex) continue;
        if (add(v[3], v[2], v[1]) != first)
            turned += std::hypot(places[v[1]].x - places[v[2]].x, places[v[1]].y - places[v[2]].y);
    }
    constexpr double kSidesAPatch = 5.0 / 2;  // four, each shared by two patches, and the one inside
    load.outline = kSidesAPatch * turned / projected.side();
    for (uint32_t k = 0; k < field.viewed_count; ++k) load.lit += is_lit[k] ? 1 : 0;
    return load;
}

}  // namespace lumi::planner
