// SPDX-License-Identifier: MIT
// consumer FIELD: exits with 0 if the object is in the picture.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "picture.h"

namespace
{

// Stands for a display: counts the bytes that are not background.
void count_lit(void* context, const uint8_t* pixels, uint32_t bytes)
{
    *static_cast<long*>(context) += bytes - std::count(pixels, pixels + bytes, uint8_t{0});
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: consumer FIELD\n", stderr);
        return 1;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    long lit = 0;
    const char* error = draw_picture(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), count_lit, &lit);
    if (error != nullptr) {
        std::fprintf(stderr, "%s: %s\n", argv[1], error);
        return 1;
    }
    std::printf("%ld bytes are not background\n", lit);
    return lit > 0 ? 0 : 1;
}
