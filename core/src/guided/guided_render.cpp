// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_render.h"

namespace lumi
{

const char* describe(GuidedError error)
{
    switch (error) {
        case GuidedError::none:
            return "no error";
        case GuidedError::wrong_policy:
            return "the field does not hold what the renderer's policy reads";
        case GuidedError::unaligned:
            return "the field's address is not divisible by 4";
    }
    return "unknown error";
}

bool is_aligned(const GuidedField& field)
{
    const auto at_even_address = [](const uint8_t* p) { return reinterpret_cast<uintptr_t>(p) % 4 == 0; };
    return at_even_address(field.colours) && at_even_address(field.chart.rows) &&
           at_even_address(field.occlusion.rows) && at_even_address(field.mean.palette) &&
           at_even_address(field.mean.index) && at_even_address(field.mean.bricks);
}

}  // namespace lumi
