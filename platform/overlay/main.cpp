// SPDX-License-Identifier: MIT
// Live data on a baked object: a needle and digits over the face of the desk clock, projected by the camera that draws
// it. platform/riscv and platform/simulator run this program.
//
// Points of the scene are projected by the camera that draws it, and strokes go into the stripe that was just drawn.
// They lie on a plane that is seen from its front alone; nothing of the object hides them.
#include <lumi/fixed.h>
#include <lumi/pixel.h>
#include <lumi/view.h>

#include "board.h"
#include "desk_clock.h"  // written by lumi_add_field

using namespace lumi;

namespace
{

// A plane of the field's frame (the sphere's centre is the origin, its radius 1): points are centre + x·right + y·up.
struct Plane {
    Vec3q20 centre;
    Vec3q30 right, up, normal;
};

// Lies on a plane, in radii of the sphere, Q20.
struct Place {
    int32_t x_q20, y_q20;
};

struct Pixel {
    int32_t x_q8, y_q8;
};

class Sheet
{
public:
    Sheet(const Plane& plane, const SurfaceCamera& camera);

    // Tells whether it is seen from its front, and all of it before the eye.
    bool is_seen() const { return is_seen_; }
    // Precondition: is_seen(), and a place within a radius of the sphere's centre.
    Pixel pixel_of(const Place& place) const;

private:
    Plane plane_;
    SurfaceCamera camera_;
    bool is_seen_;
};

// Multiplies Q20 by Q30 to Q20.
int32_t scaled(int64_t length_q20, int32_t factor_q30)
{
    return static_cast<int32_t>((length_q20 * factor_q30 + (1 << 29)) >> 30);
}

int32_t dot(const Vec3q20& a, const Vec3q30& b)
{
    return scaled(a.x, b.x) + scaled(a.y, b.y) + scaled(a.z, b.z);
}

Vec3q20 difference(const Vec3q20& a, const Vec3q20& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

int32_t larger(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

void put(const Stripe& stripe, int32_t x, int32_t y, uint16_t rgb565)
{
    if (x < stripe.x_px || x >= stripe.right_px() || y < stripe.y_px || y >= stripe.bottom_px()) return;
    PixelRgb565Swapped::store_packed(pixel_of<PixelRgb565Swapped>(stripe, x, y), rgb565);
}

// The segments of a clock's digit, from the top one clockwise, then the middle one: ends as 10·x + y, 2 columns by 4
// rows.
constexpr int8_t kSegments[7][2] = {{4, 24}, {22, 24}, {20, 22}, {0, 20}, {0, 2}, {2, 4}, {2, 22}};
constexpr uint8_t kDigits[10] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};
constexpr uint8_t kDash = 0x40;

uint8_t segments_of(char sign)
{
    if (sign >= '0' && sign <= '9') return kDigits[sign - '0'];
    return sign == '-' ? kDash : 0;
}

Sheet::Sheet(const Plane& plane, const SurfaceCamera& camera)
    : plane_(plane), camera_(camera), is_seen_(dot(difference(camera.position, plane.centre), plane.normal) > 0)
{
}

Pixel Sheet::pixel_of(const Place& place) const
{
    const auto coordinate = [&](int32_t centre, int32_t right, int32_t up, int32_t eye) {
        return centre + scaled(place.x_q20, right) + scaled(place.y_q20, up) - eye;
    };
    const Vec3q20 point = {coordinate(plane_.centre.x, plane_.right.x, plane_.up.x, camera_.position.x),
                           coordinate(plane_.centre.y, plane_.right.y, plane_.up.y, camera_.position.y),
                           coordinate(plane_.centre.z, plane_.right.z, plane_.up.z, camera_.position.z)};
    const int64_t ahead = larger(dot(point, camera_.forward), kOneQ20 / 256);
    const auto place_q8 = [&](int32_t across, int32_t centre_q8) {
        return centre_q8 + static_cast<int32_t>(int64_t{across} * camera_.focal_q12 / ahead >> 4);
    };
    return {place_q8(dot(point, camera_.right), camera_.centre_x_q8),
            place_q8(-dot(point, camera_.up), camera_.centre_y_q8)};
}

// Draws a stroke of about `width_px` pixels, 1 to 8, in PixelRgb565Swapped.
void draw_stroke(const Stripe& stripe, const Pixel& a, const Pixel& b, int32_t width_px, uint16_t rgb565)
{
    const int32_t dx = b.x_q8 - a.x_q8, dy = b.y_q8 - a.y_q8;
    const int32_t steps = larger(1, (larger(larger(dx, -dx), larger(dy, -dy)) + 255) >> 8);
    for (int32_t k = 0; k <= steps; ++k) {
        const int32_t x = (a.x_q8 + dx * k / steps) >> 8, y = (a.y_q8 + dy * k / steps) >> 8;
        for (int32_t j = 0; j < width_px * width_px; ++j)
            put(stripe, x + j % width_px - width_px / 2, y + j / width_px - width_px / 2, rgb565);
    }
}

// Draws digits, ':' and '-' of strokes, `height` high and half as wide, from their lower left corner on.
void draw_text(const Stripe& stripe, const Sheet& sheet, const char* text, const Place& at, int32_t height_q20,
               uint16_t rgb565)
{
    const int32_t unit = height_q20 / 4;
    const auto pixel = [&](int32_t k, int32_t place) {
        return sheet.pixel_of({at.x_q20 + k * 3 * unit + place / 10 * unit, at.y_q20 + place % 10 * unit});
    };
    for (int32_t k = 0; text[k] != '\0'; ++k) {
        for (int segment = 0; segment < 7; ++segment) {
            if ((segments_of(text[k]) >> segment & 1) == 0) continue;
            draw_stroke(stripe, pixel(k, kSegments[segment][0]), pixel(k, kSegments[segment][1]), 2, rgb565);
        }
        if (text[k] != ':') continue;
        draw_stroke(stripe, pixel(k, 11), pixel(k, 11), 2, rgb565);
        draw_stroke(stripe, pixel(k, 13), pixel(k, 13), 2, rgb565);
    }
}

// This plane lies a finger's breadth before the dial of baker/scenes/product.obj, above its hands.
constexpr Plane kFace = {{406156, 0, 280841}, {0, 1 << 30, 0}, {-186453311, 0, 1057429273}, {1057429273, 0, 186453311}};
constexpr uint16_t kOrange = 0xFC00, kGreen = 0x07E0;

desk_clock_view<Screen<240, 240, 16>> view;
alignas(4) uint8_t pixels[240 * 16 * 2];

void draw_overlay(const Stripe& stripe, const Sheet& face, int32_t percent)
{
    if (!face.is_seen()) return;
    const SinCos turn = sin_cos(degrees(-120 + percent * 240 / 100));  // 0 % points to the lower left
    constexpr int32_t kLength = 4 * (kOneQ20 / 10);
    const Place tip = {static_cast<int32_t>(int64_t{kLength} * turn.sin_q30 >> 30),
                       static_cast<int32_t>(int64_t{kLength} * turn.cos_q30 >> 30)};
    draw_stroke(stripe, face.pixel_of({0, 0}), face.pixel_of(tip), 3, kOrange);
    const char text[] = {static_cast<char>('0' + percent / 10), static_cast<char>('0' + percent % 10), '\0'};
    draw_text(stripe, face, text, {-kOneQ20 / 16, -kOneQ20 / 4}, kOneQ20 / 8, kGreen);
}

}  // namespace

int main()
{
    Orbit orbit;
    SurfaceCamera camera;
    int32_t percent = 25;  // the value that the gauge shows
    if (view.open(desk_clock, desk_clock_size()) != ViewError::none) return 1;
    for (; board::next_view(orbit); percent = (percent + 42) % 100) {
        if (view.look(orbit) != ViewError::none) return 1;
        if (make_surface_camera(pose_of(orbit), image_of(orbit, 240, 240), camera) != CameraError::none) return 1;
        for (int32_t y = 0; y < 240; y += 16) {
            const Stripe stripe = {pixels, 0, y, 240, 16, 480};
            if (view.draw(stripe) != ViewError::none) return 1;
            draw_overlay(stripe, Sheet(kFace, camera), percent);
            board::send(pixels, sizeof(pixels));
        }
    }
    return 0;
}
