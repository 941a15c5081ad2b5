// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "lumi/detail/crc32.h"
#include "lumi/surface/detail/marks.h"
#include "lumi/surface/view.h"
#include "see_through_bytes.h"
#include "surface/projection.h"
#include "surface_drawing.h"
#include "truncation.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 40;
constexpr uint32_t kFirstOfBall = 60;  // of 118 patches or so
#ifdef LUMI_TEST_LIGHT
constexpr int kViews = 6;
#else
constexpr int kViews = 60;
#endif

test::View from_above()
{
    test::View view;
    view.pose = pose_of({0, degrees(90.0), radii(3)});
    view.image = {kSide, kSide, degrees(45.0)};
    return view;
}

double mixed(const TestGlass& glass, size_t channel, double behind)
{
    return std::min(255.0, glass.added[channel] + glass.passed[channel] * behind / 255);
}

// The worst difference in the middle of a picture from what stands there, of 255.
double off_middle(const Rgb8& shown, const std::array<double, 3>& wanted)
{
    return std::max({std::abs(shown.r - wanted[0]), std::abs(shown.g - wanted[1]), std::abs(shown.b - wanted[2])});
}

const TestGlass kRed = {{60, 8, 0}, {160, 90, 30}}, kBlue = {{5, 20, 90}, {100, 190, 240}};

GlassPalette red_and_blue()
{
    GlassPalette palette{};
    palette[1] = kRed;
    palette[2] = kBlue;
    return palette;
}

// An opaque pane below a red one and, above that, a blue one; `swapped`: in the file, blue is first.
Bytes two_panes(bool swapped, DrawingOrder order = DrawingOrder::by_depth)
{
    const TestPane red = {7000, 1000, 1}, blue = {7000, 6000, 2}, below = {9000, -4000, 100};
    return see_through_file(panes(swapped ? std::vector{below, blue, red} : std::vector{below, red, blue}), 1,
                            red_and_blue(), order);
}

std::array<double, 3> through_both(const std::array<double, 3>& behind)
{
    std::array<double, 3> result{};
    for (size_t c = 0; c < 3; ++c) result[c] = mixed(kBlue, c, mixed(kRed, c, behind[c]));
    return result;
}

}  // namespace

TEST_CASE("panes blend over what lies behind, from far to near, in any order of the file")
{
    const std::array<double, 3> wanted = through_both({100, 155, 90});  // colour 100 of the opaque palette
    for (const bool swapped : {false, true}) {
        const OpenedGlass opened(two_panes(swapped));
        REQUIRE(opened.error() == FieldError::none);
        CHECK(opened.field().patch_count == 1);
        CHECK(opened.field().see_through_count == 2);
        for (const SurfaceMode mode : kSurfaceModes) {
            CAPTURE(swapped, static_cast<int>(mode));
            const test::View view = from_above();
            // A level for each rounding; of 5-6-5 pixels, which hold what lies behind too, a step for each pane.
            const auto middle = [&](auto pixel) {
                using Pixel = decltype(pixel);
                return off_middle(drawn<Pixel>(opened.field(), view, mode, OverBlack{}).at(kSide / 2, kSide / 2),
                                  wanted);
            };
            CHECK(middle(PixelRgb888{}) <= 2);
            CHECK(middle(PixelRgb565{}) <= 10);
            CHECK(middle(PixelRgb565Swapped{}) <= 10);
            CHECK(middle(PixelBgr555{}) <= 10);
        }
    }
}

TEST_CASE("a field that has an order of its own is drawn in that order, whatever the depths")
{
    const std::array<double, 3> behind = {100, 155, 90};
    std::array<double, 3> blue_first{};
    for (size_t c = 0; c < 3; ++c) blue_first[c] = mixed(kRed, c, mixed(kBlue, c, behind[c]));
    for (const bool swapped : {false, true}) {
        const OpenedGlass opened(two_panes(swapped, DrawingOrder::of_the_file));
        REQUIRE(opened.error() == FieldError::none);
        for (const SurfaceMode mode : kSurfaceModes) {
            CAPTURE(swapped, static_cast<int>(mode));
            Drawn<PixelRgb888> shown = drawn<PixelRgb888>(opened.field(), from_above(), mode, OverBlack{});
            CHECK(off_middle(shown.at(kSide / 2, kSide / 2), swapped ? blue_first : through_both(behind)) <= 2);
        }
    }
}

TEST_CASE("glass that opaque parts hide does not show, and clear glass changes nothing")
{
    GlassPalette palette = red_and_blue();
    palette[3] = {{0, 0, 0}, {255, 255, 255}};
    const OpenedGlass bare(see_through_file(panes({{9000, 0, 100}, {7000, -5000, 1}}), 1, palette));
    const OpenedGlass hidden(see_through_file(panes({{9000, 0, 100}, {7000, -5000, 2}}), 1, palette));
    const OpenedGlass clear(see_through_file(panes({{9000, 0, 100}, {7000, 5000, 3}}), 1, palette));
    for (const SurfaceMode mode : kSurfaceModes) {
        const test::View view = from_above();
        CAPTURE(static_cast<int>(mode));
        const auto pixels = [&](const OpenedGlass& opened, auto pixel) {
            return drawn<decltype(pixel)>(opened.field(), view, mode, OverBlack{}).pixels();
        };
        CHECK((pixels(bare, PixelRgb888{}) == pixels(hidden, PixelRgb888{})));
        CHECK((pixels(bare, PixelRgb565{}) == pixels(clear, PixelRgb565{})));
        if (mode != SurfaceMode::antialiased) CHECK((pixels(bare, PixelRgb888{}) == pixels(clear, PixelRgb888{})));
    }
}

TEST_CASE("a colour and a stripe's own content show through glass")
{
    const OpenedGlass opened(see_through_file(panes({{500, -9000, 100}, {8000, 1000, 1}}), 1, red_and_blue()));
    const int32_t x = kSide / 2 - 5, y = kSide / 2 + 5;
    for (const SurfaceMode mode : kSurfaceModes) {
        CAPTURE(static_cast<int>(mode));
        const auto check = [&](auto pixel, double tolerance) {
            using Pixel = decltype(pixel);
            const Rgb8 grey = {200, 200, 200};
            const Rgb8 over = drawn<Pixel>(opened.field(), from_above(), mode, OverColour{grey}).at(x, y);
            CHECK(off_middle(over, {mixed(kRed, 0, 200), mixed(kRed, 1, 200), mixed(kRed, 2, 200)}) <= tolerance);
            const int32_t k = y * kSide + x;
            const Rgb8 shown = drawn<Pixel>(opened.field(), from_above(), mode, OverStripe{}).at(x, y);
            CHECK(off_middle(shown, {mixed(kRed, 0, k & 255), mixed(kRed, 1, y * 6), mixed(kRed, 2, x)}) <= tolerance);
        };
        check(PixelRgb888{}, 2);
        check(PixelRgb565{}, 10);
        check(PixelBgr555{}, 10);
    }
}

TEST_CASE("glass over nothing, laid over a colour, is glass over that colour")
{
    // Grey glass: one number of coverage tells all of it.
    GlassPalette palette{};
    palette[1] = {{70, 30, 10}, {120, 120, 120}};
    palette[2] = {{10, 60, 20}, {200, 200, 200}};
    const OpenedGlass opened(
        see_through_file(panes({{2000, -6000, 100}, {8000, 1000, 1}, {6000, 5000, 2}}), 1, palette));
    constexpr int32_t kUnder = 180;
    for (const SurfaceMode mode : kSurfaceModes) {
        Drawn<PixelArgb8888> argb = drawn<PixelArgb8888>(opened.field(), from_above(), mode, OverNothing{});
        Drawn<PixelRgb888> over =
            drawn<PixelRgb888>(opened.field(), from_above(), mode, OverColour{{kUnder, kUnder, kUnder}});
        Drawn<PixelA8> alone = drawn<PixelA8>(opened.field(), from_above(), mode, OverNothing{});
        double worst = 0, worst_inside = 0;
        int32_t worst_coverage = 0;
        for (int32_t k = 0; k < kSide * kSide; ++k) {
            const uint8_t* p = argb.first() + 4 * k;
            const Rgb8 wanted = over.at(k % kSide, k / kSide);
            const auto laid = [&](uint8_t level) { return (level * p[3] + kUnder * (255.0 - p[3])) / 255; };
            const double off = off_middle(wanted, {laid(p[2]), laid(p[1]), laid(p[0])});
            const bool is_inside = std::abs(k % kSide - kSide / 2) > 8;  // no outline of the opaque pane
            worst = std::max(worst, off);
            if (is_inside) worst_inside = std::max(worst_inside, off);
            worst_coverage = std::max<int32_t>({worst_coverage, std::abs(p[3] - argb.coverage[static_cast<size_t>(k)]),
                                                std::abs(p[3] - alone.first()[k])});
        }
        CAPTURE(static_cast<int>(mode), worst, worst_inside);
        CHECK(worst_coverage == 0);
        // Where the pane ends, 2 × 2 mixes four samples as light over a colour, and as levels over nothing.
        CHECK(worst_inside <= (mode == SurfaceMode::two_by_two ? 30 : 4));
        CHECK(worst <= 30);
    }
}

TEST_CASE("outlines of glass over a colour are as smooth as those of four samples")
{
    GlassPalette even{};
    even.fill({{40, 40, 40}, {90, 90, 90}});
    const OpenedGlass opened(see_through_file(bumpy_ball(), 0, even));
    REQUIRE(opened.error() == FieldError::none);
    const OverColour bright{{250, 250, 250}};
    const auto steps = [&](SurfaceMode mode) {
        Drawn<PixelRgb888> one = drawn<PixelRgb888>(opened.field(), from_above(), mode, bright);
        Drawn<PixelRgb888> four = drawn<PixelRgb888>(opened.field(), from_above(), SurfaceMode::two_by_two, bright);
        int count = 0;
        for (int32_t k = 0; k < kSide * kSide; ++k)
            count += std::abs(one.at(k % kSide, k / kSide).g - four.at(k % kSide, k / kSide).g) > 40 ? 1 : 0;
        return count;
    };
    const int jagged = steps(SurfaceMode::one_sample), smooth = steps(SurfaceMode::antialiased);
    CAPTURE(jagged, smooth);
    CHECK(jagged > 20);
    CHECK(smooth < jagged / 2);
}

TEST_CASE("surfaces with glass are the same in rectangles of any size, over everything")
{
    std::minstd_rand random(5);
    const OpenedGlass by_depth(see_through_file(bumpy_ball(), kFirstOfBall));
    const OpenedGlass in_order(see_through_file(bumpy_ball(), kFirstOfBall, many_glasses(), DrawingOrder::of_the_file));
    REQUIRE(by_depth.error() == FieldError::none);
    REQUIRE(in_order.error() == FieldError::none);
    for (int k = 0; k < kViews; ++k) {
        const OpenedGlass& opened = k % 4 < 2 ? by_depth : in_order;
        const test::View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[k % 3];
        const Area area = {1 + static_cast<int32_t>(random() % kSide), 1 + static_cast<int32_t>(random() % 20),
                           k % 2 == 0};
        CAPTURE(k, static_cast<int>(mode), area.width, area.height);
        const auto is_same = [&](auto pixel, const auto& background) {
            using Pixel = decltype(pixel);
            return drawn<Pixel>(opened.field(), view, mode, background).pixels() ==
                   drawn<Pixel>(opened.field(), view, mode, background, area).pixels();
        };
        CHECK(is_same(PixelRgb565{}, OverColour{{90, 80, 70}}));
        CHECK(is_same(PixelRgb565{}, OverStripe{}));
        CHECK(is_same(PixelRgb888{}, OverColour{{90, 80, 70}}));
        CHECK(is_same(PixelRgb888{}, OverStripe{}));
        CHECK(is_same(PixelArgb8888{}, OverNothing{}));
        Bytes swapped = drawn<PixelRgb565Swapped>(opened.field(), view, mode, OverBlack{}, area).pixels();
        for (size_t p = 0; p < swapped.size(); p += 2) std::swap(swapped[p], swapped[p + 1]);
        CHECK((swapped == drawn<PixelRgb565>(opened.field(), view, mode, OverBlack{}).pixels()));
    }
}

TEST_CASE("an opaque edge behind glass marks no pixels that show glass alone")
{
    // Their depths tell how much glass covers, which depends on what a stripe holds: they must not decide.
    constexpr int32_t kWidth = 4, kHeight = 4;
    for (const bool has_inside : {false, true}) {
        std::vector<uint32_t> memory(sample_bytes(kWidth, kHeight, 2, true) / 4);
        const uint32_t row_bytes = sample_row_bytes(kWidth, 2);
        const Target target = {reinterpret_cast<uint8_t*>(memory.data()),
                               row_bytes,
                               2 * even(kWidth + 1),
                               kWidth,
                               kHeight,
                               memory.data() + kHeight * row_bytes / 4,
                               0,
                               0,
                               nullptr,
                               true,
                               -1};
        for (int32_t y = 0; y < kHeight; ++y)
            for (int32_t x = 0; x < kWidth; ++x)
                target.depths(y)[x] = static_cast<uint16_t>(x < 2 ? kShownDepth : has_inside ? 40000 : kFarDepth - 1);
        // Downwards at x = 2.2, so its inside is to the right.
        const auto vertex = [](int32_t x_q6, int32_t y_q6) { return packed({x_q6, y_q6, 30000}, 0); };
        mark_edge(vertex(141, 0), vertex(141, 256), false, target);
        CHECK(is_marked(target, 1, 1) == false);
        CHECK(is_marked(target, 2, 1) == has_inside);
    }
}

TEST_CASE("surfaces with glass are the same on every processor")
{
    const OpenedGlass opened(see_through_file(bumpy_ball(), kFirstOfBall));
    uint32_t crc = 0;
    for (int k = 0; k < 6; ++k) {
        const double turn = 0.7 * k, height = k - 2.5;
        const test::View view = {"",
                                 look_at({2.2 * std::cos(turn), 2.2 * std::sin(turn), 0.6 * height}, {0, 0, 0}),
                                 {kSide, kSide, degrees(50.0)}};
        const auto add = [&](auto pixel, const auto& background) {
            const Bytes pixels =
                drawn<decltype(pixel)>(opened.field(), view, kSurfaceModes[k % 3], background).pixels();
            crc = crc32(crc, pixels.data(), pixels.size());
        };
        add(PixelRgb565{}, OverBlack{});
        add(PixelRgb888{}, OverColour{{200, 100, 50}});
        add(PixelArgb8888{}, OverNothing{});
    }
    CHECK(crc == 0xD167DEF9);
}

TEST_CASE("a field without glass shows the same pixels where glass could be")
{
    std::minstd_rand random(6);
    const Bytes file = surface_file(bumpy_ball());
    const OpenedGlass opened(file);
    const OpenedSurface plain(file);
    REQUIRE(opened.error() == FieldError::none);
    for (int k = 0; k < kViews; ++k) {
        const test::View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[k % 3];
        CHECK((drawn<PixelRgb888>(opened.field(), view, mode).pixels() == surface_picture(plain.field(), view, mode)));
    }
}

TEST_CASE("glass is refused by name where nothing draws it, and where there is more than memory for it")
{
    const Bytes file = see_through_file(bumpy_ball(), kFirstOfBall);
    SurfaceField opaque;
    CHECK(open_surface(file.data(), file.size(), opaque) == FieldError::see_through);
    static lumi::View<SurfaceDrawing<98, 128>, Screen<kSide, kSide, 8>> without;
    static lumi::View<SurfaceDrawing<98, 60, SurfaceMode::antialiased, 20>, Screen<kSide, kSide, 8>> few;
    static lumi::View<SurfaceDrawing<98, 60, SurfaceMode::antialiased, 68>, Screen<kSide, kSide, 8>> enough;
    CHECK(without.open(file.data(), file.size()) == static_cast<ViewError>(FieldError::see_through));
    CHECK(std::string(error_text(static_cast<ViewError>(FieldError::see_through))).find("SSEE") != std::string::npos);
    CHECK(few.open(file.data(), file.size()) == ViewError::field_too_large);
    REQUIRE(enough.open(file.data(), file.size()) == ViewError::none);
    REQUIRE(enough.look(Orbit{degrees(30.0), degrees(20.0), radii(3)}) == ViewError::none);
    alignas(4) static uint8_t pixels[2 * kSide * 8];
    CHECK(enough.draw({pixels, 0, 16, kSide, 8, 2 * kSide}) == ViewError::none);
}

TEST_CASE("a reader without see-through parts leaves shadows out, and draws the rest")
{
    TestSurface s = bumpy_ball();
    const auto patches = static_cast<uint32_t>(s.patches.size());
    const auto file_with = [&](uint32_t shadows, uint32_t flags) {
        s.shadows = shadows;
        std::vector<TestSection> sections = see_through_sections(s, kFirstOfBall, many_glasses());
        sections.back().flags = flags;
        return file_of(sections);
    };
    const auto opened = [](const Bytes& file) {
        SurfaceField field;
        return open_surface(file.data(), file.size(), field);
    };
    CHECK(opened(file_with(patches, 0)) == FieldError::bad_surface);
    CHECK(opened(file_with(patches - kFirstOfBall, format::kRequired)) == FieldError::see_through);
    const Bytes file = file_with(patches - kFirstOfBall, 0);
    SurfaceField alone, whole;
    REQUIRE(open_surface(file.data(), file.size(), alone) == FieldError::none);
    REQUIRE(open_surface<SurfaceFeatures::all>(file.data(), file.size(), whole) == FieldError::none);
    CHECK(alone.patch_count == kFirstOfBall);
    CHECK(whole.see_through_count == patches - kFirstOfBall);
    whole.see_through_count = 0;
    const test::View view = extreme_views(kSide)[0];
    for (const SurfaceMode mode : kSurfaceModes)
        CHECK(drawn<PixelRgb565>(alone, view, mode, OverBlack{}).pixels() ==
              drawn<PixelRgb565>(whole, view, mode, OverBlack{}).pixels());
}

TEST_CASE("sections of see-through parts that are wrong are refused by name")
{
    const TestSurface ball = bumpy_ball();
    const auto opened = [&](uint32_t first, const std::function<void(Bytes&)>& change) {
        std::vector<TestSection> sections = see_through_sections(ball, kFirstOfBall, many_glasses());
        sections.back() = see_through_section(first, many_glasses());
        change(sections.back().bytes);
        return OpenedGlass(file_of(sections)).error();
    };
    const auto patches = static_cast<uint32_t>(ball.patches.size());
    CHECK(opened(
              kFirstOfBall, [](Bytes&) {}) == FieldError::none);
    CHECK(opened(
              kFirstOfBall, [](Bytes& b) { b.pop_back(); }) == FieldError::bad_see_through);
    CHECK(opened(
              kFirstOfBall, [](Bytes& b) { b.push_back(0); }) == FieldError::bad_see_through);
    CHECK(opened(
              kFirstOfBall, [](Bytes& b) { b[2] = 1; }) == FieldError::none);
    CHECK(opened(
              kFirstOfBall, [](Bytes& b) { b[2] = 2; }) == FieldError::bad_see_through);
    CHECK(opened(kFirstOfBall, [](Bytes& b) { b[3] = 1; }) == FieldError::bad_see_through);
    CHECK(opened(patches, [](Bytes&) {}) == FieldError::bad_see_through);
    CHECK(opened(patches - 1, [](Bytes&) {}) == FieldError::none);
    CHECK(opened(kFirstOfBall - 8, [](Bytes&) {}) == FieldError::bad_neighbours);
    check_other_sizes_are_refused(see_through_file(ball, kFirstOfBall), [](const Bytes& bytes) {
        SurfaceField field;
        return open_surface<SurfaceFeatures::all>(bytes.data(), bytes.size(), field);
    });
}

namespace
{

// A convex body of glass: eight triangles around the axes, in pairs across the equator, as neighbours of each other.
TestSurface octahedron()
{
    constexpr int32_t kReach = 12000;
    TestSurface s;
    s.vertices = {{kReach, 0, 0}, {0, kReach, 0}, {-kReach, 0, 0}, {0, -kReach, 0}, {0, 0, kReach}, {0, 0, -kReach}};
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t next = (k + 1) % 4;
        if (k == 0) {  // one pair as lone triangles
            s.patches.push_back({4, k, next});
            s.patches.push_back({5, next, k});
        } else {
            s.patches.push_back({4, k, next, 5});
        }
    }
    for (uint32_t k = 0; k < s.patches.size(); ++k) {
        s.patches[k].begin = k;
        s.texels.push_back(static_cast<uint8_t>(40 * k + 3));
    }
    s.texels.resize(s.texels.size() + format::patch_reach(1));
    return s;
}

// The whole body is see-through and has neighbours, as `change` leaves them.
template <class Change>
Bytes glass_octahedron(Change change)
{
    const TestSurface s = octahedron();
    std::vector<TestSection> sections = surface_sections(s);
    sections.push_back(see_through_section(0, many_glasses()));
    for (TestSection& section : sections)
        if (section.type == format::kNeighbourSection) change(section.bytes);
    return file_of(sections);
}

SurfaceField opened_see_through(const Bytes& bytes)
{
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bytes.data(), bytes.size(), field) == FieldError::none);
    return field;
}

}  // namespace

TEST_CASE("sides between two pieces of glass that face the eye are no outlines, and those at its silhouette are")
{
    const Bytes joined = glass_octahedron([](Bytes&) {});
    const Bytes apart = glass_octahedron([](Bytes& b) { std::fill(b.begin(), b.end(), uint8_t{0xFF}); });
    const SurfaceField field = opened_see_through(joined), pieces = opened_see_through(apart);
    const OverColour grey{{200, 190, 180}};
    uint32_t inner = 0, smoothed = 0, missed = 0;
    for (const double azimuth : {10.0, 33.0, 70.0, 200.0}) {
        for (const double elevation : {-50.0, -8.0, 20.0, 65.0}) {
            test::View view = from_above();
            view.pose = pose_of({degrees(azimuth), degrees(elevation), radii(3)});
            Drawn<PixelRgb565> one = drawn<PixelRgb565>(field, view, SurfaceMode::one_sample, grey);
            Drawn<PixelRgb565> whole = drawn<PixelRgb565>(field, view, SurfaceMode::antialiased, grey);
            Drawn<PixelRgb565> parts = drawn<PixelRgb565>(pieces, view, SurfaceMode::antialiased, grey);
            const auto is_same = [](const Rgb8& a, const Rgb8& b) { return a.r == b.r && a.g == b.g && a.b == b.b; };
            for (int32_t y = 2; y < kSide - 2; ++y) {
                for (int32_t x = 2; x < kSide - 2; ++x) {
                    uint32_t around = 0;  // background near by
                    for (int32_t k = 0; k < 25; ++k)
                        around += is_same(one.at(x - 2 + k % 5, y - 2 + k / 5), one.at(0, 0)) ? 1u : 0u;
                    INFO(azimuth << ", " << elevation << " at " << x << ", " << y);
                    if (around == 0) {
                        REQUIRE(is_same(whole.at(x, y), one.at(x, y)));
                        inner += is_same(parts.at(x, y), one.at(x, y)) ? 0u : 1u;
                    } else {
                        smoothed += is_same(whole.at(x, y), one.at(x, y)) ? 0u : 1u;
                        missed += is_same(whole.at(x, y), parts.at(x, y)) ? 0u : 1u;
                    }
                }
            }
        }
    }
    CHECK(inner > 100);  // where neighbours are unknown, each side is one
    CHECK(smoothed > 200);
    CHECK(missed < 300);  // where inner sides end at the silhouette; 380 if first sides were no outlines
}

TEST_CASE("neighbours of see-through patches that contradict each other draw the same in stripes as at once")
{
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const Bytes bytes = glass_octahedron([&](Bytes& b) {
            for (size_t k = 0; k < b.size(); k += 2) {
                const uint32_t any = scattered(seed * 1000 + static_cast<uint32_t>(k)) % 11;  // 0 .. 9: all that are
                b[k] = static_cast<uint8_t>(any == 10 ? 0xFF : any);
                b[k + 1] = static_cast<uint8_t>(any == 10 ? 0xFF : 0);
            }
        });
        const SurfaceField field = opened_see_through(bytes);
        test::View view = from_above();
        view.pose = pose_of({degrees(seed * 25.0), degrees(30.0 - seed), radii(2)});
        const auto once = drawn<PixelRgb565>(field, view, SurfaceMode::antialiased, OverBlack{});
        const auto stripes = drawn<PixelRgb565>(field, view, SurfaceMode::antialiased, OverBlack{}, {13, 7});
        CHECK(once.words == stripes.words);
    }
}
