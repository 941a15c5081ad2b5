// SPDX-License-Identifier: MIT
// Exits with 0 if the object is in the picture, drawn twice, and no stripe is written while it is sent.
#include "consumer_field.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "picture.h"

namespace
{

// Stands for a display that is slow: a stripe is on its way until the next one comes. Counts the bytes that are not
// background, and stripes that changed meanwhile.
struct SlowDisplay {
    const uint8_t* sent = nullptr;
    std::vector<uint8_t> noise;  // what lies in its place, of which a write leaves traces
    long lit = 0, torn = 0;

    void end()
    {
        if (sent != nullptr && !std::equal(noise.begin(), noise.end(), sent)) ++torn;
    }

    void flush(uint8_t* pixels, uint32_t bytes)
    {
        end();
        lit += bytes - std::count(pixels, pixels + bytes, uint8_t{0});
        noise.resize(bytes);
        for (uint32_t k = 0; k < bytes; ++k) noise[k] = pixels[k] = static_cast<uint8_t>(k * 151 + 43);
        sent = pixels;
    }
};

}  // namespace

int main()
{
    SlowDisplay display;
    for (int frame = 0; frame < 2; ++frame) {
        const auto flush = [](void* context, uint8_t* pixels, uint32_t bytes) {
            static_cast<SlowDisplay*>(context)->flush(pixels, bytes);
        };
        const char* error = draw_picture(consumer_field, consumer_field_size(), flush, &display);
        if (error != nullptr) {
            std::fprintf(stderr, "%s\n", error);
            return 1;
        }
    }
    display.end();
    std::printf("%ld bytes are not background, %ld stripes were written while they were sent\n", display.lit,
                display.torn);
    return display.lit > 0 && display.torn == 0 ? 0 : 1;
}
