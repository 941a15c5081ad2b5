// SPDX-License-Identifier: MIT
// Calls README's snippet and writes its frame.
#include <cstdio>
#include <cstring>

#include <lumi/orbit.h>

const char* start();
bool draw_frame(uint32_t azimuth_turns32, void (*flush)(const uint8_t* pixels, uint32_t bytes));

namespace
{

void flush(const uint8_t* pixels, uint32_t bytes)
{
    std::fwrite(pixels, 1, bytes, stdout);
}

}  // namespace

int main()
{
    const char* error = start();
    if (std::strcmp(error, "no error") != 0) return std::fprintf(stderr, "%s\n", error), 1;
    return draw_frame(lumi::degrees(30), flush) ? 0 : 1;
}
