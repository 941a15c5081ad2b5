// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "extreme_chords.h"
#include "extreme_frames.h"
#include "lumi/chord/render_spans.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr uint32_t kDrawnExactly = 64;  // `render` takes a hundred times as long

template <class Texel>
void draw_chord(const Field& field, const Camera& camera, const Stripe& stripe, uint32_t choice)
{
    const auto exactly = [&](auto reconstruction) {
        return render<decltype(reconstruction), Texel, PixelRgb565>(field, camera, OverBlack{}, stripe);
    };
    const auto by_spans = [&](auto reconstruction) {
        return render_spans<decltype(reconstruction), Texel, PixelRgb565>(field, camera, OverBlack{}, stripe,
                                                                          2 << (choice >> 6) % 4);
    };
    const uint32_t kind = (choice >> 8) % 4;
    RenderError error = RenderError::none;
    if (choice % kDrawnExactly == 0 || !fits_spans(field))
        error = kind == 0 ? exactly(Nearest()) : kind == 1 ? exactly(Paper<9>()) : exactly(Linear());
    else
        error = kind == 0 ? by_spans(Nearest()) : by_spans(Linear());
    REQUIRE(error == RenderError::none);
}

// From the smallest lattices that spans take to the largest, some with a cap.
std::vector<Bytes> chord_fields()
{
    const TestLayout layouts[] = {layout_of(64, 64, TexelFormat::rgb565),
                                  layout_of(400, 700, TexelFormat::palette8, 210),
                                  layout_of(1000, 64, TexelFormat::rgb888, 1),
#ifndef LUMI_TEST_LIGHT
                                  layout_of(64, kMaxSpanLattice, TexelFormat::luma8),
                                  layout_of(kMaxSpanLattice, 64, TexelFormat::palette8, kMaxSpanLattice / 2),
#endif
                                  layout_of(233, 144, TexelFormat::luma8)};
    std::vector<Bytes> fields;
    for (const TestLayout& layout : layouts) fields.push_back(sample_field(layout));
    return fields;
}

uint64_t draw_chord(const Field& field, const Extreme& e, bool twice)
{
    Camera camera;
    REQUIRE(make_camera(e.edge.pose, e.edge.image, camera) == CameraError::none);
    return draw_frame(e.edge, PixelRgb565::kBytes, twice, [&](const Stripe& stripe, uint8_t) {
        with_texel(field.texel_format,
                   [&](auto texel) { draw_chord<decltype(texel)>(field, camera, stripe, e.choice); });
    });
}

}  // namespace

TEST_CASE("chord fields whose every number is at its end open, verify and hold in random frames at every extreme")
{
    Choices choices(15);
    Extremes extremes(16);
    uint64_t shown = 0;
    for (uint32_t k = 0; k < kGeneratedFrames; k += kFramesAField) {
        const Bytes file = ExtremeChords(choices, kLargestChord).next();
        INFO("field " << k / kFramesAField);
        Field field;
        REQUIRE(open_field(file.data(), file.size(), field) == FieldError::none);
        REQUIRE(verify_field(file.data(), file.size()) == FieldError::none);
        for (uint32_t frame = 0; frame < kFramesAField; ++frame)
            shown += draw_chord(field, extremes.next(), frame == 0);
    }
    check_shown("generated chord fields", kGeneratedFrames, shown, 20);
}

TEST_CASE("chord fields hold in random frames at every extreme")
{
    const std::vector<Bytes> files = chord_fields();
    std::vector<Field> fields(files.size());
    for (size_t k = 0; k < files.size(); ++k)
        REQUIRE(open_field(files[k].data(), files[k].size(), fields[k]) == FieldError::none);
    Extremes extremes(11);
    uint64_t shown = 0;
    for (uint32_t k = 0; k < kFrames; ++k) {
        const Extreme e = extremes.next();
        const Field& field = fields[extremes.below(static_cast<uint32_t>(fields.size()))];
        shown += draw_chord(field, e, k % kDrawnTwice == 0);
    }
    check_shown("chord fields", kFrames, shown, 50);
}
