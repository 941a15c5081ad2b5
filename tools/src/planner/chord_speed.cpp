// SPDX-License-Identifier: MIT
#include "planner/chord_speed.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "lumi/chord/render.h"
#include "lumi/chord/render_spans.h"
#include "lumi/orbit.h"
#include "planner/cache_model.h"

namespace lumi::planner
{

namespace
{

using tools::Mode;

// Instructions with M4 code and with M0+ code.
struct Cost {
    double m4, m0plus;

    double of(bool is_m0plus) const { return is_m0plus ? m0plus : m4; }
};

// A fill of the background, a pixel.
constexpr Cost kBackground = {3, 4};
// By spans of 4, 8 and 16 pixels, for texels in the order of their numbers, modes in that of Mode.
constexpr Cost kSpans[][3][detail::format::kTexelFormats] = {
    {
        {{240, 407}, {216, 377}, {247, 420}, {226, 393}},
        {{113, 194}, {90, 167}, {121, 209}, {101, 182}},
        {{100, 172}, {78, 145}, {107, 187}, {89, 160}},
    },
    {
        {{505, 935}, {485, 904}, {513, 944}, {500, 920}},
        {{331, 635}, {314, 603}, {339, 644}, {326, 619}},
        {{297, 574}, {280, 542}, {304, 583}, {292, 558}},
    },
    {
        {{274, 516}, {251, 490}, {280, 526}, {260, 505}},
        {{138, 289}, {116, 263}, {145, 299}, {126, 279}},
        {{121, 260}, {99, 235}, {128, 271}, {109, 250}},
    },
    {
        {{340, 616}, {348, 601}, {349, 628}, {296, 517}},
        {{197, 359}, {205, 345}, {205, 373}, {155, 262}},
        {{184, 331}, {192, 317}, {192, 345}, {142, 234}},
    },
    {
        {{603, 1220}, {647, 1226}, {656, 1306}, {555, 1085}},
        {{429, 915}, {472, 922}, {484, 1008}, {381, 780}},
        {{394, 853}, {437, 860}, {450, 947}, {347, 718}},
    },
};
static_assert(static_cast<size_t>(Mode::paper) + 1 == std::size(kSpans), "a row for each mode");
// Every pixel exact, RGB565.
constexpr Cost kExact[] = {{2615, 8402}, {1914, 7168}, {3854, 10297}};
// Of lattices below kSmallLattice points, all points are looked at, and Linear looks for the hull: what a side takes
// beyond the exact cost above, and for each point. Fitted to fields of 8 × 8, 32 × 32 and 63 × 63 rays.
constexpr uint32_t kSmallLattice = 64;
constexpr Cost kSmallSide[] = {{-717, -1620}, {6447, 36009}, {-1020, -2021}};
constexpr Cost kSmallPoint[] = {{247, 1448}, {304, 1707}, {246, 1447}};

// Exact pixels of the modes of one tap are those of Nearest.
size_t kind_of(Mode mode)
{
    return mode == Mode::paper ? 2 : mode == Mode::linear ? 1 : 0;
}

size_t index_of_span(int32_t span_px)
{
    return span_px == 4 ? 0 : span_px == 8 ? 1 : 2;
}

constexpr int32_t kTilePx = 8;  // spans are drawn in tiles of 8 × 8 pixels, exact pixels in rows

// What a frame reads, in the order of drawing; addresses count from the first texel.
class FrameReads
{
public:
    FrameReads(const Field& field, bool by_spans, const host::ScreenSize& screen)
        : field_(field), by_spans_(by_spans), screen_(screen)
    {
    }

    template <class Reconstruction>
    void draw(const Camera& camera)
    {
        const int32_t width = by_spans_ ? kTilePx : screen_.width_px, height = by_spans_ ? kTilePx : 1;
        for (int32_t top = 0; top < screen_.height_px; top += height)
            for (int32_t left = 0; left < screen_.width_px; left += width)
                for (int32_t y = top; y < std::min(top + height, screen_.height_px); ++y)
                    for (int32_t x = left; x < std::min(left + width, screen_.width_px); ++x)
                        draw_pixel<Reconstruction>(camera, x, y);
    }

    const std::vector<Read>& reads() const { return reads_; }
    uint32_t pixels() const { return pixels_; }

private:
    template <class Reconstruction>
    void draw_pixel(const Camera& camera, int32_t x, int32_t y)
    {
        detail::SphereRay ray;
        if (!detail::ray_at(camera, x, y, ray)) return;
        ++pixels_;
        const detail::SphereHits hit = detail::hits(camera, ray);
        const auto origins = Reconstruction::taps(field_.origins, hit.front);
        const auto directions = Reconstruction::taps(field_.directions, hit.back);
        for (uint32_t m = 0; m < origins.count; ++m)
            if (const uint8_t* row = field_.row(origins.index[m]))
                for (uint32_t k = 0; k < directions.count; ++k) read_texel(row, directions.index[k]);
    }

    void read_texel(const uint8_t* row, uint32_t j)
    {
        const uint32_t bytes = detail::format::bytes_per_texel(field_.texel_format);
        const size_t offset = size_t{bytes} * j;
        reads_.push_back({address_of(row + offset), bytes});
        if (field_.texel_format == TexelFormat::palette8)
            reads_.push_back({address_of(field_.palette + 4 * row[offset]), 4});
    }

    uint32_t address_of(const uint8_t* at) const { return static_cast<uint32_t>(at - field_.texels); }

    const Field& field_;
    const bool by_spans_;
    const host::ScreenSize& screen_;
    std::vector<Read> reads_;
    uint32_t pixels_ = 0;
};

Camera camera_of_generic_view(const host::ScreenSize& screen)
{
    const Orbit orbit = {degrees(37), degrees(23), radii(3)};
    Camera camera;
    if (make_camera(pose_of(orbit), image_of(orbit, screen.width_px, screen.height_px), camera) != CameraError::none)
        throw std::logic_error("the rated view has no camera");
    return camera;
}

FrameReads reads_of(const Field& field, Mode mode, bool by_spans, const host::ScreenSize& screen)
{
    FrameReads frame(field, by_spans, screen);
    const Camera camera = camera_of_generic_view(screen);
    if (mode == Mode::paper)
        frame.draw<Paper<>>(camera);
    else if (mode == Mode::linear)
        frame.draw<Linear>(camera);
    else
        frame.draw<Nearest>(camera);
    return frame;
}

}  // namespace

bool is_drawn_by_spans(const Field& field)
{
    return fits_spans(field);
}

double chord_instructions(const std::string& core, Mode mode, const Field& field, int32_t span_px)
{
    const bool m0plus = core == "m0plus";
    const auto texel = static_cast<size_t>(field.texel_format);
    if (span_px != 0 && is_drawn_by_spans(field))
        return kSpans[static_cast<size_t>(mode)][index_of_span(span_px)][texel].of(m0plus);
    const size_t kind = kind_of(mode);
    double sum = kExact[kind].of(m0plus);
    for (const detail::Lattice* side : {&field.origins, &field.directions})
        if (side->size() < kSmallLattice)
            sum += kSmallSide[kind].of(m0plus) + side->size() * kSmallPoint[kind].of(m0plus);
    return sum;
}

std::vector<PartRate> chord_rates(const Field& field, Mode mode, int32_t span_px, const host::ScreenSize& screen)
{
    const FrameReads frame = reads_of(field, mode, span_px != 0 && is_drawn_by_spans(field), screen);
    const double pixels = 1.0 * screen.width_px * screen.height_px;
    const AllTraffic traffic = traffic_of(frame.reads());
    std::vector<PartRate> rates;
    for (size_t k = 0; k < kChips; ++k) {
        const Chip& chip = kChipList[k];
        const double background = pixels * kBackground.of(chip.core == std::string("m0plus"));
        const double instructions = frame.pixels() * chord_instructions(chip.core, mode, field, span_px) + background;
        const double rate = frames_per_second(chip, static_cast<uint64_t>(instructions), traffic[k].misses, pixels);
        rates.push_back({&chip, rate, rate, instructions});
    }
    return rates;
}

}  // namespace lumi::planner
