// SPDX-License-Identifier: MIT
// The smallest program that draws a surface field, as size.cpp is for chord fields.
#include "surface_instance.h"

int main(int, char**)
{
    using namespace lumi;
    const SurfaceField* volatile field = nullptr;
    const SurfaceCamera* volatile camera = nullptr;
    volatile SurfaceMode mode = SurfaceMode::one_sample;
    uint8_t* volatile pixels = nullptr;
    bench::draw_surface(*field, {*camera, mode}, bench::kSurfaceStripeHeight, pixels);
    return 0;
}
