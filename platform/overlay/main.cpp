// SPDX-License-Identifier: MIT
// Live data on a baked object: a needle and digits over the face of the desk clock, projected by the camera that draws
// it. platform/riscv and platform/simulator run this program.
#include <lumi/fixed.h>
#include <lumi/view.h>

#include "board.h"
#include "desk_clock.h"  // written by lumi_add_field
#include "overlay.h"

using namespace lumi;

// A finger's breadth before the dial of baker/scenes/product.obj, above its hands.
static constexpr overlay::Plane kFace = {
    {406156, 0, 280841}, {0, 1 << 30, 0}, {-186453311, 0, 1057429273}, {1057429273, 0, 186453311}};
static constexpr uint16_t kOrange = 0xFC00, kGreen = 0x07E0;

static desk_clock_view<Screen<240, 240, 16>> view;
alignas(4) static uint8_t pixels[240 * 16 * 2];

static void draw_overlay(const Stripe& stripe, const overlay::Sheet& face, int32_t percent)
{
    if (!face.is_seen()) return;
    const SinCos turn = sin_cos(degrees(-120 + percent * 240 / 100));  // 0 % points to the lower left
    constexpr int32_t kLength = 4 * (kOneQ20 / 10);
    const overlay::Place tip = {static_cast<int32_t>(int64_t{kLength} * turn.sin_q30 >> 30),
                                static_cast<int32_t>(int64_t{kLength} * turn.cos_q30 >> 30)};
    draw_stroke(stripe, face.pixel_of({0, 0}), face.pixel_of(tip), 3, kOrange);
    const char text[] = {static_cast<char>('0' + percent / 10), static_cast<char>('0' + percent % 10), '\0'};
    draw_text(stripe, face, text, {-kOneQ20 / 16, -kOneQ20 / 4}, kOneQ20 / 8, kGreen);
}

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
            draw_overlay(stripe, overlay::Sheet(kFace, camera), percent);
            board::send(pixels, sizeof(pixels));
        }
    }
    return 0;
}
