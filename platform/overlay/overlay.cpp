// SPDX-License-Identifier: MIT
#include "overlay.h"

#include <lumi/pixel.h>

namespace overlay
{
namespace
{

using lumi::Vec3q20;
using lumi::Vec3q30;

// Q20 × Q30 to Q20.
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

void put(const lumi::Stripe& stripe, int32_t x, int32_t y, uint16_t rgb565)
{
    if (x < stripe.x_px || x >= stripe.right_px() || y < stripe.y_px || y >= stripe.bottom_px()) return;
    lumi::PixelRgb565Swapped::store_packed(lumi::pixel_of<lumi::PixelRgb565Swapped>(stripe, x, y), rgb565);
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

}  // namespace

Sheet::Sheet(const Plane& plane, const lumi::SurfaceCamera& camera)
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
    const int64_t ahead = larger(dot(point, camera_.forward), lumi::kOneQ20 / 256);
    const auto place_q8 = [&](int32_t across, int32_t centre_q8) {
        return centre_q8 + static_cast<int32_t>(int64_t{across} * camera_.focal_q12 / ahead >> 4);
    };
    return {place_q8(dot(point, camera_.right), camera_.centre_x_q8),
            place_q8(-dot(point, camera_.up), camera_.centre_y_q8)};
}

void draw_stroke(const lumi::Stripe& stripe, const Pixel& a, const Pixel& b, int32_t width_px, uint16_t rgb565)
{
    const int32_t dx = b.x_q8 - a.x_q8, dy = b.y_q8 - a.y_q8;
    const int32_t steps = larger(1, (larger(larger(dx, -dx), larger(dy, -dy)) + 255) >> 8);
    for (int32_t k = 0; k <= steps; ++k) {
        const int32_t x = (a.x_q8 + dx * k / steps) >> 8, y = (a.y_q8 + dy * k / steps) >> 8;
        for (int32_t j = 0; j < width_px * width_px; ++j)
            put(stripe, x + j % width_px - width_px / 2, y + j / width_px - width_px / 2, rgb565);
    }
}

void draw_text(const lumi::Stripe& stripe, const Sheet& sheet, const char* text, const Place& at, int32_t height_q20,
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

}  // namespace overlay
