// SPDX-License-Identifier: MIT
#include "planner/surface_load.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lumi/surface/detail/target.h"

namespace lumi::planner
{

namespace
{

constexpr double kOneQ14 = 16384;

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

Vector middle(const Vector& a, const Vector& b)
{
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

struct Place {
    double x, y;   // samples
    double depth;  // along the axis
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

    Place operator()(const Vector& v) const
    {
        constexpr double kNearest = 1e-3;
        const Vector p = {v.x - position_.x, v.y - position_.y, v.z - position_.z};
        const double depth = std::max(kNearest, dot(p, forward_)), scale = side_ * focal_ / depth;
        return {dot(p, right_) * scale, -dot(p, up_) * scale, depth};
    }

    double side() const { return side_; }

private:
    double side_, focal_ = 1;
    Vector right_ = {1, 0, 0}, up_ = {0, 0, 1}, forward_ = {0, 1, 0}, position_ = {0, 0, 0};
};

double height(const Place& a, const Place& b, const Place& c)
{
    const auto [low, high] = std::minmax({a.y, b.y, c.y});
    return high - low;
}

double length(const Place& a, const Place& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

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

// Stripes of an image, and what of their neighbours they draw.
class Stripes
{
public:
    Stripes(const tools::Eye& eye, SurfaceMode mode, bool has_neighbours, int32_t rows)
        : rows_(rows * (mode == SurfaceMode::two_by_two ? 2 : 1)),
          height_(eye.image.height_px * (mode == SurfaceMode::two_by_two ? 2 : 1)),
          margin_(mode == SurfaceMode::antialiased && has_neighbours ? 2 : 0)
    {
    }

    // How many a height is in, in the mean over places.
    double reached_by(double height) const { return 1 + (std::min(height, height_) + margin_) / rows_; }
    // How often a scanline is drawn.
    double overlap() const { return 1 + margin_ / rows_; }

private:
    double rows_, height_, margin_;
};

// A field's triangles as an eye sees them.
class Triangles
{
public:
    Triangles(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows)
        : field_(field),
          projected_(eye, mode),
          stripes_(eye, mode, field.neighbours != nullptr, stripe_rows),
          most_(most_magnified(mode)),
          is_seen_(field.vertex_count)
    {
        for (uint32_t k = 0; k < field.vertex_count; ++k) {
            vertices_.push_back(decoded(detail::surface_vertex(field, k), kOneQ14));
            places_.push_back(projected_(vertices_.back()));
        }
    }

    // Adds a patch. The length of the side between its triangles in pixels, if one of them faces the eye and one does
    // not.
    double add(uint32_t k, TriangleLoad& load)
    {
        const detail::SurfacePatch patch = detail::surface_patch(field_, k);
        const uint32_t* v = patch.corner;
        const bool first = add(v[0], v[1], v[2], patch, load);
        if (v[3] == detail::format::kNoVertex || add(v[3], v[2], v[1], patch, load) == first) return 0;
        return length(places_[v[1]], places_[v[2]]) / projected_.side() * stripes_.overlap();
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
        const double samples = area / 2 * stripes_.overlap();
        load.seen += 1;
        load.samples += samples;
        if (is_magnified(places_[a], places_[b], places_[c], patch, most_)) load.magnified += samples;
        for (const uint32_t v : {a, b, c}) is_seen_[v] = true;
        add_set_ups({vertices_[a], vertices_[b], vertices_[c]}, 0, load);
        return true;
    }

    // Halves what is too large to be drawn as a whole, as src/surface/split.cpp does in every stripe.
    void add_set_ups(const std::array<Vector, 3>& corner, int depth, TriangleLoad& load) const
    {
        const std::array<Place, 3> at = {projected_(corner[0]), projected_(corner[1]), projected_(corner[2])};
        const double stripes = stripes_.reached_by(height(at[0], at[1], at[2]));
        constexpr int kDeepest = 12;
        for (size_t k = 0; k < 3 && depth < kDeepest; ++k) {
            const size_t next = (k + 1) % 3;
            if (is_whole(at[k], at[next])) continue;
            const size_t opposite = 3 - k - next;
            const Vector half = middle(corner[k], corner[next]);
            load.halvings += (depth == 0 ? 3 : 2) * stripes;
            add_set_ups({half, corner[opposite], corner[k]}, depth + 1, load);
            add_set_ups({corner[next], corner[opposite], half}, depth + 1, load);
            return;
        }
        load.set_ups += stripes;
    }

    // Whether an edge is short, and its texture's bend does not show: src/surface/projection.h.
    bool is_whole(const Place& a, const Place& b) const
    {
        constexpr double kSmall = 128, kMostBent = 2;
        const double longer = std::max(std::fabs(a.x - b.x), std::fabs(a.y - b.y));
        return longer < kSmall &&
               std::fabs(a.depth - b.depth) * longer / projected_.side() <= kMostBent * (a.depth + b.depth);
    }

    const SurfaceField& field_;
    const Projection projected_;
    const Stripes stripes_;
    double most_;
    std::vector<Vector> vertices_;
    std::vector<Place> places_;
    std::vector<bool> is_seen_;
};

}  // namespace

SurfaceLoad load_of(const SeeThroughField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows)
{
    Triangles triangles(field, eye, mode, stripe_rows);
    SurfaceLoad load;
    load.vertices = field.vertex_count;
    load.patches = field.patch_count;
    load.see_through_patches = field.see_through_count;
    load.image = 1.0 * eye.image.width_px * eye.image.height_px;
    constexpr double kSidesAPatch = 5.0 / 2;  // four, each shared by two patches, and the one inside
    for (uint32_t k = 0; k < field.patch_count; ++k) load.outline += kSidesAPatch * triangles.add(k, load);
    for (uint32_t k = 0; k < field.see_through_count; ++k) triangles.add(field.patch_count + k, load.see_through);
    load.lit = triangles.lit();
    load.view_bytes = detail::format::view_bytes(field.code_bits);
    return load;
}

}  // namespace lumi::planner
