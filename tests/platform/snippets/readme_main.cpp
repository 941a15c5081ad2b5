// SPDX-License-Identifier: MIT
// Calls README's snippet and writes two frames.
#include <cstdio>
#include <cstring>

#include <lumi/orbit.h>

#include "slow_dma.h"

const char* start();
bool draw_frame(uint32_t azimuth_turns32, void (*flush)(const uint8_t* pixels, uint32_t bytes));

namespace
{

void flush(const uint8_t* pixels, uint32_t bytes)
{
    dma_start(pixels, bytes);
    dma_wait();
}

}  // namespace

int main()
{
    const char* error = start();
    if (std::strcmp(error, "no error") != 0) return std::fprintf(stderr, "%s\n", error), 1;
    const bool has_first = draw_frame(lumi::degrees(30), flush);
    return has_first && draw_frame(lumi::degrees(30) + lumi::degrees(2), flush) ? 0 : 1;
}
