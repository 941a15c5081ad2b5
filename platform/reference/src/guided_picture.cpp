// SPDX-License-Identifier: MIT
#include "lumi/reference/guided_picture.h"

#include <algorithm>

#include "viewing.h"

namespace lumi::reference
{
namespace
{

struct Offset {
    double x, y;
};
constexpr Offset kCentre[] = {{0.5, 0.5}};
constexpr Offset kRotatedGrid[] = {{1 / 8.0, 1 / 4.0}, {5 / 8.0, 1 / 4.0}, {3 / 8.0, 3 / 4.0}, {7 / 8.0, 3 / 4.0}};

struct Samples {
    const Offset* offsets;
    int count;
};
Samples samples_of(bool antialiased)
{
    return antialiased ? Samples{kRotatedGrid, 4} : Samples{kCentre, 1};
}

struct Corners {
    Vec3 a, b, c;
};

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Corners corners_of(const ProxyMesh& proxy, uint32_t triangle)
{
    const auto place = [](uint16_t c) { return (c - 2048) / 2048.0; };
    const auto vertex = [&](uint16_t index) {
        const Triple12 v = triple12(proxy.vertices, index);
        return Vec3{place(v.a), place(v.b), place(v.c)};
    };
    const Triple12 t = triple12(proxy.triangles, triangle);
    return {vertex(t.a), vertex(t.b), vertex(t.c)};
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

// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), 1997. Returns the distance along d,
// or 0 for a miss.
double distance_to(const Corners& t, const Vec3& eye, const Vec3& d, bool two_sided)
{
    const Vec3 ab = t.b - t.a, ac = t.c - t.a, across = cross(d, ac), from = eye - t.a;
    const double determinant = dot(ab, across);  // positive where the outside is seen
    if (two_sided ? determinant == 0 : determinant <= 0) return 0;
    const double u = dot(from, across) / determinant;
    const Vec3 turned = cross(from, ab);
    const double v = dot(d, turned) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return 0;
    return std::max(0.0, dot(ac, turned) / determinant);
}

double linear_light(double encoded)
{
    const double v = encoded / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);  // IEC 61966-2-1
}
double encoded_light(double linear)
{
    return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

// What the surfaces of a pixel show together: mixed in linear light, the background by the rest of the coverage in
// encoded values, as references do it.
class Mixture
{
public:
    void add(const Colour& c, double share)
    {
        if (share <= 0) return;
        last_ = c;
        ++surfaces_;
        light_.r += share * linear_light(c.r);
        light_.g += share * linear_light(c.g);
        light_.b += share * linear_light(c.b);
        coverage_ += share;
    }
    double coverage() const { return coverage_; }
    Colour over(const Rgb8& background) const
    {
        const double rest = 1 - coverage_;
        const Colour c = surfaces_ == 0 ? Colour{} : surfaces_ == 1 ? last_ : mean();
        return {coverage_ * c.r + rest * background.r, coverage_ * c.g + rest * background.g,
                coverage_ * c.b + rest * background.b};
    }

private:
    Colour mean() const
    {
        return {encoded_light(light_.r / coverage_), encoded_light(light_.g / coverage_),
                encoded_light(light_.b / coverage_)};
    }

    Colour light_, last_;
    int surfaces_ = 0;
    double coverage_ = 0;
};

struct Surface {
    Vec3 sum;
    double depth;
    int samples;
};

// The distinct surfaces among a pixel's samples; returns how many.
int surfaces_of(const ProxyHit* hits, int count, Surface (&out)[4])
{
    int surfaces = 0;
    for (int k = 0; k < count; ++k) {
        if (!hits[k].hit) continue;
        const auto same = [&](const Surface& s) { return std::fabs(s.depth - hits[k].depth) < kSameSurface; };
        Surface* s = std::find_if(out, out + surfaces, same);
        if (s == out + surfaces) {
            *s = {{0, 0, 0}, hits[k].depth, 0};
            ++surfaces;
        }
        s->sum = s->sum + hits[k].x;
        ++s->samples;
    }
    return surfaces;
}

// Where a ray meets the focus surface.
Vec3 focus_point(const GuidedField& field, const Vec3& eye, const Vec3& direction)
{
    constexpr double kOne = 16384;  // Q14
    const Vec3 focus = {field.focus_q14[0] / kOne, field.focus_q14[1] / kOne, field.focus_q14[2] / kOne};
    const double radius = field.focus_radius_q14 / kOne;
    const double middle = dot(focus - eye, direction);
    const Vec3 nearest = eye + middle * direction;
    const double rest = radius * radius - dot(nearest - focus, nearest - focus);
    return rest > 0 ? nearest - std::sqrt(rest) * direction : nearest;
}

class Drawer
{
public:
    Drawer(const GuidedField& field, const Pose& pose, const Image& image, const GuidedDrawing& drawing)
        : field_(field), view_(pose, image), drawing_(drawing), origins_(points(field.origins.size()))
    {
        if (field.surface == format::GuidedSurface::proxy)
            hits_ = proxy_hits(field.proxy, pose, image, drawing.antialiased);
    }

    Mixture pixel(int32_t x, int32_t y, size_t index) const
    {
        const Vec3 d = normalised(view_.vector(x + 0.5, y + 0.5));
        const double middle = -dot(view_.eye(), d);
        const double rest = middle * middle - dot(view_.eye(), view_.eye()) + 1;
        if (rest <= 0 || middle <= 0) return {};
        const Vec3 front = normalised(view_.eye() + (middle - std::sqrt(rest)) * d);
        if (field_.surface == format::GuidedSurface::proxy) return proxy_pixel(front, index);
        Mixture mixture;
        const Shade seen =
            shade(field_, linear_weights(origins_, front), focus_point(field_, view_.eye(), d), drawing_.shading);
        mixture.add(seen.colour, seen.coverage);
        return mixture;
    }

private:
    Mixture proxy_pixel(const Vec3& front, size_t index) const
    {
        const int count = samples_of(drawing_.antialiased).count;
        Surface surfaces[4];
        const int distinct = surfaces_of(&hits_[index * static_cast<size_t>(count)], count, surfaces);
        Mixture mixture;
        if (distinct == 0) return mixture;
        const Weights weights = linear_weights(origins_, front);
        for (int k = 0; k < distinct; ++k) {
            const Surface& s = surfaces[k];
            const Shade seen = shade(field_, weights, (1.0 / s.samples) * s.sum, drawing_.shading);
            mixture.add(seen.colour, seen.coverage * s.samples / count);
        }
        return mixture;
    }

    const GuidedField& field_;
    Viewing view_;
    GuidedDrawing drawing_;
    std::vector<Vec3> origins_;
    std::vector<ProxyHit> hits_;
};

}  // namespace

std::vector<ProxyHit> proxy_hits(const ProxyMesh& proxy, const Pose& pose, const Image& image, bool antialiased)
{
    const Viewing view(pose, image);
    const Samples samples = samples_of(antialiased);
    const auto count = static_cast<size_t>(samples.count);
    std::vector<ProxyHit> hits(count * static_cast<size_t>(image.width_px) * static_cast<size_t>(image.height_px));
    for (uint32_t k = 0; k < proxy.triangle_count; ++k) {
        const Corners corners = corners_of(proxy, k);
        const Bounds box = bounds_of(corners, view, image);
        for (int32_t y = box.y0; y <= box.y1; ++y)
            for (int32_t x = box.x0; x <= box.x1; ++x)
                for (size_t s = 0; s < count; ++s) {
                    const Vec3 d = view.vector(x + samples.offsets[s].x, y + samples.offsets[s].y);
                    const double distance = distance_to(corners, view.eye(), d, proxy.two_sided);
                    const size_t pixel =
                        static_cast<size_t>(y) * static_cast<size_t>(image.width_px) + static_cast<size_t>(x);
                    ProxyHit& hit = hits[pixel * count + s];
                    if (distance <= 0 || (hit.hit && hit.depth <= distance)) continue;
                    hit = {true, distance, view.eye() + distance * d};
                }
    }
    return hits;
}

GuidedPicture draw_guided(const GuidedField& field, const Pose& pose, const Image& image, const GuidedDrawing& drawing,
                          const Rgb8& background)
{
    const Drawer drawer(field, pose, image, drawing);
    GuidedPicture picture = {image.width_px, image.height_px, {}, {}};
    for (int32_t y = 0; y < image.height_px; ++y)
        for (int32_t x = 0; x < image.width_px; ++x) {
            const Mixture mixture = drawer.pixel(x, y, picture.colours.size());
            picture.colours.push_back(mixture.over(background));
            picture.coverage.push_back(mixture.coverage());
        }
    return picture;
}

}  // namespace lumi::reference
