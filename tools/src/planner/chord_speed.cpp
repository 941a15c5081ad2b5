// SPDX-License-Identifier: MIT
#include "planner/chord_speed.h"

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
// By kind_of() the mode. By spans, for texels in the order of their numbers.
constexpr Cost kSpans[][detail::format::kTexelFormats] = {
    {{113, 194}, {90, 167}, {121, 209}, {101, 182}},
    {{197, 359}, {205, 345}, {205, 373}, {155, 262}},
    {{429, 915}, {472, 922}, {484, 1008}, {381, 780}},
};
// Every pixel exact, RGB565.
constexpr Cost kExact[] = {{2615, 8402}, {1914, 7168}, {3854, 10297}};
// Of lattices below kSmallLattice points, all points are looked at, and Linear looks for the hull: what a side takes
// beyond the exact cost above, and for each point. Fitted to fields of 8 × 8, 32 × 32 and 63 × 63 rays.
constexpr uint32_t kSmallLattice = 64;
constexpr Cost kSmallSide[] = {{-717, -1620}, {6447, 36009}, {-1020, -2021}};
constexpr Cost kSmallPoint[] = {{247, 1448}, {304, 1707}, {246, 1447}};

size_t kind_of(Mode mode)
{
    return mode == Mode::nearest ? 0 : mode == Mode::linear ? 1 : 2;
}

constexpr int32_t kSidePx = 240;
constexpr int32_t kTilePx = 8;  // spans are drawn in tiles of 8 × 8 pixels, exact pixels in rows

// What a frame reads, in the order of drawing; addresses count from the first texel.
class FrameReads
{
public:
    explicit FrameReads(const Field& field) : field_(field) {}

    template <class Reconstruction>
    void draw(const Camera& camera)
    {
        const bool spans = is_drawn_by_spans(field_);
        const int32_t width = spans ? kTilePx : kSidePx, height = spans ? kTilePx : 1;
        for (int32_t top = 0; top < kSidePx; top += height)
            for (int32_t left = 0; left < kSidePx; left += width)
                for (int32_t y = top; y < top + height; ++y)
                    for (int32_t x = left; x < left + width; ++x) draw_pixel<Reconstruction>(camera, x, y);
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
    std::vector<Read> reads_;
    uint32_t pixels_ = 0;
};

Camera camera_of_generic_view()
{
    const Orbit orbit = {degrees(37), degrees(23), radii(3)};
    Camera camera;
    if (make_camera(pose_of(orbit), image_of(orbit, kSidePx, kSidePx), camera) != CameraError::none)
        throw std::logic_error("the rated view has no camera");
    return camera;
}

FrameReads reads_of(const Field& field, Mode mode)
{
    FrameReads frame(field);
    const Camera camera = camera_of_generic_view();
    if (mode == Mode::nearest)
        frame.draw<Nearest>(camera);
    else if (mode == Mode::linear)
        frame.draw<Linear>(camera);
    else
        frame.draw<Paper<>>(camera);
    return frame;
}

}  // namespace

bool is_drawn_by_spans(const Field& field)
{
    return fits_spans(field);
}

double chord_instructions(const std::string& core, Mode mode, const Field& field)
{
    const bool m0plus = core == "m0plus";
    const size_t kind = kind_of(mode);
    if (is_drawn_by_spans(field)) return kSpans[kind][static_cast<size_t>(field.texel_format)].of(m0plus);
    double sum = kExact[kind].of(m0plus);
    for (const detail::Lattice* side : {&field.origins, &field.directions})
        if (side->size() < kSmallLattice)
            sum += kSmallSide[kind].of(m0plus) + side->size() * kSmallPoint[kind].of(m0plus);
    return sum;
}

std::vector<PartRate> chord_rates(const Field& field, Mode mode)
{
    const FrameReads frame = reads_of(field, mode);
    const AllTraffic traffic = traffic_of(frame.reads());
    std::vector<PartRate> rates;
    for (size_t k = 0; k < kChips; ++k) {
        const Chip& chip = kChipList[k];
        const double background = kSidePx * kSidePx * kBackground.of(chip.core == std::string("m0plus"));
        const double instructions = frame.pixels() * chord_instructions(chip.core, mode, field) + background;
        const double rate = frames_per_second(chip, static_cast<uint64_t>(instructions), traffic[k].misses);
        rates.push_back({&chip, rate, rate});
    }
    return rates;
}

}  // namespace lumi::planner
