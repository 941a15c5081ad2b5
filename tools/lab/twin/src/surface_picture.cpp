// SPDX-License-Identifier: MIT
#include "lumi/twin/surface_picture.h"

#include <algorithm>

#include "lumi/surface/detail/view_nodes.h"
#include "surface_file.h"
#include "viewing.h"

namespace lumi::twin
{
namespace
{

Colour operator+(const Colour& a, const Colour& b)
{
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
Colour operator*(double s, const Colour& c)
{
    return {s * c.r, s * c.g, s * c.b};
}

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A sample sees this.
struct Hit {
    double depth = 0;  // along the viewing axis; 0: nothing
    uint32_t triangle = 0;
    double second = 0, third = 0;  // barycentric weights of these corners
};

struct Corners {
    Vec3 a, b, c;
};

// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), 1997.
Hit meeting(const Corners& t, const Vec3& eye, const Vec3& d)
{
    const Vec3 ab = t.b - t.a, ac = t.c - t.a, across = cross(d, ac), from = eye - t.a;
    const double determinant = dot(ab, across);  // positive where the outside is seen
    if (determinant <= 0) return {};
    const double u = dot(from, across) / determinant;
    const Vec3 turned = cross(from, ab);
    const double v = dot(d, turned) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return {};
    return {std::max(0.0, dot(ac, turned) / determinant), 0, u, v};
}

// The pixels that a triangle may touch; all of them if it reaches behind the eye.
struct Bounds {
    int32_t x0, y0, x1, y1;
};
Bounds bounds_of(const Corners& t, const Viewing& view, const Image& image)
{
    constexpr double kNear = 1e-3;  // a triangle closer to the eye's plane is not projected
    if (std::min({view.depth(t.a), view.depth(t.b), view.depth(t.c)}) < kNear)
        return {0, 0, image.width_px - 1, image.height_px - 1};
    const auto low = [](double a, double b, double c) {
        return static_cast<int32_t>(std::clamp(std::floor(std::min({a, b, c})), 0.0, 1e6));
    };
    const auto high = [](double a, double b, double c, int32_t side) {
        return static_cast<int32_t>(std::clamp(std::floor(std::max({a, b, c})), -1.0, side - 1.0));
    };
    const double ax = view.image_x(t.a), bx = view.image_x(t.b), cx = view.image_x(t.c);
    const double ay = view.image_y(t.a), by = view.image_y(t.b), cy = view.image_y(t.c);
    return {low(ax, bx, cx), low(ay, by, cy), high(ax, bx, cx, image.width_px), high(ay, by, cy, image.height_px)};
}

class Drawer
{
public:
    Drawer(const SurfaceFile& surface, const Pose& pose, const Image& image, int grid)
        : surface_(surface), view_(pose, image), image_(image), grid_(grid)
    {
        for (uint32_t v = 0; v < surface.views.size(); ++v) seen_.push_back(seen_at(v));
        find_hits();
    }

    // The colour of the mean light of a pixel's covered samples, and how many they are. Light is about a level's
    // square.
    Colour pixel(int32_t x, int32_t y, int& covered) const
    {
        Colour sum;
        covered = 0;
        for (int s = 0; s < grid_ * grid_; ++s) {
            const Hit& hit = hits_[index_of(x, y, s)];
            if (hit.depth <= 0) continue;
            ++covered;
            const Colour c = colour_at(hit);
            sum = sum + Colour{c.r * c.r, c.g * c.g, c.b * c.b};
        }
        if (covered == 0) return sum;
        return {std::sqrt(sum.r / covered), std::sqrt(sum.g / covered), std::sqrt(sum.b / covered)};
    }

private:
    size_t index_of(int32_t x, int32_t y, int sample) const
    {
        const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(image_.width_px) + static_cast<size_t>(x);
        return pixel * static_cast<size_t>(grid_ * grid_) + static_cast<size_t>(sample);
    }

    // The difference that the eye sees at a vertex.
    Colour seen_at(uint32_t vertex) const
    {
        constexpr double kScale = 16384;  // directions may be up to 2^15 long
        const SurfaceView& view = surface_.views[vertex];
        const Vec3 w = normalised(view_.eye() - surface_.positions[vertex]);
        const auto step = [](double v) { return static_cast<int32_t>(std::lround(v * kScale)); };
        const detail::ViewDirection local =
            detail::in_view_frame({step(w.x), step(w.y), step(w.z)}, view.turn[0], view.turn[1], view.turn[2]);
        const detail::ViewTaps taps = detail::view_taps(local.x, local.y, local.z);
        Colour sum;
        for (int k = 0; k < 3; ++k) sum = sum + (taps.weight_q8[k] / 256.0) * view.nodes[taps.node[k]];
        return sum;
    }

    void find_hits()
    {
        hits_.resize(index_of(0, image_.height_px, 0));
        for (uint32_t k = 0; k < surface_.triangles.size(); ++k) {
            const uint32_t* v = surface_.triangles[k].vertices;
            const Corners corners = {surface_.positions[v[0]], surface_.positions[v[1]], surface_.positions[v[2]]};
            const Bounds box = bounds_of(corners, view_, image_);
            for (int32_t y = box.y0; y <= box.y1; ++y)
                for (int32_t x = box.x0; x <= box.x1; ++x) find_hits_in(x, y, k, corners);
        }
    }

    void find_hits_in(int32_t x, int32_t y, uint32_t triangle, const Corners& corners)
    {
        for (int s = 0; s < grid_ * grid_; ++s) {
            const double right = (s % grid_ + 0.5) / grid_, down = (s / grid_ + 0.5) / grid_;
            Hit hit = meeting(corners, view_.eye(), view_.vector(x + right, y + down));
            Hit& nearest = hits_[index_of(x, y, s)];
            if (hit.depth <= 0 || (nearest.depth > 0 && nearest.depth <= hit.depth)) continue;
            hit.triangle = triangle;
            nearest = hit;
        }
    }

    Colour colour_at(const Hit& hit) const
    {
        constexpr double kInset = 1.0 / (1 << detail::format::kPatchInsetShift);
        const SurfaceTriangle& t = surface_.triangles[hit.triangle];
        double u = kInset + (t.n - 2 * kInset) * hit.second, v = kInset + (t.m - 2 * kInset) * hit.third;
        if (t.second) {
            u = t.n - u;
            v = t.m - v;
        }
        const auto x = static_cast<uint32_t>(u), y = static_cast<uint32_t>(v);
        Colour c = surface_.texels[t.begin + y * t.n + x];
        const double weights[3] = {1 - hit.second - hit.third, hit.second, hit.third};
        for (int k = 0; k < 3; ++k)
            if (t.vertices[k] < seen_.size()) c = c + weights[k] * seen_[t.vertices[k]];
        const auto shown = [](double level) { return std::clamp(level, 0.0, 255.0); };
        return {shown(c.r), shown(c.g), shown(c.b)};
    }

    const SurfaceFile& surface_;
    Viewing view_;
    const Image& image_;
    int grid_;
    std::vector<Colour> seen_;  // by vertex, of those with view tables
    std::vector<Hit> hits_;
};

}  // namespace

SurfacePicture draw_surface(const uint8_t* file, const Pose& pose, const Image& image, const SurfaceDrawing& drawing,
                            const Rgb8& background)
{
    const SurfaceFile surface(file);
    const Drawer drawer(surface, pose, image, drawing.grid);
    const double samples = drawing.grid * drawing.grid;
    SurfacePicture picture = {image.width_px, image.height_px, {}, {}};
    for (int32_t y = 0; y < image.height_px; ++y)
        for (int32_t x = 0; x < image.width_px; ++x) {
            int covered = 0;
            const Colour mean = drawer.pixel(x, y, covered);
            const double share = covered / samples, rest = 1 - share;
            picture.colours.push_back({share * mean.r + rest * background.r, share * mean.g + rest * background.g,
                                       share * mean.b + rest * background.b});
            picture.coverage.push_back(share);
        }
    return picture;
}

}  // namespace lumi::twin
