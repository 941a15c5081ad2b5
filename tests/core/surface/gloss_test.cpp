// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/gloss.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "gloss_bytes.h"
#include "halves.h"
#include "lumi/surface/view.h"
#include "surface/projection.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 64;
#ifdef LUMI_TEST_LIGHT
constexpr int kLooks = 12;
#else
constexpr int kLooks = 100;
#endif

double any(std::minstd_rand& random)
{
    return static_cast<double>(random() % 2001) / 1000 - 1;
}

FieldError opened(const Bytes& bytes)
{
    return OpenedGlass(bytes).error();
}

// A ball of one grey without differences in its tables, whose patches all have one map.
constexpr double kBallRadius = 0.8;
constexpr uint8_t kGrey = 60;

TestSurface smooth_ball()
{
    TestSurface s = BumpyBall(20).take();
    for (SurfacePoint& v : s.vertices) {
        const double length = std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
        for (int32_t& c : v) c = static_cast<int32_t>(std::lround(c * kBallRadius * 16384 / length));
    }
    s.viewed = static_cast<uint32_t>(s.vertices.size());
    put_texels(s);
    s.texels.assign(s.texels.size(), 0);
    return s;
}

Bytes mirror_ball(const GlossOf& map, const std::array<uint8_t, 3>& gains)
{
    const TestSurface s = smooth_ball();
    std::vector<TestSection> sections = surface_sections(s);
    for (TestSection& section : sections) {
        if (section.type == format::kPaletteRgb) section.bytes.assign(section.bytes.size(), kGrey);
        if (section.type == format::kViewSection)
            std::fill_n(section.bytes.begin(), format::view_colours_bytes(s.code_bits), uint8_t{0});
    }
    sections.push_back(gloss_section({{gains}, {gloss_map(map)}, std::vector<uint8_t>(s.patches.size(), 1)}));
    return file_of(sections);
}

using Vec = twin::Vec3;

// Finds what an exact mirror ball shows at a pixel; false where the ray passes it by or grazes it.
bool mirrored(const test::View& view, int32_t x, int32_t y, Vec& direction)
{
    const auto unit = [](const Vec3q30& v) { return Vec{v.x / 0x1p30, v.y / 0x1p30, v.z / 0x1p30}; };
    const Pose& pose = view.pose;
    const Vec eye = {pose.eye.x / 0x1p20, pose.eye.y / 0x1p20, pose.eye.z / 0x1p20};
    const double half = view.image.width_px / 2.0, focal = half / std::tan(view.image.fov_turns32 / 0x1p32 * twin::kPi);
    const Vec way = twin::normalised((x + 0.5 - half) / focal * unit(pose.right) +
                                     (half - y - 0.5) / focal * unit(pose.up) + unit(pose.forward));
    const double along = dot(eye, way), under = along * along - dot(eye, eye) + kBallRadius * kBallRadius;
    if (under <= 0) return false;
    const Vec n = (1 / kBallRadius) * (eye + (-along - std::sqrt(under)) * way);
    const double cosine = -dot(n, way);
    direction = way + (2 * cosine) * n;
    return cosine > 0.5;
}

}  // namespace

TEST_CASE("gloss: a mirror ball shows the map in mirrored directions")
{
    // Bands of light that lie in no plane of the map's seams.
    const GlossOf bands = [](const std::array<double, 3>& d) {
        return 127.5 + 127.5 * std::sin(3 * (0.48 * d[0] + 0.6 * d[1] + 0.64 * d[2]));
    };
    const std::array<uint8_t, 3> gains = {32, 40, 20};
    const OpenedGlass ball(mirror_ball(bands, gains));
    REQUIRE(ball.error() == FieldError::none);
    std::minstd_rand random(5);
    double squares = 0, worst = 0;
    int count = 0;
    for (int look = 0; look < 18; ++look) {
        const double far[] = {1.4, 2, 3, 6, 40};
        const Vec to_eye = twin::normalised({any(random), any(random), any(random) + 1e-3});
        const double distance = far[look % 5], fov = 2 * std::asin(0.9 / distance) * 180 / twin::kPi;
        const test::View view = {
            "", look_at(distance * to_eye, {0, 0, 0}, look * 40.0), {kSide, kSide, test::degrees(fov)}};
        const Bytes pixels = drawn<PixelRgb888>(ball.field(), view, SurfaceMode::one_sample).pixels();
        for (int32_t y = 0; y < kSide; ++y) {
            for (int32_t x = 0; x < kSide; ++x) {
                Vec d;
                if (!mirrored(view, x, y, d)) continue;
                const double step = bands({d.x, d.y, d.z}) / 64;
                for (size_t c = 0; c < 3; ++c) {
                    const double expected = kGrey + step * gains[c];
                    const double off = std::fabs(pixels[3 * static_cast<size_t>(y * kSide + x) + c] - expected);
                    squares += off * off;
                    worst = std::max(worst, off);
                    ++count;
                }
            }
        }
    }
    REQUIRE(count > 20000);
    std::cout << "mirror ball: " << std::sqrt(squares / count) << " levels root mean square, " << worst << " at most\n";
    // A texel of the disc is 6° wide in mirrored directions, and 12° where the cosine is one half; over a degree the
    // bands change by up to 4 levels. Turns are exact to half a degree, places to a quarter of a texel.
    CHECK(std::sqrt(squares / count) < 3);
    CHECK(worst < 40);
}

TEST_CASE("gloss: any rectangle shows the same pixels, and two halves make the same frame")
{
    const TestSurface s = ball_for_gloss();
    const TestMover m = moving_ball(9);
    const OpenedGlass still(glossy_file(s, any_gloss(s))), moving(glossy_file(m, gloss_of_body(m)));
    REQUIRE(still.error() == FieldError::none);
    REQUIRE(moving.error() == FieldError::none);
    std::minstd_rand random(17);
    for (int look = 0; look < kLooks; ++look) {
        const OpenedGlass& ball = look % 4 == 0 ? moving : still;
        const test::View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[look % 3];
        const auto some = [&] { return static_cast<int32_t>(1 + random() % kSide); };
        INFO("look " << look);
        REQUIRE(
            (drawn<PixelRgb888>(ball.field(), view, mode).pixels() ==
             drawn<PixelRgb888>(ball.field(), view, mode, OverColour{kSurfaceBackground}, {some(), some()}).pixels()));
        REQUIRE(
            (drawn<PixelRgb565>(ball.field(), view, mode).pixels() ==
             drawn<PixelRgb565>(ball.field(), view, mode, OverColour{kSurfaceBackground}, {some(), some()}).pixels()));
        check_halves(ball.field(), {{view.pose, view.image, 0, 0, kSide, kSide}, static_cast<uint32_t>(random())},
                     [](SurfaceHalves& halves, int32_t step) {
                         prepare_half<SurfaceMode::two_by_two, kAll>(halves, step, 0);
                         prepare_half<SurfaceMode::two_by_two, kAll>(halves, step, 1);
                     });
    }
    for (const test::View& view : extreme_views(kSide))
        for (const SurfaceMode mode : kSurfaceModes)
            CHECK((drawn<PixelRgb888>(still.field(), view, mode).pixels() ==
                   drawn<PixelRgb888>(still.field(), view, mode, OverColour{kSurfaceBackground}, {13, 9}).pixels()));
}

namespace
{

// A file of one map over all patches, with these turns at the vertices.
Bytes file_with_turns(TestSurface s, const std::vector<std::array<int, 3>>& turns)
{
    s.viewed = static_cast<uint32_t>(s.vertices.size());
    put_texels(s);
    std::vector<TestSection> sections = surface_sections(s);
    for (TestSection& section : sections) {
        if (section.type != format::kViewSection) continue;
        for (size_t v = 0; v < turns.size(); ++v)
            for (size_t c = 0; c < 3; ++c)
                section.bytes[format::view_colours_bytes(s.code_bits) + v * format::view_bytes(s.code_bits) +
                              format::view_turn_at(s.code_bits) + c] = static_cast<uint8_t>(turns[v][c]);
    }
    const GlossOf grey = [](const std::array<double, 3>&) { return 128.0; };
    sections.push_back(gloss_section({{{64, 64, 64}}, {gloss_map(grey)}, std::vector<uint8_t>(s.patches.size(), 1)}));
    return file_of(sections);
}

const Pose kFromAbove = {{0, 0, kOneQ20 * 6 / 5}, {kOneQ30, 0, 0}, {0, kOneQ30, 0}, {0, 0, -kOneQ30}};

// Whether those of lit vertices lie between the first texel's middle and the last one's, as what reads them expects.
void check_places(const PreparedFrame& made)
{
    const GlossMemory memory(made.frame);
    constexpr uint32_t kLeast = 4, kMost = 4 * (kGlossDiscSide - 1);  // quarters of a texel
    for (size_t v = 0; v < made.frame.field.viewed_count; ++v) {
        if (made.vertices[v].colour == kUnlit) continue;
        const uint32_t across = memory.places[v] & 0xFFu, down = memory.places[v] >> 8;
        if (across < kLeast || across > kMost || down < kLeast || down > kMost)
            FAIL_CHECK("vertex " << v << " lies at " << across << ", " << down);
    }
}

}  // namespace

TEST_CASE("gloss: vertices lie in the disc, also where what they mirror is behind the camera")
{
    TestSurface s;  // both sides of a triangle
    s.vertices = {{12288, -4000, 9000}, {12288, 3000, 9000}, {9500, 0, 9300}};
    s.patches = {{0, 1, 2}, {0, 2, 1}};
    const OpenedGlass hard(file_with_turns(s, {{0, 0, 127}, {0, 0, 127}, {-104, 0, 72}}));
    REQUIRE(hard.error() == FieldError::none);
    const Image wide = {240, 240, test::degrees(100.0)};
    PreparedFrame made(hard.field(), 240, 4);
    made.prepare<PixelRgb888>(hard.field(), {"", kFromAbove, wide}, SurfaceMode::one_sample);
    check_places(made);
    picture(made.frame, {kFromAbove, wide, 0, 0, 240, 240});
    std::minstd_rand random(21);
    for (int look = 0; look < kLooks; ++look) {
        std::vector<std::array<int, 3>> turns;
        const TestSurface ball = ball_for_gloss();
        for (size_t v = 0; v < ball.vertices.size(); ++v) {
            const Vec turn = 127 * twin::normalised({any(random), any(random), any(random) + 1e-3});
            const auto byte = [](double c) { return static_cast<int>(std::lround(c)); };
            turns.push_back({byte(turn.x), byte(turn.y), byte(turn.z)});
        }
        const OpenedGlass opened(file_with_turns(ball, turns));
        REQUIRE(opened.error() == FieldError::none);
        const test::View view = random_view(random, kSide);
        PreparedFrame frame(opened.field(), view.image.height_px);
        frame.prepare<PixelRgb888>(opened.field(), view, kSurfaceModes[look % 3]);
        check_places(frame);
        picture(frame.frame, {view.pose, view.image, 0, 0, view.image.width_px, view.image.height_px});
    }
}

// A sanitizer sees a read beyond: the frame's memory of features ends with the places.
TEST_CASE("gloss: no read leaves the disc, whatever lies where places should be, also of pieces of cut triangles")
{
    TestSurface s;
    s.vertices = {{0, 0, 0}, {-378, 413, 0}, {1100, -1202, 0}, {-1585, 1353, 0}};
    s.patches = {{0, 1, 2, 3}, {0, 2, 1, 3}};
    const OpenedGlass opened(file_with_turns(s, std::vector<std::array<int, 3>>(4, {0, 0, 127})));
    REQUIRE(opened.error() == FieldError::none);
    constexpr int32_t kLarge = 8192, kMiddle = 1400, kFirst = (kLarge - kMiddle) / 2, kRows = 50;
    const Image narrow = {kLarge, kLarge, test::degrees(1.01)};
    PreparedFrame made(opened.field(), kLarge, 4);
    made.prepare<PixelRgb888>(opened.field(), {"", kFromAbove, narrow}, SurfaceMode::one_sample);
    uint16_t* const places = GlossMemory(made.frame).places;
    for (const std::array<uint16_t, 4>& any_places : {std::array<uint16_t, 4>{0x0450, 0x0450, 0x0450, 0x9450},
                                                      {0x9450, 0x9450, 0x9450, 0x0450},
                                                      {0, 0, 0, 0},
                                                      {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}}) {
        std::copy(any_places.begin(), any_places.end(), places);
        uint32_t drawn = 0;
        for (int32_t y = kFirst; y < kFirst + kMiddle; y += kRows) {
            const Bytes pixels = picture(made.frame, {kFromAbove, narrow, kFirst, y, kMiddle, kRows});
            for (const uint8_t byte : pixels) drawn += byte != pixels[0] ? 1u : 0u;
        }
        CHECK(drawn > 10000);
    }
}

TEST_CASE("gloss: swapped pixels show what others show")
{
    const TestSurface s = ball_for_gloss();
    const OpenedGlass glossy(glossy_file(s, any_gloss(s)));
    std::minstd_rand random(18);
    for (int look = 0; look < kLooks; ++look) {
        const test::View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[look % 3];
        const Bytes low = drawn<PixelRgb565>(glossy.field(), view, mode).pixels(),
                    high = drawn<PixelRgb565Swapped>(glossy.field(), view, mode).pixels();
        for (size_t k = 0; k < low.size(); k += 2) REQUIRE((low[k] == high[k + 1] && low[k + 1] == high[k]));
    }
}

TEST_CASE("gloss: sections that are wrong are refused by name, and no byte of them leads astray")
{
    const TestSurface s = ball_for_gloss();
    const TestGloss right = any_gloss(s);
    const auto with = [&](const std::function<void(Bytes&)>& change) {
        std::vector<TestSection> sections = surface_sections(s);
        sections.push_back(gloss_section(right));
        change(sections.back().bytes);
        return file_of(sections);
    };
    const size_t size = gloss_section(right).bytes.size();
    REQUIRE(opened(glossy_file(s, right)) == FieldError::none);
    for (size_t cut = 1; cut <= size; cut += 1 + cut / 20)
        if (opened(with([&](Bytes& b) { b.resize(size - cut); })) != FieldError::bad_gloss) FAIL_CHECK(cut);
    CHECK(opened(with([](Bytes& b) { b.push_back(0); })) == FieldError::bad_gloss);
    for (const uint8_t maps : Bytes{0, 1, 2, 4, 255})
        CHECK(opened(with([&](Bytes& b) { b[0] = maps; })) == FieldError::bad_gloss);
    for (const size_t zero : {1u, 2u, 3u, 7u, 11u, 15u})
        CHECK(opened(with([&](Bytes& b) { b[zero] = 1; })) == FieldError::bad_gloss);
    TestSurface fewer = s;  // of some glossy patch a corner has no table
    fewer.viewed -= 1;
    CHECK(opened(glossy_file(fewer, right)) == FieldError::bad_gloss);
    TestGloss one = right;  // patches name maps that there are not
    one.gains.resize(1);
    one.maps.resize(1);
    CHECK(opened(glossy_file(s, one)) == FieldError::bad_gloss);
    TestSurface triangle;
    triangle.vertices = {{9000, 0, 0}, {0, 9000, 0}, {0, 0, 9000}};
    triangle.patches = {{0, 1, 2}};
    CHECK(opened(file_with_turns(triangle, {{127, 0, 0}, {-74, -74, 73}, {-128, 0, 0}})) == FieldError::none);
    CHECK(opened(file_with_turns(triangle, {{127, 0, 0}, {-128, -128, 100}, {0, 0, 127}})) == FieldError::bad_gloss);
    CHECK(opened(file_with_turns(triangle, {{127, 0, 0}, {0, 0, 127}, {127, 16, 3}})) == FieldError::bad_gloss);
    std::vector<TestSection> states = surface_sections(s);
    states.push_back(gloss_section(right));
    CHECK(opened(file_with_states(states, light_of(s, two_states()))) == FieldError::bad_gloss);
    TestMover moving = moving_ball();  // its second part has tables everywhere
    TestGloss of_part = gloss_of_body(moving);
    REQUIRE(opened(glossy_file(moving, of_part)) == FieldError::none);
    const size_t patch =
        detail::format::kPartsHeaderBytes + detail::format::kPartBytes + detail::format::part::kFirstPatchAt;
    const uint32_t first = moving.section[patch] + 256u * moving.section[patch + 1];
    of_part.choices[first] = 1;
    CHECK(opened(glossy_file(moving, of_part)) == FieldError::bad_gloss);
}

TEST_CASE("gloss: a firmware that does not name it refuses the field by name")
{
    const TestSurface s = ball_for_gloss();
    const Bytes file = glossy_file(s, any_gloss(s));
    constexpr auto kOthers =
        SurfaceFeatures::view_tables | SurfaceFeatures::see_through | SurfaceFeatures::parts | SurfaceFeatures::states;
    CHECK(Opened<kOthers>(file).error() == FieldError::gloss);
    static lumi::View<SurfaceDrawing<200, 200>, Screen<32, 32, 8>> without;
    CHECK(without.open(file.data(), file.size()) == static_cast<ViewError>(FieldError::gloss));
    CHECK(std::string(error_text(static_cast<ViewError>(FieldError::gloss))).find("SGLO") != std::string::npos);
    static lumi::View<SurfaceDrawing<200, 200, SurfaceMode::antialiased, 0, 200, 0, 0, 2>, Screen<32, 32, 8>> fewer;
    CHECK(fewer.open(file.data(), file.size()) == ViewError::field_too_large);
    static lumi::View<SurfaceDrawing<200, 200, SurfaceMode::antialiased, 0, 200, 0, 0, 3>, Screen<32, 32, 8>> view;
    CHECK(view.open(file.data(), file.size()) == ViewError::none);
    CHECK(view.look(Orbit{}) == ViewError::none);
}
