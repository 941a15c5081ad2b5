// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "lumi/surface/detail/view_nodes.h"
#include "lumi/surface/format.h"
#include "lumi/twin/geometry.h"
#include "lumi/twin/picture.h"
#include "lumi/twin/surface_picture.h"
#include "viewing.h"

namespace lumi::twin
{

namespace
{

// Decodes the contents of a surface file without core's reader.

struct SurfaceTriangle {
    uint32_t vertices[3];
    uint32_t begin, n, m;  // where its rectangle of texels begins, and the rectangle's size
    bool second;           // texture coordinates run backwards
};

// The difference that a view table adds, at each node.
struct SurfaceView {
    int32_t turn[3];
    std::vector<Colour> nodes;
};

struct SurfaceFile {
    explicit SurfaceFile(const uint8_t* file);

    std::vector<Vec3> positions;
    std::vector<SurfaceTriangle> triangles;
    std::vector<Colour> texels;
    std::vector<SurfaceView> views;  // tables of the first vertices, in order
};

uint32_t u16(const uint8_t* p)
{
    return p[0] | uint32_t{p[1]} << 8;
}
uint32_t u32(const uint8_t* p)
{
    return u16(p) | u16(p + 2) << 16;
}
double s8(uint8_t v)
{
    return static_cast<int8_t>(v);
}

// The bytes of a section, or null.
const uint8_t* section(const uint8_t* file, uint32_t type)
{
    const uint32_t count = u16(file + detail::format::header::kSectionCountAt);
    for (uint32_t k = 0; k < count; ++k) {
        const uint8_t* entry = file + detail::format::kHeaderBytes + k * detail::format::kEntryBytes;
        if (u32(entry + detail::format::entry::kTypeAt) == type)
            return file + u32(entry + detail::format::entry::kOffsetAt);
    }
    return nullptr;
}

std::vector<Vec3> positions_in(const uint8_t* bytes, uint32_t count)
{
    constexpr double kOne = 16384;  // Q14
    std::vector<Vec3> positions;
    for (uint32_t v = 0; v < count; ++v, bytes += detail::format::kVertexBytes) {
        const auto axis = [&](uint32_t k) { return static_cast<int16_t>(u16(bytes + 2 * k)) / kOne; };
        positions.push_back({axis(0), axis(1), axis(2)});
    }
    return positions;
}

std::vector<SurfaceTriangle> triangles_in(const uint8_t* bytes, uint32_t patches)
{
    std::vector<SurfaceTriangle> triangles;
    for (uint32_t p = 0; p < patches; ++p, bytes += detail::format::kPatchBytes) {
        const auto corner = [&](uint32_t k) { return u16(bytes + detail::format::patch::kCornersAt + 2 * k); };
        const uint32_t texels = u32(bytes + detail::format::patch::kTexelsAt);
        const uint32_t begin = texels & 0xFFFFF, n = texels >> 20 & 63, m = texels >> 26;
        triangles.push_back({{corner(0), corner(1), corner(2)}, begin, n, m, false});
        if (corner(3) != detail::format::kNoVertex)
            triangles.push_back({{corner(3), corner(2), corner(1)}, begin, n, m, true});
    }
    return triangles;
}

// Codes one after the other, bit by bit.
SurfaceView view_in(const uint8_t* record, const uint8_t* colours, uint32_t bits)
{
    SurfaceView view = {{}, {}};
    const uint8_t *turn = record + detail::format::view_turn_at(bits), *gain = turn + detail::format::kTurnBytes;
    for (uint32_t k = 0; k < 3; ++k) view.turn[k] = static_cast<int8_t>(turn[k]);
    for (uint32_t node = 0; node < detail::format::kViewNodes; ++node) {
        uint32_t code = 0;
        for (uint32_t bit = 0; bit < bits; ++bit) {
            const uint32_t at = node * bits + bit;
            code |= (record[at / 8] >> at % 8 & 1u) << bit;
        }
        const uint8_t* c = colours + ((node << bits) + code) * detail::format::kNodeColourBytes;
        view.nodes.push_back({gain[0] / 64.0 * s8(c[0]), gain[1] / 64.0 * s8(c[1]), gain[2] / 64.0 * s8(c[2])});
    }
    return view;
}

SurfaceFile::SurfaceFile(const uint8_t* file)
{
    namespace at = detail::format::surface;
    const uint8_t* head = section(file, detail::format::kSurfaceSection);
    positions = positions_in(section(file, detail::format::kVertexSection), u16(head + at::kVerticesAt));
    triangles = triangles_in(section(file, detail::format::kPatchSection), u16(head + at::kPatchesAt));
    const uint8_t *indices = section(file, detail::format::kColourSection),
                  *palette = section(file, detail::format::kPaletteRgb);
    for (uint32_t k = 0; k < u32(head + at::kTexelsAt); ++k) {
        const uint8_t* c = palette + 3 * indices[k];
        texels.push_back({static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])});
    }
    const uint8_t* tables = section(file, detail::format::kViewSection);
    const uint32_t bits = head[at::kCodeBitsAt], colours = detail::format::view_colours_bytes(bits);
    for (uint32_t v = 0; v < u16(head + at::kViewedAt); ++v)
        views.push_back(view_in(tables + colours + v * detail::format::view_bytes(bits), tables, bits));
}

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
