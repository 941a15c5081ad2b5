// SPDX-License-Identifier: MIT
#include "lumi/surface/parts.h"

#include <catch2/catch.hpp>
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
constexpr int kMoves = 60;
#else
constexpr int kMoves = 600;
#endif

// A frame that lasts, with memory of its very size.
class Mover
{
public:
    explicit Mover(const SurfaceField& field, int32_t height_px = kSide) : field_(field), made_(field, height_px) {}

    bool turn(uint32_t part, uint32_t turns32) { return turn_part(field_, made_.memory, part, turns32); }
    bool slide(uint32_t part, int32_t offset_q20) { return slide_part(field_, made_.memory, part, offset_q20); }
    uint32_t value(uint32_t part) { return moving_part(moving_parts(field_, made_.memory), part).value; }
    void set(uint32_t part, uint32_t value)
    {
        if (!turn(part, value)) REQUIRE(slide(part, static_cast<int32_t>(value)));
    }

    template <SurfaceFeatures kFeatures = kAll>
    Bytes look(const test::View& view, SurfaceMode mode)
    {
        made_.prepare<PixelRgb888, kFeatures>(field_, view, mode);
        return drawn<PixelRgb888, kFeatures>(made_.frame).pixels();
    }

    const SurfaceFrame& frame() const { return made_.frame; }
    bool keeps_body() { return moving_parts(field_, made_.memory).keeps_body; }

private:
    const SurfaceField& field_;
    PreparedFrame made_;
};

// Returns the file without its section of moving parts.
Bytes resting_file(const TestMover& m)
{
    std::vector<TestSection> sections = mover_sections(m);
    sections.pop_back();
    return file_of(sections);
}

uint32_t any(std::minstd_rand& random)
{
    return static_cast<uint32_t>(random()) * 2654435761u ^ static_cast<uint32_t>(random()) << 9;
}

// The least, the greatest, zero, or any value, also beyond the range.
uint32_t any_value(const SurfaceField& field, uint32_t part, std::minstd_rand& random)
{
    const PartMotion m = part_motion(field, part);
    const uint32_t from = static_cast<uint32_t>(m.from);
    const uint32_t values[] = {from, from + m.span, 0, any(random), any(random), from + any(random) % (m.span / 2 + 1)};
    return values[any(random) % 6];
}

// Beside these rectangles both pictures are the same.
bool are_same_beside(const Bytes& before, const Bytes& now, const Image& image, const ChangedRects& changed)
{
    for (int32_t y = 0; y < image.height_px; ++y) {
        for (int32_t x = 0; x < image.width_px; ++x) {
            bool is_inside = false;
            for (uint32_t k = 0; k < changed.count; ++k) {
                const PixelRect& r = changed.rect[k];
                is_inside =
                    is_inside || (x >= r.x_px && x < r.x_px + r.width_px && y >= r.y_px && y < r.y_px + r.height_px);
            }
            const auto at = static_cast<size_t>(3 * (y * image.width_px + x));
            if (!is_inside && !std::equal(&before[at], &before[at] + 3, &now[at])) return false;
        }
    }
    return true;
}

int32_t area(const ChangedRects& changed)
{
    int32_t sum = 0;
    for (uint32_t k = 0; k < changed.count; ++k) sum += changed.rect[k].width_px * changed.rect[k].height_px;
    return sum;
}

}  // namespace

TEST_CASE("parts at rest show the same pixels as a mesh that rests")
{
    std::minstd_rand random(1);
    for (const uint32_t glass : {0u, 9u}) {
        const TestMover m = moving_ball(glass);
        const OpenedGlass moving(mover_file(m)), resting(resting_file(m));
        REQUIRE(moving.error() == FieldError::none);
        REQUIRE(resting.error() == FieldError::none);
        Mover mover(moving.field()), rest(resting.field());
        for (int k = 0; k < kMoves / 10; ++k) {
            const test::View view = random_view(random, kSide);
            const SurfaceMode mode = kSurfaceModes[k % 3];
            CHECK(mover.look(view, mode) == rest.look(view, mode));
        }
        const SurfaceMemory none = {nullptr, nullptr, nullptr, 3};
        CHECK(!may_move(moving.field(), none));  // then they rest, as in programs that do not move them
    }
}

namespace
{

Vec3 turned(const Vec3& v, const Vec3& axis, double turns)
{
    const double angle = 2 * twin::kPi * turns, c = std::cos(angle), s = std::sin(angle);
    const double along = (1 - c) * (axis.x * v.x + axis.y * v.y + axis.z * v.z);
    return c * v + s * cross(axis, v) + along * axis;
}

Vec3 direction(std::minstd_rand& random)
{
    const auto coordinate = [&] { return static_cast<double>(any(random)) / 0x1p31 - 1; };
    return twin::normalised({coordinate(), coordinate(), coordinate() + 1e-3});
}

Vec3 decoded(const Vec3q30& v)
{
    return {v.x / 0x1p30, v.y / 0x1p30, v.z / 0x1p30};
}

// How many of the covered pixels of two pictures differ by more than a few levels.
double share_off(const Bytes& a, const Bytes& b)
{
    constexpr int kLevels = 6;
    uint32_t off = 0, covered = 0;
    for (size_t k = 0; k < a.size(); k += 3) {
        const Rgb8& none = kSurfaceBackground;
        const bool is_covered = a[k] != none.r || a[k + 1] != none.g || a[k + 2] != none.b;
        int worst = 0;
        for (size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[k + c] - b[k + c]));
        covered += is_covered ? 1u : 0u;
        off += worst > kLevels ? 1u : 0u;
    }
    return covered == 0 ? 0 : static_cast<double>(off) / covered;
}

}  // namespace

// Both are seen alike, also where view tables decide, but for roundings: they move a sample over the border of a texel
// or of the part now and then.
TEST_CASE("a part that turns or slides looks as it does at rest from an eye that moves the other way")
{
    constexpr int32_t kLargeSide = 128;
    std::minstd_rand random(3);
    double worst = 0, sum = 0;
    int count = 0;
    for (int k = 0; k < kMoves / 6; ++k) {
        const Vec3 axis = direction(random), pivot = 0.15 * direction(random);
        const bool slides = k % 3 == 0;
        TestPart part = {placed(ball(3, 10), 0.35, {0.1, -0.2, 0.15}),
                         "part",
                         slides,
                         {axis.x, axis.y, axis.z},
                         {pivot.x, pivot.y, pivot.z}};
        part.span = slides ? 2 << 20 : UINT32_MAX;
        part.from = slides ? -(1 << 20) : 0;
        const OpenedGlass opened(mover_file(mover({}, {part})));
        REQUIRE(opened.error() == FieldError::none);
        const double value = slides ? static_cast<double>(any(random)) / 0x1p33 - 0.25 : any(random) / 0x1p32;
        const Vec3 eye = (k % 2 == 0 ? 1.7 : 3.0) * direction(random);
        const Pose pose = look_at(eye, 0.2 * direction(random), k * 10.0);
        const auto back = [&](const Vec3& v) { return slides ? v : turned(v, axis, -value); };
        const Vec3 moved = slides ? eye + (-value) * axis : pivot + back(eye - pivot);
        const auto q20 = [](double v) { return static_cast<int32_t>(std::lround(v * kOneQ20)); };
        const Pose other = {{q20(moved.x), q20(moved.y), q20(moved.z)},
                            twin::encoded(back(decoded(pose.right))),
                            twin::encoded(back(decoded(pose.up))),
                            twin::encoded(back(decoded(pose.forward)))};
        if (twin::length(moved) < 1.01) continue;
        const Image image = {kLargeSide, kLargeSide, degrees(int32_t{60})};
        Mover mover(opened.field(), kLargeSide), rest(opened.field(), kLargeSide);
        mover.set(0, slides ? static_cast<uint32_t>(q20(value)) : static_cast<uint32_t>(std::llround(value * 0x1p32)));
        const SurfaceMode mode = kSurfaceModes[k % 3];
        const double off = share_off(rest.look({"", other, image}, mode), mover.look({"", pose, image}, mode));
        INFO("part " << k << ", value " << value);
        CHECK(off < 0.12);
        worst = std::max(worst, off);
        sum += off;
        ++count;
    }
    std::cout << "moved parts: " << 100 * worst << " % of pixels off at worst, " << 100 * sum / count
              << " % on average\n";
    CHECK(sum / count < 0.02);
}

TEST_CASE("a part that turns below its light keeps the colours of its vertices")
{
    const test::View view = extreme_views(kSide)[0];
    for (const bool light_stays : {true, false}) {
        TestPart part = three_parts()[0];
        part.light_stays = light_stays;
        const OpenedGlass opened(mover_file(mover(ball(3, 0), {part})));
        REQUIRE(opened.error() == FieldError::none);
        CHECK(part_motion(opened.field(), 0).light_stays == light_stays);
        Mover turned(opened.field()), rest(opened.field());
        REQUIRE(turned.turn(0, degrees(int32_t{40})));
        turned.look(view, SurfaceMode::one_sample);
        rest.look(view, SurfaceMode::one_sample);
        uint32_t same = 0, other = 0;
        for (uint32_t k = ball(3, 0).viewed; k < opened.field().viewed_count; ++k) {
            const uint32_t now = turned.frame().memory.vertices[k].colour;
            const uint32_t then = rest.frame().memory.vertices[k].colour;
            if (now != kUnlit && then != kUnlit) ++(now == then ? same : other);
        }
        CHECK(same + other > 5);
        CHECK((other == 0) == light_stays);
    }
}

TEST_CASE("frames that keep the body are those that are prepared anew, and only the rectangles that are told change")
{
    std::minstd_rand random(4);
    const TestMover glossy = moving_ball(), glossy_shaded = shaded_ball(9);
    for (const Bytes& ball :
         {mover_file(moving_ball()), mover_file(moving_ball(9)), mover_file(shaded_ball(0)), mover_file(shaded_ball(9)),
          glossy_file(glossy, gloss_of_body(glossy)), glossy_file(glossy_shaded, gloss_of_body(glossy_shaded))}) {
        const OpenedGlass opened(ball);
        REQUIRE(opened.error() == FieldError::none);
        const std::vector<test::View> extreme = extreme_views(kSide);
        Mover mover(opened.field(), 2 * kSide);
        test::View view = extreme[0];
        SurfaceMode mode = SurfaceMode::antialiased;
        Bytes before;
        int kept = 0, changed_pixels = 0, frames = 0;
        for (int k = 0; k < kMoves; ++k) {
            const uint32_t choice = any(random) % 8;
            if (choice == 0)
                view = any(random) % 4 == 0 ? extreme[any(random) % extreme.size()] : random_view(random, kSide);
            if (choice == 1) mode = kSurfaceModes[any(random) % 3];
            if (choice == 2) {  // hardly: the projection may stay the same
                Vec3q30& axis = any(random) % 2 == 0 ? view.pose.right : view.pose.forward;
                (any(random) % 2 == 0 ? axis.x : axis.z) -= 1 << any(random) % 16;
            }
            for (uint32_t part = 0; part < 3; ++part)
                if (any(random) % 2 == 0) mover.set(part, any_value(opened.field(), part, random));
            const Bytes now = mover.look(view, mode);
            Mover anew(opened.field(), 2 * kSide);
            for (uint32_t part = 0; part < 3; ++part) anew.set(part, mover.value(part));
            INFO("frame " << k << ", " << view.name << ", mode " << static_cast<int>(mode) << ", choice " << choice);
            REQUIRE(now == anew.look(view, mode));
            const uint32_t align_x = 1 + any(random) % 9, align_y = 1 + any(random) % 17;
            const ChangedRects changed = changed_rects(mover.frame(), align_x, align_y);
            REQUIRE(changed.count <= ChangedRects::kMost);
            const auto is_aligned = [](int32_t at, uint32_t align, int32_t size) {
                return at == size || at % static_cast<int32_t>(align) == 0;
            };
            for (uint32_t r = 0; r < changed.count; ++r) {
                const PixelRect& rect = changed.rect[r];
                const int32_t right = rect.x_px + rect.width_px, bottom = rect.y_px + rect.height_px;
                REQUIRE((rect.width_px > 0 && rect.height_px > 0 && rect.x_px >= 0 && rect.y_px >= 0));
                REQUIRE((right <= view.image.width_px && bottom <= view.image.height_px));
                REQUIRE((is_aligned(rect.x_px, align_x, 0) && is_aligned(right, align_x, view.image.width_px)));
                REQUIRE((is_aligned(rect.y_px, align_y, 0) && is_aligned(bottom, align_y, view.image.height_px)));
            }
            if (before.size() == now.size()) REQUIRE(are_same_beside(before, now, view.image, changed));
            before = now;
            if (mover.keeps_body()) {
                ++kept;
                changed_pixels += area(changed_rects(mover.frame()));
                frames += view.image.width_px * view.image.height_px;
            }
        }
        CHECK(kept > kMoves / 2);
        CHECK(changed_pixels < frames * 2 / 3);
        std::cout << "kept " << kept << " of " << kMoves << ", changed " << 100.0 * changed_pixels / frames << " %\n";
    }
}

TEST_CASE("parts beside gloss look as without it, and the body shows its maps")
{
    std::minstd_rand random(11);
    for (const uint32_t glass : {0u, 9u}) {
        const TestMover m = shaded_ball(glass);
        const TestGloss some = gloss_of_body(m);
        TestGloss none = some;
        none.choices.assign(none.choices.size(), 0);
        const OpenedGlass plain(mover_file(m)), unused(glossy_file(m, none)), glossy(glossy_file(m, some));
        REQUIRE(unused.error() == FieldError::none);
        REQUIRE(glossy.error() == FieldError::none);
        Mover movers[] = {Mover(plain.field()), Mover(unused.field()), Mover(glossy.field())};
        const std::vector<test::View> extreme = extreme_views(kSide);
        int different = 0;
        for (int k = 0; k < kMoves / 3; ++k) {
            const test::View view = k % 2 == 0 ? extreme[any(random) % extreme.size()] : random_view(random, kSide);
            for (uint32_t part = 0; part < 3; ++part) {
                const uint32_t value = any_value(plain.field(), part, random);
                for (Mover& one : movers) one.set(part, value);
            }
            const SurfaceMode mode = kSurfaceModes[k % 3];
            const Bytes without = movers[0].look(view, mode);
            REQUIRE(without == movers[1].look(view, mode));
            different += without == movers[2].look(view, mode) ? 0 : 1;
        }
        CHECK(different > kMoves / 10);
    }
}

TEST_CASE("a shadow moves with its part about an axis of its own, and nothing moves it alone")
{
    std::minstd_rand random(9);
    const OpenedGlass opened(mover_file(shaded_ball(9)));
    REQUIRE(opened.error() == FieldError::none);
    CHECK(mover_count(opened.field()) == 3);
    CHECK(opened.field().part_count == 5);
    // The square as a part of another field that moves by itself shows the same glass in the same place.
    TestPart alone = parts_with_shadows()[3];
    alone.follows = 0;
    alone.name = "square";
    const OpenedGlass square(mover_file(mover({}, {alone}))),
        shade(mover_file(mover({}, {three_parts()[0], shadow(three_parts()[0], 1, 3000, {0.5, 0.1, 0.25})})));
    REQUIRE(square.error() == FieldError::none);
    REQUIRE(shade.error() == FieldError::none);
    Mover mover(opened.field()), one(square.field()), both(shade.field());
    CHECK(!mover.turn(3, 1));
    CHECK(!mover.slide(4, 1));
    int seen = 0;
    for (int k = 0; k < kMoves / 10; ++k) {
        const uint32_t angle = any(random);
        one.turn(0, angle);
        both.turn(0, angle);
        const test::View view = extreme_views(kSide)[0];
        const Bytes opaque = one.look(view, SurfaceMode::one_sample), glass = both.look(view, SurfaceMode::one_sample);
        CHECK(moving_part(moving_parts(shade.field(), both.frame().memory), 1).value == angle);
        const PixelBounds a = moving_part(moving_parts(square.field(), one.frame().memory), 0).shown,
                          b = moving_part(moving_parts(shade.field(), both.frame().memory), 1).shown;
        CHECK((a.left == b.left && a.top == b.top && a.right == b.right && a.bottom == b.bottom));
        seen += glass != opaque && both.frame().see_through_triangles != 0 ? 1 : 0;
    }
    CHECK(seen > kMoves / 40);
}

TEST_CASE("a reader of parts without see-through patches leaves their shadows out")
{
    constexpr SurfaceFeatures kOpaque = SurfaceFeatures::view_tables | SurfaceFeatures::parts;
    TestMover m = shaded_ball(0);
    m.all.shadows = static_cast<uint32_t>(m.all.patches.size()) - m.opaque;
    std::vector<TestSection> sections = mover_sections(m);
    for (TestSection& section : sections)
        if (section.type == format::kSeeThroughSection) section.flags = 0;
    const Opened<kOpaque> shaded(file_of(sections)), plain(mover_file(moving_ball()));
    REQUIRE(shaded.error() == FieldError::none);
    CHECK(mover_count(shaded.field()) == 3);
    CHECK(shaded.field().part_count == 5);
    CHECK(shaded.field().patch_count == plain.field().patch_count);
    Mover without(plain.field()), with(shaded.field());
    std::minstd_rand random(11);
    for (int k = 0; k < kMoves / 20; ++k) {
        for (uint32_t part = 0; part < 3; ++part) {
            const uint32_t value = any_value(plain.field(), part, random);
            without.set(part, value);
            with.set(part, value);
        }
        const test::View view = random_view(random, kSide);
        CHECK(with.look<kOpaque>(view, kSurfaceModes[k % 3]) == without.look<kOpaque>(view, kSurfaceModes[k % 3]));
    }
}

TEST_CASE("a frame in which nothing moves changes nothing, and the first changes all")
{
    const OpenedGlass opened(mover_file(moving_ball()));
    Mover mover(opened.field());
    const test::View view = extreme_views(kSide)[0];
    mover.look(view, SurfaceMode::antialiased);
    const ChangedRects first = changed_rects(mover.frame(), 5, 7);
    REQUIRE(first.count == 1);
    CHECK(first.rect[0].width_px == kSide);
    CHECK(first.rect[0].height_px == kSide);
    mover.look(view, SurfaceMode::antialiased);
    CHECK(changed_rects(mover.frame()).count == 0);
    CHECK(mover.keeps_body());
    mover.turn(0, 1u << 30);
    mover.look(view, SurfaceMode::antialiased);
    CHECK(changed_rects(mover.frame()).count == 1);
    CHECK(area(changed_rects(mover.frame())) < kSide * kSide / 2);
    mover.look(view, SurfaceMode::one_sample);
    CHECK(!mover.keeps_body());
}

TEST_CASE("sixteen parts that all move are told in four rectangles")
{
    std::vector<TestPart> parts;
    for (int k = 0; k < 16; ++k)
        parts.push_back({placed(ball(1, 0), 0.05, {0.4 * (k % 4) - 0.6, 0.4 * (k / 4) - 0.6, 0}), "part", true});
    for (TestPart& part : parts) part.span = 1 << 17;
    const OpenedGlass opened(mover_file(mover(placed(ball(2, 0), 0.2, {0, 0, 0}), parts)));
    REQUIRE(opened.error() == FieldError::none);
    Mover mover(opened.field());
    const test::View view = {"", look_at({0, 0, 3}, {0, 0, 0}), {kSide, kSide, degrees(int32_t{50})}};
    Bytes before = mover.look(view, SurfaceMode::antialiased);
    for (uint32_t moving = 1; moving <= 16; ++moving) {
        for (uint32_t k = 0; k < moving; ++k) REQUIRE(mover.slide(k, static_cast<int32_t>(moving << 12)));
        const Bytes now = mover.look(view, SurfaceMode::antialiased);
        const ChangedRects changed = changed_rects(mover.frame());
        CHECK(changed.count == std::min(moving, uint32_t{4}));
        CHECK(are_same_beside(before, now, view.image, changed));
        before = now;
    }
}

TEST_CASE("halves prepare a body whose parts move as one core does")
{
    std::minstd_rand random(5);
    const OpenedGlass opened(mover_file(moving_ball(9)));
    const SurfaceField& field = opened.field();
    PreparedFrame by_one(field, kSide, 3), by_two(field, kSide, 3);
    std::vector<uint16_t> bands(by_two.bands.size(), 0xA5A5);
    SurfaceHalves halves{};
    halves.bands = bands.data();
    test::View view = random_view(random, kSide);
    uint32_t steps = 0;
    for (int k = 0; k < kMoves; ++k) {
        if (any(random) % 3 == 0) view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[any(random) % 16 == 0 ? 1 : 2];
        for (uint32_t part = 0; part < 3; ++part) {
            const uint32_t value = any_value(field, part, random);
            for (const SurfaceMemory& memory : {by_one.memory, by_two.memory})
                if (!turn_part(field, memory, part, value))
                    slide_part(field, memory, part, static_cast<int32_t>(value));
        }
        SurfaceCamera camera;
        REQUIRE(make_surface_camera(view.pose, view.image, camera) == CameraError::none);
        prepare_surface<PixelRgb565, SurfaceMode::two_by_two, kAll>(field, camera, mode, by_one.memory, by_one.frame);
        prepare_surface<PixelRgb565, SurfaceMode::two_by_two, kAll>(
            field, camera, mode, by_two.memory, by_two.frame, halves, [&](int32_t step) {
                ++steps;
                prepare_half<SurfaceMode::two_by_two, kAll>(halves, step, k % 2 == 0 ? 0 : 1);
                prepare_half<SurfaceMode::two_by_two, kAll>(halves, step, k % 2 == 0 ? 1 : 0);
            });
        REQUIRE(are_same(by_one, by_two));
    }
    CHECK(steps < 3u * kMoves);  // not where the body is kept
}

TEST_CASE("values are clamped to the range of their part, and parts move in their own way")
{
    const OpenedGlass opened(mover_file(moving_ball()));
    Mover mover(opened.field());
    CHECK(mover.turn(0, 0xFFFFFFFF));
    CHECK(mover.value(0) == 0xFFFFFFFF);
    // From -22.5 to 22.5 degrees: what lies beyond goes to the nearer end.
    const auto turned_to = [&](uint32_t turns32) {
        CHECK(mover.turn(1, turns32));
        return mover.value(1);
    };
    CHECK(turned_to(0x10000000) == 0x10000000);
    CHECK(turned_to(0x10000001) == 0x10000000);
    CHECK(turned_to(0x7FFFFFFF) == 0x10000000);
    CHECK(turned_to(0x80000001) == 0xF0000000);
    CHECK(turned_to(0xEFFFFFFF) == 0xF0000000);
    CHECK(turned_to(0xF0000001) == 0xF0000001);
    const auto slid_to = [&](int32_t offset_q20) {
        CHECK(mover.slide(2, offset_q20));
        return static_cast<int32_t>(mover.value(2));
    };
    CHECK(slid_to(-(1 << 16)) == -(1 << 16));
    CHECK(slid_to(INT32_MIN) == -(1 << 16));
    CHECK(slid_to(INT32_MAX) == (1 << 20) - (1 << 16));
    CHECK(slid_to(12345) == 12345);
    CHECK(!mover.slide(0, 0));
    CHECK(!mover.turn(2, 0));
    CHECK(!mover.turn(3, 0));
    CHECK(!mover.slide(UINT32_MAX, 0));
}

TEST_CASE("views move parts, and refuse what is no part of theirs")
{
    static lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 9, 200, 3>,
                      Screen<kSide, kSide, 16, PixelRgb888>>
        view;
    static lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 9, 200, 2>, Screen<kSide, kSide, 16>> few;
    static lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 9>, Screen<kSide, kSide, 16>> none;
    static decltype(view)::Halves halves;
    const Bytes file = mover_file(moving_ball(9));
    CHECK(view.turn(0, 0) == ViewError::no_field);
    CHECK(view.slide(0, 0) == ViewError::no_field);
    CHECK(view.changed().count == 0);
    CHECK(few.open(file.data(), file.size()) == ViewError::field_too_large);
    CHECK(none.open(file.data(), file.size()) == static_cast<ViewError>(FieldError::parts));
    CHECK(std::string(error_text(static_cast<ViewError>(FieldError::parts))).find("SPRT") != std::string::npos);
    REQUIRE(view.open(file.data(), file.size()) == ViewError::none);
    CHECK(view.changed().count == 0);
    CHECK(view.turn(0, degrees(int32_t{70})) == ViewError::none);
    CHECK(view.slide(2, radii(1) / 4) == ViewError::none);
    CHECK(view.turn(2, 0) == ViewError::bad_argument);
    CHECK(view.slide(1, 0) == ViewError::bad_argument);
    CHECK(view.slide(3, 0) == ViewError::bad_argument);
    const test::View eye = extreme_views(kSide)[0];
    const OpenedGlass opened(file);
    Mover mover(opened.field());
    mover.turn(0, degrees(int32_t{70}));
    mover.slide(2, radii(1) / 4);
    const Bytes wanted = mover.look(eye, SurfaceMode::antialiased);
    const auto shown = [&] {
        Bytes pixels(3 * kSide * kSide);
        for (int32_t y = 0; y < kSide; y += 16)
            REQUIRE(view.draw({pixels.data() + 3 * kSide * y, 0, y, kSide, 16, 3 * kSide},
                              OverColour{kSurfaceBackground}) == ViewError::none);
        return pixels;
    };
    REQUIRE(view.look(eye.pose, eye.image.fov_turns32, SurfaceMode::antialiased) == ViewError::none);
    CHECK(shown() == wanted);
    CHECK(view.changed().count == 1);
    REQUIRE(view.open(file.data(), file.size()) == ViewError::none);  // parts rest again
    REQUIRE(view.turn(0, degrees(int32_t{70})) == ViewError::none);
    REQUIRE(view.slide(2, radii(1) / 4) == ViewError::none);
    const auto both = [&](int32_t step) {
        halves.prepare(step, 1);
        halves.prepare(step, 0);
    };
    REQUIRE(view.look(eye.pose, eye.image.fov_turns32, halves, both, SurfaceMode::antialiased) == ViewError::none);
    CHECK(shown() == wanted);
}

// Records that a reader accepts may take parts anywhere. What counts is that no sum overflows and no access leaves the
// memory: this runs under sanitizers.
TEST_CASE("parts may be anywhere, from eyes and in images at the ends of their ranges")
{
    Choices choices(71);
    Extremes extremes(72);
    std::minstd_rand random(73);
    for (uint32_t field = 0; field < kGeneratedFrames / kFramesAField / 6; ++field) {
        std::vector<TestPart> parts;
        const uint32_t count = choices.end_or_any(1, format::kMaxParts);
        for (uint32_t k = 0; k < count; ++k) {
            const Vec3 a = direction(random);
            const double stretched = choices.once_in(2) ? 1 : 1 + 1.9 / 8192 - 1e-6;
            TestPart part = {ball(1, choices.below(9)), "p", choices.once_in(3)};
            part.axis = {a.x * stretched, a.y * stretched, a.z * stretched};
            for (double& c : part.pivot) c = choices.one_of({-2.0, 2.0, 0.0, 0.5});
            part.from = part.slides ? -(2 << 20) : static_cast<int32_t>(any(random));
            part.span = part.slides ? 4 << 20 : choices.one_of({uint32_t{UINT32_MAX}, uint32_t{0}, uint32_t{1} << 31});
            parts.push_back(part);
        }
        const OpenedGlass opened(mover_file(mover(ball(2, 7), parts, choices.once_in(2) ? 5 : 0)));
        REQUIRE(opened.error() == FieldError::none);
        for (uint32_t k = 0; k < kFramesAField; ++k) {
            const Extreme e = extremes.next();
            PreparedFrame made(opened.field(), e.edge.image.height_px, (e.choice >> 4) % 8);
            SurfaceCamera camera;
            REQUIRE(make_surface_camera(e.edge.pose, e.edge.image, camera) == CameraError::none);
            for (uint32_t frame = 0; frame < 2; ++frame) {
                for (uint32_t part = 0; part < count; ++part) {
                    const uint32_t value = any_value(opened.field(), part, random);
                    if (!turn_part(opened.field(), made.memory, part, value))
                        slide_part(opened.field(), made.memory, part, static_cast<int32_t>(value));
                }
                prepare_surface<PixelRgb565, SurfaceMode::two_by_two, kAll>(
                    opened.field(), camera, kSurfaceModes[e.choice % 3], made.memory, made.frame);
                picture(made.frame, e.edge);
                CHECK(changed_rects(made.frame, 1 + e.choice % 9, 8).count <= ChangedRects::kMost);
            }
        }
    }
}

TEST_CASE("records of moving parts with any changed byte are refused or drawn")
{
    const TestMover plain = moving_ball(3);
    std::minstd_rand random(9);
    const test::View view = extreme_views(kSide)[0];
    uint32_t drawn = 0;
    for (size_t at = 0; at < plain.section.size(); ++at) {
        for (const uint8_t change : {uint8_t{1}, uint8_t{0x80}, uint8_t{0xFF}}) {
            TestMover m = plain;
            m.section[at] = static_cast<uint8_t>(m.section[at] ^ change);
            const OpenedGlass opened(mover_file(m));
            if (opened.error() != FieldError::none) continue;
            Mover mover(opened.field());
            for (uint32_t part = 0; part < opened.field().part_count; ++part) mover.set(part, any(random));
            mover.look(view, kSurfaceModes[at % 3]);
            ++drawn;
        }
    }
    CHECK(drawn > 100);  // names, and numbers that are near
}
