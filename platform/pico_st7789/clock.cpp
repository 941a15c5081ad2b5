// SPDX-License-Identifier: MIT
// A clock shows the time. Each second its hands turn, and the display is sent only what has changed.
#include <lumi/view.h>

#include "board.h"
#include "running_clock.h"  // written by lumi_add_field

using namespace lumi;

static running_clock_view<Screen<240, 240, 16>> view;
alignas(4) static uint8_t stripes[2][240 * 16 * 2];

static bool turn(uint32_t hand, uint32_t seconds, uint32_t seconds_a_turn)
{
    const uint64_t turns = (uint64_t{seconds % seconds_a_turn} << 32) / seconds_a_turn;
    return view.turn(hand, static_cast<uint32_t>(turns)) == ViewError::none;
}

static bool show(const Orbit& orbit, uint32_t second)
{
    // Most seconds move one hand alone: the others take steps that still are small, of 1 degree and half a degree.
    return turn(running_clock_parts::second_hand, second, 60) &&
           turn(running_clock_parts::minute_hand, second / 10 * 10, 60 * 60) &&
           turn(running_clock_parts::hour_hand, second / 60 * 60, 12 * 60 * 60) && view.look(orbit) == ViewError::none;
}

static bool draw(const PixelRect& rect)
{
    const auto stride = static_cast<uint32_t>(2 * rect.width_px);
    const int32_t end = rect.y_px + rect.height_px, most = view.rows_at(rect.width_px);
    uint32_t number = 0;
    board::set_window(rect);
    for (int32_t y = rect.y_px; y < end; y += most, ++number) {
        const int32_t rows = end - y < most ? end - y : most;
        uint8_t* const stripe = stripes[number % 2];
        if (view.draw({stripe, rect.x_px, y, rect.width_px, rows, stride}) != ViewError::none) return false;
        board::send(stripe, stride * static_cast<uint32_t>(rows));
    }
    return true;
}

int main()
{
    Orbit orbit;
    uint32_t second = 0;
    if (view.open(running_clock, running_clock_size()) != ViewError::none) return 1;
    while (board::next_second(orbit, second)) {
        if (!show(orbit, second)) return 1;
        const ChangedRects changed = view.changed();
        for (uint32_t k = 0; k < changed.count; ++k)
            if (!draw(changed.rect[k])) return 1;
    }
    return 0;
}
