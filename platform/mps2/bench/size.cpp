// SPDX-License-Identifier: MIT
// The smallest program that draws: its size less that of an empty one is what the renderer puts into flash, library
// routines and tables included, opening of fields and making of cameras left out.
#include "instance.h"

int main(int, char**)
{
    using namespace lumi;
    const Field* volatile field = nullptr;
    const Camera* volatile camera = nullptr;
    const Stripe* volatile stripe = nullptr;
    volatile int32_t span_px = 0;
    return bench::draw(*field, *camera, *stripe, span_px) == RenderError::none ? 0 : 1;
}
