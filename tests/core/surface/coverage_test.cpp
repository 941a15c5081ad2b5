// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lumi/surface/view.h"
#include "surface_bytes.h"

using namespace lumi;
using namespace lumi::detail;
using test::Bytes;

namespace
{

constexpr int32_t kWidth = 60, kHeight = 44, kRows = 11;
constexpr Orbit kOrbit = {degrees(35), degrees(25), radii(5) / 2};
constexpr SurfaceMode kModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};

template <class Pixel>
using BallView = View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two>, Screen<kWidth, kHeight, kRows, Pixel>>;

struct Drawn {
    Bytes pixels, coverage;
};

template <class Pixel, class Background>
Drawn drawn(SurfaceMode mode, const Background& background)
{
    static BallView<Pixel> view;
    static const Bytes file = test::surface_file(test::bumpy_ball());
    REQUIRE(view.open(file.data(), file.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit, mode) == ViewError::none);
    constexpr uint32_t kStride = kWidth * Pixel::kBytes;
    Drawn result = {Bytes(kStride * kHeight, 0xA5), Bytes(kWidth * kHeight, 0xA5)};
    for (int32_t y = 0; y < kHeight; y += kRows) {
        const uint32_t at = static_cast<uint32_t>(y);
        REQUIRE(view.draw({result.pixels.data() + at * kStride, 0, y, kWidth, kRows, kStride}, background) ==
                ViewError::none);
        REQUIRE(view.draw_coverage({result.coverage.data() + at * kWidth, 0, y, kWidth, kRows, kWidth}) ==
                ViewError::none);
    }
    return result;
}

int32_t blended(int32_t colour, int32_t coverage, int32_t under)
{
    return (colour * coverage + under * (255 - coverage) + 127) / 255;
}

// The largest difference between what was drawn over a colour, and what was drawn over nothing and laid over it.
int32_t worst_difference(SurfaceMode mode, const Rgb8& under)
{
    const Bytes over = drawn<PixelRgb888>(mode, OverColour{under}).pixels;
    const Bytes argb = drawn<PixelArgb8888>(mode, OverNothing{}).pixels;
    int32_t worst = 0;
    for (size_t k = 0; k < size_t{kWidth * kHeight}; ++k) {
        const uint8_t* c = argb.data() + 4 * k;
        const int32_t laid[] = {blended(c[2], c[3], under.r), blended(c[1], c[3], under.g),
                                blended(c[0], c[3], under.b)};
        for (size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(laid[i] - over[3 * k + i]));
    }
    return worst;
}

// Coverage in 1/255 by 8 × 8 samples a pixel.
std::vector<double> exact_coverage()
{
    constexpr int32_t kFine = 8, kFineWidth = kFine * kWidth;
    static View<SurfaceDrawing<98, 128, SurfaceMode::one_sample>, Screen<kFineWidth, kFine * kHeight, kFine, PixelA8>>
        view;
    static const Bytes file = test::surface_file(test::bumpy_ball());
    REQUIRE(view.open(file.data(), file.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit, SurfaceMode::one_sample) == ViewError::none);
    std::vector<double> result;
    Bytes rows(size_t{kFineWidth * kFine});
    for (int32_t y = 0; y < kHeight; ++y) {
        REQUIRE(view.draw({rows.data(), 0, kFine * y, kFineWidth, kFine, kFineWidth}, OverNothing{}) ==
                ViewError::none);
        for (int32_t x = 0; x < kWidth; ++x) {
            int32_t sum = 0;
            for (int32_t k = 0; k < kFine * kFine; ++k)
                sum += rows[static_cast<size_t>(k / kFine * kFineWidth + kFine * x + k % kFine)];
            result.push_back(static_cast<double>(sum) / (kFine * kFine));
        }
    }
    return result;
}

// The root of the mean square over all pixels, 1/255.
double coverage_error(SurfaceMode mode, const std::vector<double>& exact)
{
    const Bytes coverage = drawn<PixelA8>(mode, OverNothing{}).pixels;
    double sum = 0;
    for (size_t k = 0; k < exact.size(); ++k) sum += (coverage[k] - exact[k]) * (coverage[k] - exact[k]);
    return std::sqrt(sum / static_cast<double>(exact.size()));
}

struct Place {
    double x, y;
};
using Polygon = std::vector<Place>;

// Sutherland and Hodgman, at x or y = `at`: what lies above it, or below.
Polygon clipped(const Polygon& p, double Place::*axis, double at, bool above)
{
    Polygon result;
    for (size_t k = 0; k < p.size(); ++k) {
        const Place &a = p[k], &b = p[(k + 1) % p.size()];
        const double from = above ? a.*axis - at : at - a.*axis, to = above ? b.*axis - at : at - b.*axis;
        if (from >= 0) result.push_back(a);
        if ((from < 0) != (to < 0)) {
            const double t = from / (from - to);
            result.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return result;
}

double area_in(Polygon p, int32_t x, int32_t y)
{
    p = clipped(clipped(p, &Place::x, x, true), &Place::x, x + 1, false);
    p = clipped(clipped(p, &Place::y, y, true), &Place::y, y + 1, false);
    double doubled = 0;
    for (size_t k = 0; k < p.size(); ++k) {
        const Place &a = p[k], &b = p[(k + 1) % p.size()];
        doubled += a.x * b.y - b.x * a.y;
    }
    return std::abs(doubled) / 2;
}

constexpr int32_t kSide = 12;

// Samples whose depths a test sets, and edges of one depth over them.
struct SmallTarget {
    alignas(4) uint16_t depths[kSide][kSide];
    uint32_t marks[kMarkPlanes * kSide] = {};
    Target target;

    SmallTarget()
    {
        target.first = reinterpret_cast<uint8_t*>(depths);
        target.row_bytes = sizeof depths[0];
        target.width = target.height = kSide;
        target.marks = marks;
        target.x = target.y = 0;
    }
    SmallTarget(const SmallTarget&) = delete;

    // Ends in 1/64 sample.
    void mark(const std::array<int32_t, 2>& from, const std::array<int32_t, 2>& to, bool is_crease = false)
    {
        const auto vertex = [](const std::array<int32_t, 2>& c) {
            constexpr int32_t kDepth = 20000;
            return SurfaceVertex{c[0] * 256 + (kDepth & 0xFF), c[1] * 256 + (kDepth >> 8), 0};
        };
        mark_edge(vertex(from), vertex(to), is_crease, target);
    }
    void fill(uint16_t depth)
    {
        for (auto& row : depths) std::fill(std::begin(row), std::end(row), depth);
    }
    double coverage(int32_t x, int32_t y) const
    {
        if (!is_marked(target, x, y)) return depths[y][x] != kEmptyDepth ? 1 : 0;
        return Mark(target, x, y).covered() / 32.0;
    }
};

// Draws triangles by their samples' centres and marks their edges.
class MarkedTriangle
{
public:
    // Corners in 1/64 sample, in any order.
    explicit MarkedTriangle(std::array<std::array<int32_t, 2>, 3> corner) : corner_(corner)
    {
        if (side(0, corner_[2][0], corner_[2][1]) < 0) std::swap(corner_[1], corner_[2]);
        for (int32_t y = 0; y < kSide; ++y)
            for (int32_t x = 0; x < kSide; ++x) target_.depths[y][x] = holds(x, y) ? 30000 : kEmptyDepth;
        for (size_t k = 0; k < 3; ++k) target_.mark(corner_[(k + 1) % 3], corner_[k]);
        drop_inner_edges(target_.target);
    }

    Polygon polygon() const
    {
        Polygon p;
        for (const auto& c : corner_) p.push_back({c[0] / 64.0, c[1] / 64.0});
        return p;
    }
    double coverage(int32_t x, int32_t y) const { return target_.coverage(x, y); }
    bool holds(int32_t x, int32_t y) const
    {
        // A sample right at an edge lies to its right, or below.
        const auto inside = [&](size_t k) { return side(k, 64 * x + 32 + 1e-3, 64 * y + 32 + 1e-6) >= 0; };
        return inside(0) && inside(1) && inside(2);
    }
    // Whether one edge alone passes within a sample's side of a pixel, far from both of its ends, and not within 1/1024
    // of the sample, which may then be on either side of it.
    bool is_plain(int32_t x, int32_t y) const
    {
        int near = 0;
        for (size_t k = 0; k < 3; ++k) {
            const auto &a = corner_[k], &b = corner_[(k + 1) % 3];
            const double dx = 64 * x + 32 - a[0], dy = 64 * y + 32 - a[1];
            if (std::max(std::abs(dx), std::abs(dy)) < 96) return false;
            const double distance = std::abs(side(k, 64 * x + 32, 64 * y + 32));
            const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
            if (distance < length / 16) return false;
            near += distance < 96 * length;
        }
        return near <= 1;
    }

private:
    double side(size_t k, double x, double y) const
    {
        const auto &a = corner_[k], &b = corner_[(k + 1) % 3];
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    }

    std::array<std::array<int32_t, 2>, 3> corner_;
    SmallTarget target_;
};

struct CoverageErrors {
    double worst_plain = 0, squares = 0, squares_of_samples = 0;

    void add(const MarkedTriangle& t)
    {
        const Polygon p = t.polygon();
        for (int32_t y = 1; y < kSide - 1; ++y)
            for (int32_t x = 1; x < kSide - 1; ++x) {
                const double exact = area_in(p, x, y), error = std::abs(t.coverage(x, y) - exact);
                if (t.is_plain(x, y)) worst_plain = std::max(worst_plain, error);
                squares += error * error;
                squares_of_samples += ((t.holds(x, y) ? 1 : 0) - exact) * ((t.holds(x, y) ? 1 : 0) - exact);
            }
    }
};

// Half a step of 1/32, the largest share of 15/32 where it is 1/2, and 1/128 each of place and slope.
constexpr double kPlainBound = 1 / 64.0 + 1 / 64.0 + 2 / 128.0;

}  // namespace

TEST_CASE("what an edge cuts off of a pixel is its area, at every place between samples")
{
    CoverageErrors errors;
    for (int32_t k = 0; k < 64 * 64; ++k) {
        const int32_t x = k & 63, y = k >> 6, turn = k % 61 * 10;
        errors.add(MarkedTriangle({{{100 + x, 90 + y}, {690 - turn + x, 80 + y}, {120 + x, 90 + turn + y}}}));
    }
    CHECK(errors.worst_plain <= kPlainBound);
    CHECK(errors.squares < 0.21 * errors.squares_of_samples);
}

TEST_CASE("coverage of random triangles and slivers is that of a polygon clipper")
{
    std::mt19937 random(59);
    const auto place = [&](int32_t range) { return static_cast<int32_t>(random() % static_cast<uint32_t>(range)); };
    CoverageErrors large, thin;
    for (int k = 0; k < 20000; ++k)
        large.add(MarkedTriangle({{{place(768), place(768)}, {place(768), place(768)}, {place(768), place(768)}}}));
    for (int k = 0; k < 20000; ++k) {
        const int32_t x = place(700), y = place(700);
        thin.add(MarkedTriangle({{{x, y}, {place(768), place(768)}, {x + place(64), y + place(64)}}}));
    }
    CHECK(large.worst_plain <= kPlainBound);
    CHECK(thin.worst_plain <= kPlainBound);
    CHECK(large.squares < 0.165 * large.squares_of_samples);
    CHECK(thin.squares < 0.355 * thin.squares_of_samples);
}

TEST_CASE("beside a crease a pixel shows as much of what lies across as the edge cuts off, where the crease is seen")
{
    std::mt19937 random(60);
    const auto place = [&] { return static_cast<int32_t>(random() % (64u * kSide)); };
    constexpr uint16_t kAtCrease = 20000, kBefore = 23000;
    double worst = 0;
    uint32_t cut = 0, hidden = 0;
    for (int k = 0; k < 4000; ++k) {
        // From side to side of the target, more or less downwards; its inside is to the right.
        const int32_t top = place(), bottom = place();
        SmallTarget seen, covered;
        seen.fill(kAtCrease);
        covered.fill(kBefore);
        for (SmallTarget* t : {&seen, &covered}) t->mark({top, 0}, {bottom, 64 * kSide}, true);
        const Polygon inside = {{top / 64.0, 0}, {2 * kSide, 0}, {2 * kSide, kSide}, {bottom / 64.0, kSide}};
        for (int32_t y = 2; y < kSide - 2; ++y) {
            for (int32_t x = 2; x < kSide - 2; ++x) {
                hidden += is_marked(covered.target, x, y);
                const double area = area_in(inside, x, y);
                const double centre = top + (bottom - top) * (y + 0.5) / kSide - (64 * x + 32);
                if (std::abs(centre) < 2) continue;  // roundings decide which side it is on
                const double share = is_marked(seen.target, x, y) ? Mark(seen.target, x, y).share / 32.0 : 0;
                worst = std::max(worst, std::abs(share - (centre < 0 ? 1 - area : area)));
                cut += share > 0;
            }
        }
    }
    CHECK(worst <= kPlainBound);
    CHECK(cut > 10000);
    CHECK(hidden == 0);
}

TEST_CASE("of several edges of surfaces that overlap the outermost cuts, in any order")
{
    // Left of the middle of a row's pair, then right of it; what is behind lies to the right.
    constexpr int32_t kNear = 5 * 64 + 48, kFar = 6 * 64 + 16;
    for (const bool is_far_first : {false, true}) {
        SmallTarget t;
        for (auto& row : t.depths)
            for (int32_t x = 0; x < kSide; ++x) row[x] = x < 6 ? 30000 : kEmptyDepth;
        const auto mark = [&](int32_t x) { t.mark({x, 64 * kSide}, {x, 0}); };
        mark(is_far_first ? kFar : kNear);
        CHECK(t.coverage(is_far_first ? 6 : 5, 5) == Approx(is_far_first ? 0.25 : 0.75));
        mark(is_far_first ? kNear : kFar);
        drop_inner_edges(t.target);
        CHECK(t.coverage(5, 5) == 1);
        CHECK(t.coverage(6, 5) == Approx(0.25));
    }
}

TEST_CASE("outlines are blended by what they cover")
{
    const std::vector<double> exact = exact_coverage();
    const double one_sample = coverage_error(SurfaceMode::one_sample, exact);
    CHECK(coverage_error(SurfaceMode::antialiased, exact) < 0.4 * one_sample);
    CHECK(coverage_error(SurfaceMode::two_by_two, exact) < 0.5 * one_sample);
}

TEST_CASE("what is drawn over nothing and laid over a colour is what is drawn over the colour")
{
    // Rounding of the coverage to 1/255 and of two blends: half a level each, and what is cut off of a mean of four.
    for (const SurfaceMode mode : kModes) {
        CHECK(worst_difference(mode, {0, 0, 0}) <= 2);
        CHECK(worst_difference(mode, {255, 30, 130}) <= 2);
    }
}

TEST_CASE("coverage is 0, 255 or between at outlines, and the same in each of its three forms")
{
    for (const SurfaceMode mode : kModes) {
        const Drawn argb = drawn<PixelArgb8888>(mode, OverNothing{});
        CHECK((drawn<PixelA8>(mode, OverNothing{}).pixels == argb.coverage));
        CHECK((drawn<PixelRgb565>(mode, OverNothing{}).coverage == argb.coverage));
        uint32_t wrong = 0, empty = 0, part = 0, full = 0;
        for (size_t k = 0; k < argb.coverage.size(); ++k) {
            const uint8_t a = argb.coverage[k];
            wrong += argb.pixels[4 * k + 3] != a;
            ++(a == 0 ? empty : a == 255 ? full : part);
        }
        CHECK(wrong == 0);
        CHECK(empty > 100);
        CHECK(full > 400);
        CHECK((part > 20) == (mode != SurfaceMode::one_sample));
    }
}

TEST_CASE("pixels with coverage are opaque over a colour")
{
    const Bytes argb = drawn<PixelArgb8888>(SurfaceMode::antialiased, OverColour{{9, 8, 7}}).pixels;
    const Bytes rgb = drawn<PixelRgb888>(SurfaceMode::antialiased, OverColour{{9, 8, 7}}).pixels;
    uint32_t wrong = 0;
    for (size_t k = 0; k < size_t{kWidth * kHeight}; ++k) {
        const uint8_t *a = argb.data() + 4 * k, *b = rgb.data() + 3 * k;
        wrong += a[0] != b[2] || a[1] != b[1] || a[2] != b[0] || a[3] != 255;
    }
    CHECK(wrong == 0);
}

TEST_CASE("5-5-5 pixels are those of 8 bits to the nearest step, with the top bit clear")
{
    for (const SurfaceMode mode : kModes) {
        const Bytes packed = drawn<PixelBgr555>(mode, OverColour{{40, 250, 3}}).pixels;
        const Bytes rgb = drawn<PixelRgb888>(mode, OverColour{{40, 250, 3}}).pixels;
        int32_t worst = 0;
        uint32_t top = 0;
        for (size_t k = 0; k < size_t{kWidth * kHeight}; ++k) {
            const Rgb8 c = PixelBgr555::load(packed.data() + 2 * k);
            top |= packed[2 * k + 1] & 0x80u;
            for (const int32_t d : {c.r - rgb[3 * k], c.g - rgb[3 * k + 1], c.b - rgb[3 * k + 2]})
                worst = std::max(worst, std::abs(d));
        }
        CHECK(top == 0);
        CHECK(worst <= 8);  // a step is 255/31
    }
}

TEST_CASE("pixels are copied at every place of a word, and none beside them")
{
    alignas(4) uint16_t from[48], to[48];
    for (uint16_t k = 0; k < 48; ++k) from[k] = static_cast<uint16_t>(1000 + k);
    for (uint32_t at_from = 0; at_from < 2; ++at_from)
        for (uint32_t at_to = 0; at_to < 2; ++at_to)
            for (uint32_t count = 0; count <= 40; ++count) {
                std::fill(std::begin(to), std::end(to), uint16_t{7});
                copy_pixels(reinterpret_cast<uint8_t*>(to + at_to), reinterpret_cast<const uint8_t*>(from + at_from),
                            count);
                uint32_t wrong = 0;
                for (uint32_t k = 0; k < 48; ++k) {
                    const bool is_copied = k >= at_to && k < at_to + count;
                    wrong += to[k] == (is_copied ? from[k - at_to + at_from] : 7) ? 0u : 1u;
                }
                CHECK(wrong == 0);
            }
}
