// SPDX-License-Identifier: MIT
// The module that a page of `lumi view` runs: it holds a field, an eye that fingers and keys move, and draws frames as
// a firmware does, which it then turns into what a canvas takes.
//
//     field_memory(bytes)         where the script puts the field
//     open_field()                0, or a ViewError
//     set_home(...)               the first eye
//     set_screen(width, height)   where frames lie, 4 bytes a pixel: red, green, blue, 255
//     advance(...)                each tick; tells whether the eye moves
//     draw_frame(mode, format, background)   over a colour, or kGradient
//
// Whatever grows memory (field_memory, set_screen) makes the script's views of it void.
#include "drawing.h"
#include "lumi/gesture.h"
#include "lumi/host/backdrop.h"
#include "lumi/orbit.h"

#define LUMI_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace
{

using namespace lumi;
using namespace lumi::wasm;

constexpr int32_t kRgbaBytes = 4;
constexpr uint32_t kGradient = 1u << 24;  // in place of a colour
// Fingers' places come in 1/1024 of the display's shorter side, whatever its pixels: half a turn across it.
constexpr uint32_t kTurnPerStep = degrees(180) / 1024;
constexpr int32_t kNearestEye = radii(5) / 4, kFarthestEye = radii(8);

struct Memory {
    uint8_t* field = nullptr;
    size_t field_bytes = 0;
    uint8_t* frame = nullptr;   // all from here on is of the screen
    uint8_t* stripe = nullptr;  // and a second one behind it
    uint8_t* rgba = nullptr;
};

struct Eye {
    Orbit orbit;
    int32_t distance_aim_q20;
    OrbitDrag drag;
};

constexpr Orbit kFirstHome = {degrees(30), degrees(20), radii(3)};

constexpr Eye eye_at(const Orbit& orbit)
{
    return {orbit, orbit.distance_q20, OrbitDrag({kTurnPerStep})};
}

LUMI_CONSTANT Memory memory;
LUMI_CONSTANT Orbit home = kFirstHome;
LUMI_CONSTANT Eye eye = eye_at(kFirstHome);
Image image = {};

int32_t limited(int64_t distance_q20)
{
    return static_cast<int32_t>(distance_q20 < kNearestEye    ? kNearestEye
                                : distance_q20 > kFarthestEye ? kFarthestEye
                                                              : distance_q20);
}

// Goes 1/16 of the way that is left each millisecond; whether the eye moves.
bool approach(uint32_t elapsed_ms)
{
    const int32_t way = eye.distance_aim_q20 - eye.orbit.distance_q20;
    constexpr int32_t kClose = kOneQ20 / 1000;
    if (way > -kClose && way < kClose) {
        eye.orbit.distance_q20 = eye.distance_aim_q20;
        return way != 0;
    }
    constexpr int32_t kShare = 16, kMostSteps = kShare / 2;  // a late tick never jumps farther than half of the way
    const int32_t steps = elapsed_ms < 1 ? 1 : elapsed_ms < kMostSteps ? static_cast<int32_t>(elapsed_ms) : kMostSteps;
    eye.orbit.distance_q20 += way / kShare * steps;
    return true;
}

template <class Pixel>
uint8_t alpha_of(const uint8_t* pixel)
{
    if constexpr (detail::kHoldsCoverage<Pixel>) return pixel[3];
    return 255;
}

// Shows a stripe as a display does; over the gradient, a stripe over each of its two greys.
template <class Pixel>
void copy_to_canvas(const Stripe& stripe, const Stripe& over_middle)
{
    uint8_t* to = memory.rgba + stripe.y_px * stripe.width_px * kRgbaBytes;
    const uint8_t *from = stripe.pixels, *middle = over_middle.pixels;
    for (int32_t y = stripe.y_px; y < stripe.y_px + stripe.height_px; ++y)
        for (int32_t x = 0; x < stripe.width_px; ++x, to += kRgbaBytes) {
            Rgb8 colour = Pixel::load(from);
            if (middle != nullptr) {
                const int32_t share = host::backdrop_share(x, y, image.width_px, image.height_px);
                colour = host::over_backdrop<Pixel>(colour, Pixel::load(middle), share, x, y);
                middle += Pixel::kBytes;
            }
            to[3] = alpha_of<Pixel>(from);
            from += Pixel::kBytes;
            to[0] = colour.r;
            to[1] = colour.g;
            to[2] = colour.b;
        }
}

// A stripe takes this in any format; a multiple of kAlignment.
size_t stripe_bytes(int32_t width_px)
{
    return static_cast<size_t>(width_px) * kStripeRows * PixelArgb8888::kBytes;
}

uint32_t pixel_bytes(DisplayFormat format)
{
    return with_pixel(
        format, [](auto pixel) { return decltype(pixel)::kBytes; });
}

ViewError draw_stripes(Style style, bool over_gradient)
{
    const uint32_t stride = static_cast<uint32_t>(image.width_px) * pixel_bytes(style.format);
    for (int32_t y = 0; y < image.height_px; y += kStripeRows) {
        const int32_t left = image.height_px - y, rows = left < kStripeRows ? left : kStripeRows;
        const Stripe stripe = {memory.stripe, 0, y, image.width_px, rows, stride};
        Stripe over_middle = {nullptr, 0, y, image.width_px, rows, stride};
        if (over_gradient) {
            over_middle.pixels = memory.stripe + stripe_bytes(image.width_px);
            style.background.colour = host::kBackdropMiddle;
            if (const ViewError error = draw(style, over_middle); error != ViewError::none) return error;
            style.background.colour = host::kBackdropCorner;
        }
        if (const ViewError error = draw(style, stripe); error != ViewError::none) return error;
        with_pixel(style.format, [&](auto pixel) { copy_to_canvas<decltype(pixel)>(stripe, over_middle); });
    }
    return ViewError::none;
}

bool is_style(uint32_t mode, uint32_t format)
{
    return mode < drawing_modes() && format < kDisplayFormats;
}

}  // namespace

LUMI_EXPORT(field_memory) uint8_t* field_memory(uint32_t bytes)
{
    release_from(nullptr);
    memory = {reserve(bytes), bytes};
    return memory.field;
}

LUMI_EXPORT(open_field) uint32_t open_field()
{
    if (memory.field == nullptr) return static_cast<uint32_t>(ViewError::bad_argument);
    return static_cast<uint32_t>(open_drawing(memory.field, memory.field_bytes));
}

LUMI_EXPORT(describe) const char* describe(uint32_t error)
{
    return error_text(static_cast<ViewError>(error));
}

// Null where the sides are out of range, or the browser has no memory for them. The field of view is that in which the
// sphere fills the image from home, whatever the distance: nearer shows it larger.
LUMI_EXPORT(set_screen) uint8_t* set_screen(int32_t width_px, int32_t height_px)
{
    image = {};
    if (width_px < 1 || width_px > kMaxImageSide || height_px < 1 || height_px > kMaxImageSide) return nullptr;
    if (memory.frame != nullptr) release_from(memory.frame);
    const size_t width = static_cast<size_t>(width_px), height = static_cast<size_t>(height_px);
    memory.frame = reserve(drawing_bytes(width_px, height_px));
    memory.stripe = reserve(2 * stripe_bytes(width_px));
    memory.rgba = reserve(width * height * kRgbaBytes);
    if (memory.frame == nullptr || memory.stripe == nullptr || memory.rgba == nullptr) return nullptr;
    image = image_of(home, width_px, height_px);
    return memory.rgba;
}

// Back to the first eye; what ran on stops.
LUMI_EXPORT(go_home) void go_home()
{
    eye = eye_at(home);
}

// The eye that a page opens with, and comes back to: 1.25 to 8 radii away. A screen that is set later has its field of
// view.
LUMI_EXPORT(set_home) void set_home(uint32_t azimuth_turns32, uint32_t elevation_turns32, int32_t distance_q20)
{
    home = {azimuth_turns32, elevation_turns32, limited(distance_q20)};
    go_home();
}

// Puts the eye elsewhere, while it may run on.
LUMI_EXPORT(place_eye) void place_eye(uint32_t azimuth_turns32, uint32_t elevation_turns32, int32_t distance_q20)
{
    eye.orbit = {azimuth_turns32, elevation_turns32, limited(distance_q20)};
}

// Turns around the vertical axis, while nobody touches the picture.
LUMI_EXPORT(turn) void turn(uint32_t azimuth_turns32)
{
    eye.orbit.azimuth_turns32 += azimuth_turns32;
}

LUMI_EXPORT(set_part) void set_moving_part(uint32_t part, uint32_t value)
{
    set_part(part, value);
}

LUMI_EXPORT(part_name) const char* name_of_part(uint32_t part)
{
    return part_signs(part).name;
}

LUMI_EXPORT(part_name_bytes) uint32_t part_name_bytes(uint32_t part)
{
    return part_signs(part).name_bytes;
}

LUMI_EXPORT(part_slides) bool part_slides(uint32_t part)
{
    return part_signs(part).slides;
}

// Each weight is at most 2^16 - 1; kFullWeight is all.
LUMI_EXPORT(set_state) void weigh_state(uint32_t state, uint32_t r_q12, uint32_t g_q12, uint32_t b_q12)
{
    const auto weight = [](uint32_t q12) { return static_cast<uint16_t>(q12); };
    set_state_weight(state, {weight(r_q12), weight(g_q12), weight(b_q12)});
}

LUMI_EXPORT(azimuth) uint32_t azimuth()
{
    return eye.orbit.azimuth_turns32;
}

LUMI_EXPORT(elevation) int32_t elevation()
{
    return static_cast<int32_t>(eye.orbit.elevation_turns32);
}

LUMI_EXPORT(distance) int32_t distance()
{
    return eye.orbit.distance_q20;
}

// The eye's distance, times a number of 16 fraction bits; advance() goes there.
LUMI_EXPORT(scale_distance) void scale_distance(uint32_t factor_q16)
{
    eye.distance_aim_q20 = limited(int64_t{eye.distance_aim_q20} * factor_q16 / 65536);
}

// A finger, see kTurnPerStep; whether the eye moves.
LUMI_EXPORT(advance) bool advance(bool is_down, int32_t x, int32_t y, uint32_t elapsed_ms)
{
    const bool turns = eye.drag.next({is_down, x, y}, elapsed_ms, eye.orbit);
    return approach(elapsed_ms) || turns;
}

// Returns 0, or a ViewError. The background: red, green and blue, 8 bits each, red on top; or kGradient.
LUMI_EXPORT(draw_frame) uint32_t draw_frame(uint32_t mode, uint32_t format, uint32_t background)
{
    if (image.width_px == 0 || !is_style(mode, format)) return static_cast<uint32_t>(ViewError::bad_argument);
    const Rgb8 colour = {static_cast<uint8_t>(background >> 16), static_cast<uint8_t>(background >> 8),
                         static_cast<uint8_t>(background)};
    const Style style = {mode, static_cast<DisplayFormat>(format), {colour}};
    ViewError error = look(pose_of(eye.orbit), image, style, memory.frame);
    if (error == ViewError::none) error = draw_stripes(style, background == kGradient);
    return static_cast<uint32_t>(error);
}

// RAM of a firmware that draws this screen: what a frame takes, and a stripe of pixels.
LUMI_EXPORT(device_ram) uint32_t device_ram(uint32_t mode, uint32_t format)
{
    if (!is_style(mode, format)) return 0;
    const host::ScreenSize screen = {image.width_px, image.height_px, kStripeRows};
    const auto shown = static_cast<DisplayFormat>(format);
    const uint32_t stripe =
        with_pixel(shown, [&](auto pixel) { return host::stripe_pixel_bytes<decltype(pixel)>(screen); });
    return device_bytes(screen, mode, shown) + stripe;
}
