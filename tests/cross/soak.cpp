// SPDX-License-Identifier: MIT
// Draws random orbits, image sizes, stripes, pixel formats and modes of four fields that the emulator has loaded, a
// MiB apart: a surface field, a chord field of RGB565 texels, a surface field with see-through parts, and one with
// moving parts: `SEED FRAMES`. Every buffer is as large as the headers ask and lies between guard zones. A frame drawn
// in random stripes must be the frame drawn whole, a frame prepared in halves the frame that one core prepared, and a
// frame to which parts have come back the frame that they left. Writes a line of counts; the first fault ends it
// with 1.
#include <cstring>

#include "lumi/chord/render_spans.h"
#include "lumi/mps2/board.h"
#include "lumi/mps2/meters.h"
#include "lumi/orbit.h"
#include "lumi/surface/halves.h"
#include "lumi/surface/parts.h"
#include "lumi/surface/render.h"
#include "lumi/surface/states.h"
#include "text_line.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;

constexpr int32_t kMostSide = 48;
constexpr uint32_t kChordOffset = 1024 * 1024, kSeeThroughOffset = 2 * kChordOffset, kMovingOffset = 3 * kChordOffset;
constexpr uint32_t kMostVertices = 2048, kMostPatches = 2048;  // limits of the surface fields

// xorshift of 32 bits (Marsaglia, 2003).
uint32_t state;
uint32_t random_word()
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}
int32_t random_of(int32_t count)
{
    return static_cast<int32_t>(random_word() % static_cast<uint32_t>(count));
}

uint32_t number(const char* digits)
{
    uint32_t value = 0;
    while (*digits >= '0' && *digits <= '9') value = 10 * value + static_cast<uint32_t>(*digits++ - '0');
    return value;
}

void write_number(const char* before, uint64_t value)
{
    mps2::write(firmware::TextLine().text(before).decimal(value).c_str());
}

uint32_t frame_number, refused, stripes;

[[noreturn]] void fail(const char* what)
{
    write_number("FAILED: frame ", frame_number);
    mps2::write(firmware::TextLine().text(": ").text(what).text("\n").c_str());
    mps2::exit_with(1);
}

// Memory for up to kMost bytes between guard zones.
template <uint32_t kMost>
class Guarded
{
public:
    // The bytes that it held are lost.
    uint8_t* of(uint32_t bytes)
    {
        if (bytes > kMost) fail("the test's own memory is too small");
        bytes_ = bytes;
        std::memset(memory_, kPaint, kZone);
        std::memset(memory_ + kZone + bytes, kPaint, kZone);
        return memory_ + kZone;
    }
    void check(const char* what) const
    {
        for (uint32_t k = 0; k < kZone; ++k)
            if (memory_[k] != kPaint || memory_[kZone + bytes_ + k] != kPaint) fail(what);
    }

private:
    static constexpr uint32_t kZone = 256;
    static constexpr uint8_t kPaint = 0xC5;
    alignas(8) uint8_t memory_[kMost + 2 * kZone];
    uint32_t bytes_ = 0;
};

constexpr uint32_t kMostPixels = kMostSide * kMostSide * PixelArgb8888::kBytes;
Guarded<kMostPixels> whole_pixels, cut_pixels;
Guarded<surface_stripe_bytes(kMostSide, kMostSide, SurfaceMode::two_by_two)> sample_memory;
Guarded<kMostVertices * sizeof(SurfaceVertex)> vertex_memory;
Guarded<2 * surface_links(kMostPatches)> link_memory;
Guarded<2 * surface_bands(kMostSide, 0)> band_memory, second_band_memory;
Guarded<4 * (see_through_words(kMostPatches) + part_words(format::kMaxParts) +
             state_words(format::kMaxStates, kMostPatches))>
    see_through_memory;

SurfaceFrame frame;
SurfaceHalves halves;

SurfaceMemory memory_of(const SurfaceField& field, int32_t height_px, uint32_t band_log2)
{
    return {reinterpret_cast<SurfaceVertex*>(vertex_memory.of(field.vertex_count * uint32_t{sizeof(SurfaceVertex)})),
            reinterpret_cast<uint16_t*>(link_memory.of(2 * surface_links(field.patch_count))),
            reinterpret_cast<uint16_t*>(band_memory.of(2 * surface_bands(height_px, band_log2))), band_log2,
            reinterpret_cast<uint32_t*>(see_through_memory.of(4 * feature_words(field)))};
}

struct Size {
    int32_t width, height;
};

Size random_size()
{
    const auto side = [] { return random_of(8) == 0 ? 1 : 1 + random_of(kMostSide); };
    return {side(), side()};
}

Orbit random_orbit()
{
    Orbit o;
    o.azimuth_turns32 = random_word();
    o.elevation_turns32 = random_word() / 2 - (1u << 30);
    const int32_t beyond = static_cast<int32_t>((random_word() >> 1) >> random_of(24));
    o.distance_q20 = beyond < radii(2000) ? radii(1) + radii(1) / 64 + beyond : radii(2000);
    if (random_of(2) == 0) o.fov_turns32 = degrees(1 + random_of(120));
    return o;
}

// Calls draw(x, y, width, height) for rectangles that make up the image.
template <class Draw>
void cut(const Size& size, bool whole_rows, const Draw& draw)
{
    for (int32_t y = 0; y < size.height;) {
        const int32_t rows = 1 + random_of(size.height - y);
        for (int32_t x = 0; x < size.width;) {
            const int32_t columns = whole_rows ? size.width : 1 + random_of(size.width - x);
            draw(x, y, columns, rows);
            ++stripes;
            x += columns;
        }
        y += rows;
    }
}

// Draws the frame whole, calls `between`, draws it in stripes, and compares. draw_stripe(stripe) fills one.
template <class Pixel, class Between, class Draw>
void draw_twice(const Size& size, bool whole_rows, const Between& between, const Draw& draw_stripe)
{
    const uint32_t stride = static_cast<uint32_t>(size.width) * Pixel::kBytes;
    const uint32_t bytes = stride * static_cast<uint32_t>(size.height);
    uint8_t *const whole = whole_pixels.of(bytes), *const parts = cut_pixels.of(bytes);
    std::memset(whole, 0x5A, bytes);
    std::memset(parts, 0x5A, bytes);
    draw_stripe(Stripe{whole, 0, 0, size.width, size.height, stride});
    between();
    cut(size, whole_rows, [&](int32_t x, int32_t y, int32_t columns, int32_t rows) {
        uint8_t* const at = parts + static_cast<uint32_t>(y) * stride + static_cast<uint32_t>(x) * Pixel::kBytes;
        draw_stripe(Stripe{at, x, y, columns, rows, stride});
    });
    whole_pixels.check("a frame drawn whole wrote beside its pixels");
    cut_pixels.check("a frame drawn in stripes wrote beside its pixels");
    if (std::memcmp(whole, parts, bytes) != 0) fail("stripes show other bits than the whole frame");
}

struct Look {
    Size size;
    SurfaceMode mode;
    SurfaceCamera camera;
    SurfaceMemory memory;
};

template <class Pixel, SurfaceFeatures kFeatures>
void prepare(const SurfaceField& field, const Look& look)
{
    prepare_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(field, look.camera, look.mode, look.memory, frame);
}

// begin(look) prepares the frame that is drawn whole, again(look) the same for its stripes, in another way.
template <class Pixel, SurfaceFeatures kFeatures, class Background, class Begin, class Again>
void draw_surface_twice(const SurfaceField& field, const Background& background, const Begin& begin, const Again& again)
{
    Look look;
    look.size = random_size();
    const Orbit orbit = random_orbit();
    look.mode = static_cast<SurfaceMode>(random_of(3));
    const uint32_t band_log2 = static_cast<uint32_t>(random_of(6));
    if (make_surface_camera(pose_of(orbit), image_of(orbit, look.size.width, look.size.height), look.camera) !=
        CameraError::none) {
        ++refused;
        return;
    }
    look.memory = memory_of(field, look.size.height, band_log2);
    begin(look);
    draw_twice<Pixel>(
        look.size, false, [&] { again(look); },
        [&](const Stripe& stripe) {
            const uint32_t bytes = surface_stripe_bytes(stripe.width_px, stripe.height_px, look.mode);
            render_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(frame, background, stripe,
                                                                      sample_memory.of(bytes));
            sample_memory.check("written beside the samples");
        });
    vertex_memory.check("written beside the vertices");
    link_memory.check("written beside the links");
    band_memory.check("written beside the bands");
    see_through_memory.check("written beside the see-through triangles and parts");
}

// One core prepares the frame; every other time both prepare it again.
template <class Pixel, SurfaceFeatures kFeatures = SurfaceFeatures::view_tables, class Background>
void draw_surface(const SurfaceField& field, const Background& background)
{
    const auto prepare_in_halves = [&](const Look& look) {
        if (random_of(2) == 0) return;
        const uint32_t bands = surface_bands(look.size.height, look.memory.band_log2);
        halves.bands = reinterpret_cast<uint16_t*>(second_band_memory.of(2 * bands));
        prepare_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(
            field, look.camera, look.mode, look.memory, frame, halves,
            [](int32_t step) {
                const uint32_t first = static_cast<uint32_t>(random_of(2));
                prepare_half(halves, step, first);
                prepare_half(halves, step, 1 - first);
            });
        second_band_memory.check("written beside the second half's bands");
    };
    draw_surface_twice<Pixel, kFeatures>(
        field, background, [&](const Look& look) { prepare<Pixel, kFeatures>(field, look); }, prepare_in_halves);
}

void move_all(const SurfaceField& field, const SurfaceMemory& memory)
{
    for (uint32_t part = 0; part < field.part_count; ++part) {
        if (random_of(3) == 0) continue;
        if (!turn_part(field, memory, part, random_word()))
            slide_part(field, memory, part, static_cast<int32_t>(random_word()) >> random_of(20));
    }
}

StateWeight random_weight()
{
    const auto channel = [] { return static_cast<uint16_t>(random_of(3) == 0 ? 0 : random_of(2 * kFullWeight)); };
    return {channel(), channel(), channel()};
}

// Parts move, and lights are weighed; then parts leave their poses some times and come back.
template <class Pixel, class Background>
void draw_moving(SurfaceField field, const Background& background)
{
    constexpr SurfaceFeatures kAll = SurfaceFeatures::all;
    const auto begin = [&](const Look& look) {
        rest_parts(field, look.memory);
        for (uint32_t k = 0; k < field.state_count; ++k) set_state(field, look.memory, k, random_weight());
        frame.width_px = 0;  // of no field
        move_all(field, look.memory);
        prepare<Pixel, kAll>(field, look);
    };
    const auto leave_and_come_back = [&](const Look& look) {
        uint32_t values[format::kMaxParts];
        SurfaceParts& parts = moving_parts(field, look.memory);
        for (uint32_t k = 0; k < field.part_count; ++k) values[k] = moving_part(parts, k).value;
        for (int32_t times = random_of(3); times > 0; --times) {
            move_all(field, look.memory);
            prepare<Pixel, kAll>(field, look);
        }
        for (uint32_t k = 0; k < field.part_count; ++k) moving_part(parts, k).value = values[k];
        prepare<Pixel, kAll>(field, look);
    };
    draw_surface_twice<Pixel, kAll>(field, background, begin, leave_and_come_back);
}

template <class Reconstruction, class Pixel, class Background>
void draw_chord(const Field& field, const Background& background)
{
    const Size size = random_size();
    const Orbit orbit = random_orbit();
    Camera camera;
    if (make_camera(pose_of(orbit), image_of(orbit, size.width, size.height), camera) != CameraError::none) {
        ++refused;
        return;
    }
    const int32_t span = 2 << random_of(4);
    draw_twice<Pixel>(
        size, true, [] {},
        [&](const Stripe& stripe) {
            if (render_spans<Reconstruction, TexelRgb565, Pixel>(field, camera, background, stripe, span) !=
                RenderError::none)
                fail("a field was refused that had been drawn");
        });
}

struct Fields {
    SurfaceField surface;
    Field chord;
    SurfaceField see_through, moving;
};

void draw_frame(const Fields& fields)
{
    const uint32_t word = random_word();
    const OverColour colour{
        {static_cast<uint8_t>(word), static_cast<uint8_t>(word >> 8), static_cast<uint8_t>(word >> 16)}};
    switch (random_of(15)) {
        case 0:
            return draw_surface<PixelRgb565>(fields.surface, OverBlack{});
        case 1:
            return draw_surface<PixelRgb888>(fields.surface, colour);
        case 2:
            return draw_surface<PixelArgb8888>(fields.surface, OverNothing{});
        case 3:
            return draw_surface<PixelGrey8>(fields.surface, colour);
        case 4:
            return draw_surface<PixelBgr555>(fields.surface, OverStripe{});
        case 5:
            return draw_surface<PixelRgb565Swapped>(fields.surface, OverStripe{});
        case 6:
            return draw_chord<Nearest, PixelRgb565>(fields.chord, OverBlack{});
        case 7:
            return draw_chord<Linear, PixelRgb565>(fields.chord, colour);
        case 8:
            return draw_chord<Linear, PixelRgb888>(fields.chord, colour);
        case 9:
            return draw_chord<Nearest, PixelGrey8>(fields.chord, OverStripe{});
        case 10:
            return draw_surface<PixelRgb565, SurfaceFeatures::all>(fields.see_through, colour);
        case 11:
            return draw_surface<PixelArgb8888, SurfaceFeatures::all>(fields.see_through, OverNothing{});
        case 12:
            return draw_moving<PixelRgb565>(fields.moving, colour);
        case 13:
            return draw_moving<PixelArgb8888>(fields.moving, OverNothing{});
        default:
            return draw_surface<PixelRgb565Swapped, SurfaceFeatures::all>(fields.see_through, OverStripe{});
    }
}

__attribute__((noinline)) void draw_frames(const Fields& fields, uint32_t count)
{
    for (frame_number = 0; frame_number < count; ++frame_number) draw_frame(fields);
}

void open_fields(Fields& fields)
{
    const mps2::LoadedField surface = mps2::loaded_field(0), chord = mps2::loaded_field(kChordOffset),
                            see_through = mps2::loaded_field(kSeeThroughOffset),
                            moving = mps2::loaded_field(kMovingOffset);
    if (open_surface(surface.bytes, surface.size, fields.surface) != FieldError::none)
        fail("no surface field is loaded");
    if (open_field(chord.bytes, chord.size, fields.chord) != FieldError::none) fail("no chord field is loaded");
    if (open_surface<SurfaceFeatures::all>(see_through.bytes, see_through.size, fields.see_through) !=
            FieldError::none ||
        fields.see_through.see_through_count == 0)
        fail("no field with see-through parts is loaded");
    if (open_surface<SurfaceFeatures::all>(moving.bytes, moving.size, fields.moving) != FieldError::none ||
        fields.moving.part_count == 0)
        fail("no field with moving parts is loaded");
}

}  // namespace

int main(int count, char** arguments)
{
    if (count != 3) fail("say SEED FRAMES");
    state = 2654435761u * number(arguments[1]) + 1;
    Fields fields;
    open_fields(fields);
    mps2::StackMeter meter;
    meter.paint();
    draw_frames(fields, number(arguments[2]));
    const uint32_t stack = meter.high_water_bytes();
    write_number("frames ", frame_number);
    write_number(" refused ", refused);
    write_number(" stripes ", stripes);
    write_number(" stack ", stack);
    mps2::write("\n");
    return 0;
}
