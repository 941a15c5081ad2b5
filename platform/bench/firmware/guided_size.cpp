// SPDX-License-Identifier: MIT
// The smallest program that draws a guided field, as size.cpp is for chord fields.
#include "guided_instance.h"

int main(int, char**)
{
    using namespace lumi;
    const GuidedField* volatile field = nullptr;
    const GuidedCamera* volatile camera = nullptr;
    uint8_t* volatile pixels = nullptr;
    return bench::draw_guided(*field, *camera, pixels) ? 0 : 1;
}
