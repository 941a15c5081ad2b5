// SPDX-License-Identifier: MIT
// Baselines are not split into set-up and inner loop.
#include "instance.h"

namespace lumi::bench
{

RenderError draw_setup_only(const Field&, const Camera&, const Stripe&, int32_t)
{
    return RenderError::none;
}

}  // namespace lumi::bench
