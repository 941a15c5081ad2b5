// SPDX-License-Identifier: MIT
// Turns a field on a round AMOLED panel of 466 × 466 pixels, whose controller takes windows with even sides alone. Of
// each frame only what changes is sent: where the object is, and where it was.
#include <esp_lcd_panel_ops.h>

#include "product.h"  // written by lumi_add_field

// You write this for your board, as the example of its panel's driver does it: a panel of 466 × 466 pixels of 16 bits
// behind SPI or QSPI, switched on; nullptr if it does not answer.
esp_lcd_panel_handle_t make_panel();

using namespace lumi;

constexpr int32_t kSide = 466, kRows = 8;
static product_view<Screen<kSide, kSide, kRows>> view;
alignas(4) static uint8_t stripes[2][kSide * kRows * 2];

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

// The window around both with even sides. The image has even sides, so it lies within.
static PixelRect window_around(const PixelRect& a, const PixelRect& b)
{
    const int32_t left = least(a.x_px, b.x_px) & ~1, top = least(a.y_px, b.y_px) & ~1;
    const int32_t right = most(a.x_px + a.width_px, b.x_px + b.width_px) + 1;
    const int32_t bottom = most(a.y_px + a.height_px, b.y_px + b.height_px) + 1;
    return {left, top, (right & ~1) - left, (bottom & ~1) - top};
}

// A panel's driver waits for the pixels that it still sends before it sends the next window, so that two buffers do.
static bool send(esp_lcd_panel_handle_t panel, const PixelRect& window)
{
    static int current;
    const uint32_t stride = static_cast<uint32_t>(window.width_px) * 2;
    for (int32_t y = window.y_px; y < window.y_px + window.height_px; y += kRows, current ^= 1) {
        const int32_t rows = least(kRows, window.y_px + window.height_px - y);
        if (view.draw({stripes[current], window.x_px, y, window.width_px, rows, stride}) != ViewError::none)
            return false;
        if (esp_lcd_panel_draw_bitmap(panel, window.x_px, y, window.x_px + window.width_px, y + rows,
                                      stripes[current]) != ESP_OK)
            return false;
    }
    return true;
}

extern "C" void app_main()
{
    const esp_lcd_panel_handle_t panel = make_panel();
    if (panel == nullptr || view.open(product, product_size()) != ViewError::none) return;
    PixelRect last = {0, 0, kSide, kSide};
    for (Orbit orbit = {0, degrees(20), radii(3)}; view.look(orbit) == ViewError::none;) {
        const PixelRect now = view.bounds();
        if (!send(panel, window_around(last, now))) return;
        last = now;
        orbit.azimuth_turns32 += degrees(2);
    }
}
