// SPDX-License-Identifier: MIT
#include "lumi/surface/states.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "halves.h"
#include "lumi/surface/detail/view_nodes.h"
#include "lumi/surface/parts.h"
#include "lumi/surface/view.h"
#include "states_bytes.h"
#include "surface/fill.h"
#include "surface/owners.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 64;
constexpr auto kWithoutStates = SurfaceFeatures::view_tables | SurfaceFeatures::see_through | SurfaceFeatures::parts;
constexpr uint16_t kFull = kFullWeight;
#ifdef LUMI_TEST_LIGHT
constexpr int kLooks = 12;
#else
constexpr int kLooks = 120;
#endif

// A frame that lasts, of a field of its own, with memory of its very size.
class Lit
{
public:
    explicit Lit(const SurfaceField& field) : field_(field), made_(field, 2 * kSide) {}

    void reset() { reset_states(field_, made_.memory); }
    bool set(uint32_t state, const StateWeight& weight) { return set_state(field_, made_.memory, state, weight); }
    bool turn(uint32_t part, uint32_t turns32) { return turn_part(field_, made_.memory, part, turns32); }

    template <SurfaceFeatures kFeatures = kAll>
    void look(const test::View& view, SurfaceMode mode)
    {
        made_.prepare<PixelRgb888, kFeatures>(field_, view, mode);
    }
    template <SurfaceFeatures kFeatures = kAll>
    Bytes shown(const test::View& view, SurfaceMode mode)
    {
        look<kFeatures>(view, mode);
        return drawn<PixelRgb888, kFeatures>(made_.frame).pixels();
    }

    const SurfaceField& field() const { return field_; }
    const SurfaceFrame& frame() const { return made_.frame; }
    const SurfaceMemory& memory() const { return made_.memory; }
    bool keeps_body() { return moving_parts(field_, made_.memory).keeps_body; }

private:
    SurfaceField field_;
    PreparedFrame made_;
};

uint32_t any(std::minstd_rand& random)
{
    return static_cast<uint32_t>(random()) * 2654435761u ^ static_cast<uint32_t>(random()) << 9;
}

StateWeight any_weight(std::minstd_rand& random)
{
    const uint16_t grey = static_cast<uint16_t>(any(random) % (kFullWeight + 1));
    const auto channel = [&] { return static_cast<uint16_t>(any(random) % (kFullWeight + 1)); };
    const StateWeight weights[] = {
        {0, 0, 0}, {kFull, kFull, kFull}, {grey, grey, grey}, {channel(), channel(), channel()}, {0, channel(), kFull}};
    return weights[any(random) % 5];
}

double light_of_level(double level)
{
    const double v = level / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double level_of_light(double light)
{
    if (light >= 1) return 255;
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

// The formula of surface/format.h in double precision.
struct Reference {
    const TestLight& light;
    const std::vector<StateWeight>& weights;

    double factor(size_t state, size_t c) const
    {
        const StateWeight& w = weights[state];
        return (c == 0   ? w.r_q12
                : c == 1 ? w.g_q12
                         : w.b_q12) /
               double{kFullWeight} * light.states[state].scale_q4 / 16;
    }
    double mixed(const Bytes& entries, size_t entry, size_t c) const
    {
        double sum = 0;
        for (size_t k = 0; k < weights.size(); ++k)
            sum += factor(k, c) * light_of_level(entries[k * format::state::kPaletteBytes + 3 * entry + c]);
        return level_of_light(sum);
    }
    // Returns how far a vertex is from the mixed palette's level; `taps` are those that core reads.
    double difference(const SurfaceField& field, uint32_t vertex, const ViewTaps& taps, size_t c) const
    {
        const uint32_t bits = field.code_bits;
        const uint8_t* const record = field.views + vertex * format::view_bytes(bits);
        const size_t mean = light.means[vertex], set = format::view_colours_bytes(bits);
        double sum = 0;
        for (size_t k = 0; k < weights.size(); ++k) {
            double d = 0;
            for (size_t m = 0; m < 3; ++m) {
                const uint32_t node = taps.node[m];
                uint32_t code = 0;
                for (uint32_t bit = 0; bit < bits; ++bit) {
                    const uint32_t place = node * bits + bit, byte = record[place / 8];
                    code |= (byte >> (place % 8) & 1u) << bit;
                }
                const auto at = k * set + ((size_t{node} << bits) + code) * 3 + c;
                d += taps.weight_q8[m] / 256.0 * static_cast<int8_t>(light.nodes[at]);
            }
            const double gain = light.gains[(vertex * weights.size() + k) * 3 + c] / 64.0;
            const double level = light.palettes[k * format::state::kPaletteBytes + 3 * mean + c] + gain * d;
            sum += factor(k, c) * light_of_level(std::clamp(level, 0.0, 255.0));
        }
        return level_of_light(sum) - field.palette[3 * mean + c];
    }
};

ViewTaps taps_of(const SurfaceField& field, const SurfaceProjection& p, uint32_t vertex)
{
    const uint8_t* const turn =
        field.views + vertex * format::view_bytes(field.code_bits) + format::view_turn_at(field.code_bits);
    const auto number = [&](int k) { return static_cast<int32_t>(static_cast<int8_t>(turn[k])); };
    const VertexQ14 v = surface_vertex(field, vertex);
    const ViewDirection d = in_view_frame({p.viewer.x - (v.x >> p.viewer_shift), p.viewer.y - (v.y >> p.viewer_shift),
                                           p.viewer.z - (v.z >> p.viewer_shift)},
                                          number(0), number(1), number(2));
    return view_taps(d.x, d.y, d.z);
}

double levels(uint32_t colour, size_t c)
{
    const int32_t blue_q2 = static_cast<int32_t>(colour << 20) >> 22;
    return (c == 0 ? red_q2(colour) : c == 1 ? green_q2(colour) : blue_q2) / 4.0;
}

}  // namespace

TEST_CASE("a field whose states nothing weighs shows the same pixels as one without")
{
    std::minstd_rand random(3);
    for (const TestMover& m : {moving_ball(), shaded_ball(9)}) {
        const OpenedGlass plain(mover_file(m)), lit(lit_file(m));
        REQUIRE(lit.error() == FieldError::none);
        const Opened<kWithoutStates> unread(lit.bytes());
        Lit without(plain.field()), with(lit.field()), skipped(unread.field());
        for (int k = 0; k < kLooks / 4; ++k) {
            const test::View view = random_view(random, kSide);
            const Bytes wanted = without.shown(view, kSurfaceModes[k % 3]);
            CHECK((with.shown(view, kSurfaceModes[k % 3]) == wanted));
            CHECK((skipped.shown<kWithoutStates>(view, kSurfaceModes[k % 3]) == wanted));
        }
    }
}

TEST_CASE("palettes are mixed as light, within a level")
{
    std::minstd_rand random(4);
    const TestMover m = moving_ball(9);
    for (const std::vector<TestState>& states : {two_states(), four_states()}) {
        const TestLight light = light_of(m.all, states);
        const OpenedGlass opened(file_with_states(mover_sections(m), light));
        REQUIRE(opened.error() == FieldError::none);
        Lit lit(opened.field());
        lit.reset();
        std::vector<StateWeight> weights(states.size(), {kFull, kFull, kFull});
        double worst = 0;
        for (int k = 0; k < 40; ++k) {
            const Reference reference = {light, weights};
            for (size_t entry = 0; entry < 256; ++entry)
                for (size_t c = 0; c < 3; ++c) {
                    const uint8_t* const glass =
                        lit.field().see_through + format::see_through::kPaletteAt + 6 * entry + c;
                    const double off = lit.field().palette[3 * entry + c] - reference.mixed(light.palettes, entry, c);
                    const double glass_off = *glass - reference.mixed(light.glasses, entry, c);
                    worst = std::max({worst, std::abs(off), std::abs(glass_off)});
                    REQUIRE(glass[3] ==
                            opened.field().see_through[format::see_through::kPaletteAt + 6 * entry + c + 3]);
                }
            const uint32_t state = any(random) % static_cast<uint32_t>(states.size());
            weights[state] = any_weight(random);
            REQUIRE(lit.set(state, weights[state]));
        }
        std::cout << states.size() << " states: a mixed palette is off by " << worst << " levels at most\n";
        CHECK(worst < 0.8);  // 0.5 for the result's rounding; each state's light is rounded down
    }
}

TEST_CASE("one state alone at its full weight shows its palette as it is")
{
    const TestSurface s = ball_with_tables();
    TestLight light = light_of(s, {{"base"}, {"lamp"}});
    for (uint32_t k = 0; k < format::state::kPaletteBytes; ++k)
        light.palettes[format::state::kPaletteBytes + k] = static_cast<uint8_t>(k / 3);
    const OpenedGlass opened(file_with_states(surface_sections(s), light));
    Lit lit(opened.field());
    for (uint32_t state = 0; state < 2; ++state) {
        lit.reset();
        REQUIRE(lit.set(1 - state, {0, 0, 0}));
        const uint8_t* const own = light.palettes.data() + state * format::state::kPaletteBytes;
        CHECK(std::equal(own, own + format::state::kPaletteBytes, lit.field().palette));
    }
    lit.set(1, {0, 0, 0});
    lit.set(0, {0, 0, 0});
    for (uint32_t k = 0; k < format::state::kPaletteBytes; ++k) CHECK(lit.field().palette[k] == 0);
    lit.look(extreme_views(kSide)[0], SurfaceMode::one_sample);
    for (uint32_t v = 0; v < s.viewed; ++v) CHECK(lit.memory().vertices[v].colour <= kUnlit);
    CHECK(!lit.set(2, {1, 1, 1}));
    lit.set(1, {65535, 5000, 4097});  // count as full ones
    CHECK(std::equal(light.palettes.begin() + format::state::kPaletteBytes, light.palettes.end(), lit.field().palette));
    const OpenedGlass without(surface_file(s));
    CHECK(!Lit(without.field()).set(0, {1, 1, 1}));
}

TEST_CASE("vertices are lit as their states' light is mixed, within a level")
{
    std::minstd_rand random(5);
    for (const uint32_t bits : {1u, 4u, 8u}) {
        for (const std::vector<TestState>& states : {two_states(), four_states()}) {
            const TestSurface s = ball_with_tables(bits);
            TestLight light = light_of(s, states);
            for (uint8_t& v : light.nodes) v = static_cast<uint8_t>(static_cast<int8_t>(v) / 3);
            const OpenedGlass opened(file_with_states(surface_sections(s), light));
            REQUIRE(opened.error() == FieldError::none);
            Lit lit(opened.field());
            lit.reset();
            std::vector<StateWeight> weights(states.size(), {kFull, kFull, kFull});
            double worst = 0;
            int seen = 0, bounded = 0;
            for (int k = 0; k < kLooks; ++k) {
                const uint32_t state = any(random) % static_cast<uint32_t>(states.size());
                weights[state] = any_weight(random);
                REQUIRE(lit.set(state, weights[state]));
                lit.look(random_view(random, kSide), SurfaceMode::one_sample);
                for (uint32_t v = 0; v < s.viewed; ++v) {
                    const uint32_t colour = lit.memory().vertices[v].colour;
                    if (colour == kUnlit || lit.frame().columns.begin == lit.frame().columns.end) continue;
                    const ViewTaps taps = taps_of(lit.field(), lit.frame().projection, v);
                    for (size_t c = 0; c < 3; ++c) {
                        const double wanted = Reference{light, weights}.difference(lit.field(), v, taps, c);
                        const double most = 511 / 4.0;  // a vertex's colour has no more
                        worst = std::max(worst, std::abs(levels(colour, c) - std::clamp(wanted, -most, most)));
                        ++seen;
                        bounded += std::abs(wanted) > most ? 1 : 0;
                    }
                }
            }
            std::cout << states.size() << " states, " << bits << " bits: a vertex is off by " << worst
                      << " levels at most\n";
            CHECK(seen > 20 * kLooks);
            CHECK(bounded < seen / 10);
            CHECK(worst < (states.size() == 2 ? 0.9 : 1.5));  // quarters of a level, times a scale of 16 in the dark
        }
    }
}

TEST_CASE("frames of moving parts follow their weights, and only another weight makes the body anew")
{
    std::minstd_rand random(6);
    for (const TestMover& ball : {moving_ball(), shaded_ball(9)}) {
        const OpenedGlass opened(lit_file(ball));
        REQUIRE(opened.error() == FieldError::none);
        Lit lit(opened.field());
        lit.reset();
        test::View view = extreme_views(kSide)[0];
        SurfaceMode mode = SurfaceMode::antialiased;
        StateWeight weights[2] = {{kFull, kFull, kFull}, {kFull, kFull, kFull}};
        uint32_t angle = 0;
        int kept = 0;
        for (int k = 0; k < kLooks; ++k) {
            const uint32_t choice = any(random) % 6;
            const bool looks = k == 0 || choice == 0, weighs = choice >= 4;
            if (looks) view = random_view(random, kSide);
            if (choice == 1) angle = any(random);
            const uint32_t state = choice % 2;
            const StateWeight before = weights[state];
            if (weighs) weights[state] = any_weight(random);
            const StateWeight& now = weights[state];
            const bool changed = now.r_q12 != before.r_q12 || now.g_q12 != before.g_q12 || now.b_q12 != before.b_q12;
            lit.set(state, now);
            lit.turn(0, angle);
            const Bytes shown = lit.shown(view, mode);
            Lit anew(opened.field());
            anew.reset();
            for (uint32_t n = 0; n < 2; ++n) anew.set(n, weights[n]);
            anew.turn(0, angle);
            REQUIRE((shown == anew.shown(view, mode)));
            if (lit.frame().columns.begin == lit.frame().columns.end) continue;
            CHECK(lit.keeps_body() == (!looks && !changed));
            kept += lit.keeps_body() ? 1 : 0;
            const ChangedRects rects = changed_rects(lit.frame());
            if (changed && !looks) {
                REQUIRE(rects.count == 1);
                CHECK(rects.rect[0].width_px == lit.frame().columns.end - lit.frame().columns.begin);
            }
        }
        CHECK(kept > kLooks / 4);
    }
}

TEST_CASE("weighed light is the same in rectangles of any size, and from two cores")
{
    std::minstd_rand random(7);
    Choices choices(8);
    Extremes extremes(9);
    const OpenedGlass ball(lit_ball_file(four_states())), glass(lit_file(shaded_ball(9), four_states()));
    REQUIRE(ball.error() == FieldError::none);
    REQUIRE(glass.error() == FieldError::none);
    for (int k = 0; k < kLooks; ++k) {
        const SurfaceField& field = (k % 2 == 0 ? ball : glass).field();
        const test::View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[k % 3];
        Lit lit(field);
        for (uint32_t n = 0; n < 4; ++n) lit.set(n, any_weight(random));
        const Bytes whole = lit.shown(view, mode);
        const auto width = 1 + static_cast<int32_t>(any(random) % kSide),
                   height = 1 + static_cast<int32_t>(any(random) % 20);
        CHECK((whole == drawn<PixelRgb888>(lit.frame(), OverColour{kSurfaceBackground}, {width, height}).pixels()));
        SurfaceCamera camera;
        REQUIRE(make_surface_camera(view.pose, view.image, camera) == CameraError::none);
        PreparedFrame by_one(lit.field(), kSide, 3), by_two(lit.field(), kSide, 3);
        std::vector<uint16_t> bands(by_two.bands.size());
        SurfaceHalves halves{};
        halves.bands = bands.data();
        SurfaceField one = field, two = field;
        set_state(one, by_one.memory, 1, {77, 4000, 2000});
        set_state(two, by_two.memory, 1, {77, 4000, 2000});
        prepare_surface<PixelRgb565, SurfaceMode::two_by_two, kAll>(one, camera, mode, by_one.memory, by_one.frame);
        prepare_surface<PixelRgb565, SurfaceMode::two_by_two, kAll>(
            two, camera, mode, by_two.memory, by_two.frame, halves, [&](int32_t step) {
                prepare_half<SurfaceMode::two_by_two, kAll>(halves, step, 1);
                prepare_half<SurfaceMode::two_by_two, kAll>(halves, step, 0);
            });
        CHECK(are_same(by_one, by_two));
    }
}

TEST_CASE("a reader of states without see-through patches finds what comes behind theirs")
{
    TestSurface s = ball_with_tables();
    s.shadows = static_cast<uint32_t>(s.patches.size()) - 60;
    std::vector<TestSection> sections = see_through_sections(s, 60, many_glasses());
    sections.back().flags = 0;
    const Bytes file = file_with_states(sections, light_of(s, {{"base"}, {"lamp", 24}, {"lid", 20}}));
    const Opened<SurfaceFeatures::view_tables | SurfaceFeatures::states> shaded(file);
    const OpenedGlass whole(file);
    REQUIRE(shaded.error() == FieldError::none);
    Lit by_opaque(shaded.field()), by_all(whole.field());
    const test::View view = extreme_views(kSide)[0];
    by_opaque.set(1, {900, 500, 0});
    by_all.set(1, {900, 500, 0});
    by_opaque.look<SurfaceFeatures::view_tables | SurfaceFeatures::states>(view, SurfaceMode::one_sample);
    by_all.look(view, SurfaceMode::one_sample);
    for (uint32_t k = 0; k < 60; ++k)
        for (const uint32_t corner : surface_patch(shaded.field(), k).corner)
            if (corner != format::kNoVertex && by_opaque.memory().vertices[corner].colour != kUnlit)
                CHECK(by_opaque.memory().vertices[corner].colour == by_all.memory().vertices[corner].colour);
}

TEST_CASE("a view weighs its states from the next look on, and only those that there are")
{
    constexpr int32_t kRows = 16;
    using TestScreen = Screen<kSide, kSide, kRows, PixelRgb888>;
    static lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 70, 200, 5, 2>, TestScreen> view;
    static lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 70, 200, 5>, TestScreen> plain;
    const Bytes file = lit_file(shaded_ball(9)), many = lit_file(shaded_ball(9), four_states());
    CHECK(view.set_state(1, 100) == ViewError::no_field);
    CHECK(view.open(many.data(), many.size()) == ViewError::field_too_large);
    REQUIRE(view.open(file.data(), file.size()) == ViewError::none);
    REQUIRE(plain.open(many.data(), many.size()) == ViewError::none);
    CHECK(view.set_state(2, 100) == ViewError::bad_argument);
    const Orbit orbit = {degrees(30.0), degrees(20.0), radii(3)};
    const auto picture = [](auto& of) {
        Bytes pixels(3 * kSide * kSide);
        for (int32_t y = 0; y < kSide; y += kRows)
            REQUIRE(of.draw({&pixels[static_cast<uint32_t>(3 * y * kSide)], 0, y, kSide, kRows, 3 * kSide},
                            OverColour{kSurfaceBackground}) == ViewError::none);
        return pixels;
    };
    const OpenedGlass opened(file);
    Lit lit(opened.field());
    lit.reset();
    const test::View eye = {"", pose_of(orbit), {kSide, kSide, view.fov_of(orbit)}};
    const uint32_t weights[] = {kFullWeight, 1000, 0, 100000};
    for (const uint32_t weight : weights) {
        const uint16_t grey = static_cast<uint16_t>(std::min(weight, kFullWeight));
        REQUIRE(view.look(orbit) == ViewError::none);
        const Bytes before = picture(view);
        REQUIRE(view.set_state(1, weight) == ViewError::none);
        REQUIRE(view.set_state(0, StateWeight{grey, 3000, 0}) == ViewError::none);
        CHECK((picture(view) == before));
        lit.set(1, {grey, grey, grey});
        lit.set(0, {grey, 3000, 0});
        REQUIRE(view.look(orbit) == ViewError::none);
        CHECK((picture(view) == lit.shown(eye, SurfaceMode::two_by_two)));
    }
}
