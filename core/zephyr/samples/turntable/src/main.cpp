// SPDX-License-Identifier: MIT
// Turns the field on the display that the board's devicetree chose, 240 × 240 pixels of it, in the pixels of SPI panels
// (high byte first: PIXEL_FORMAT_RGB_565X, up to Zephyr 4.3 PIXEL_FORMAT_BGR_565).
#include <zephyr/device.h>
#include <zephyr/drivers/display.h>

#include "product.h"  // written by lumi_add_field

using namespace lumi;

static product_view<Screen<240, 240, 16>> view;
alignas(4) static uint8_t pixels[240 * 16 * 2];

static bool draw_frame(const device* display, const Orbit& orbit)
{
    display_buffer_descriptor part = {};
    part.buf_size = sizeof(pixels);
    part.width = part.pitch = 240;
    part.height = 16;
    if (view.look(orbit) != ViewError::none) return false;
    for (int32_t y = 0; y < 240; y += 16) {
        if (view.draw({pixels, 0, y, 240, 16, 480}) != ViewError::none) return false;
        if (display_write(display, 0, static_cast<uint16_t>(y), &part, pixels) != 0) return false;
    }
    return true;
}

int main()
{
    const device* const display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
    if (!device_is_ready(display) || view.open(product, product_size()) != ViewError::none) return 1;
    display_blanking_off(display);
    for (Orbit orbit = {0, degrees(20), radii(3)}; draw_frame(display, orbit);) orbit.azimuth_turns32 += degrees(2);
    return 1;
}
