// SPDX-License-Identifier: MIT
// This is main.cpp on both cores: each prepares half of a frame. Core 0 draws the upper stripe of each pair, core 1 the
// lower one.
#include <lumi/view.h>

#include "board.h"
#include "core1.h"
#include "desk_clock.h"  // written by lumi_add_field

using namespace lumi;
using namespace lumi::detail;

using ClockView = desk_clock_view<Screen<240, 240, 16>>;
static ClockView view;
static ClockView::Samples samples_of_core1;
static ClockView::Halves halves;
alignas(4) static uint8_t stripes[4][240 * 16 * 2];  // two are sent while two are drawn
static ViewError error_of_core1;

static void prepare_on_core1(int32_t step)
{
    halves.prepare(step, 1);
}

static ViewError look(const Orbit& orbit)
{
    return view.look(
        orbit, halves,
        [](int32_t step) {
            core1::run(prepare_on_core1, step);
            halves.prepare(step, 0);
            core1::wait();
        });
}

static uint8_t* stripe_at(int32_t y)
{
    return stripes[y / 16 % 4];
}

static void draw_on_core1(int32_t y)
{
    error_of_core1 = view.draw({stripe_at(y), 0, y, 240, 16, 480}, OverBlack{}, samples_of_core1);
}

static bool draw_pair(int32_t y)
{
    const bool has_lower = y + 16 < 240;
    if (has_lower) core1::run(draw_on_core1, y + 16);
    const ViewError error = view.draw({stripe_at(y), 0, y, 240, 16, 480});
    if (has_lower) core1::wait();
    board::send(stripe_at(y), sizeof(stripes[0]));
    if (has_lower) board::send(stripe_at(y + 16), sizeof(stripes[0]));
    return error == ViewError::none && error_of_core1 == ViewError::none;
}

int main()
{
    Orbit orbit;
    if (view.open(desk_clock, desk_clock_size()) != ViewError::none) return 1;
    core1::start();
    while (board::next_view(orbit)) {
        if (look(orbit) != ViewError::none) return 1;
        for (int32_t y = 0; y < 240; y += 32)
            if (!draw_pair(y)) return 1;
    }
    return 0;
}
