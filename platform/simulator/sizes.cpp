// SPDX-License-Identifier: MIT
#include "simulator.h"

#include <lumi/view.h>

#include "board.h"
#include "desk_clock.h"  // written by lumi_add_field

using namespace lumi;
using namespace lumi::detail;

namespace simulator
{
namespace
{

constexpr int32_t kRows = 16;

// main.cpp of platform/pico_st7789 for another Screen; the last stripe may be a lower one.
template <int32_t kWidth, int32_t kHeight>
int main_of()
{
    static desk_clock_view<Screen<kWidth, kHeight, kRows>> view;
    alignas(4) static uint8_t stripe[size_t{kWidth} * kRows * 2];
    Orbit orbit;
    if (view.open(desk_clock, desk_clock_size()) != ViewError::none) return 1;
    while (board::next_view(orbit)) {
        if (view.look(orbit) != ViewError::none) return 1;
        for (int32_t y = 0; y < kHeight; y += kRows) {
            const int32_t rows = kHeight - y < kRows ? kHeight - y : kRows;
            if (view.draw({stripe, 0, y, kWidth, rows, 2 * kWidth}) != ViewError::none) return 1;
            board::send(stripe, static_cast<uint32_t>(2 * kWidth * rows));
        }
    }
    return 0;
}

struct Size {
    int width_px, height_px;
    int (*main)();
};

template <int32_t kWidth, int32_t kHeight>
constexpr Size kSize = {kWidth, kHeight, main_of<kWidth, kHeight>};

// Small colour displays of these sizes are sold.
constexpr Size kSizes[] = {
    kSize<96, 64>,   kSize<128, 128>, kSize<135, 240>, kSize<160, 128>, kSize<170, 320>, kSize<240, 135>,
    kSize<240, 240>, kSize<240, 320>, kSize<320, 240>, kSize<360, 360>, kSize<390, 390>, kSize<410, 502>,
    kSize<466, 466>, kSize<480, 320>, kSize<480, 480>, kSize<800, 480>,
};

std::string name_of(const Size& size)
{
    return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
}

}  // namespace

int (*main_of_size(const char* name))()
{
    for (const Size& size : kSizes) {
        if (name_of(size) != name) continue;
        options.width_px = size.width_px;
        options.height_px = size.height_px;
        return size.main;
    }
    return nullptr;
}

std::string size_names()
{
    std::string names;
    for (const Size& size : kSizes) names += (names.empty() ? "" : "|") + name_of(size);
    return names;
}

}  // namespace simulator
