// SPDX-License-Identifier: MIT
#include "instance.h"

namespace lumi::bench
{

RenderError draw_setup_only(const Field& field, const Camera& camera, const Stripe& stripe, int32_t)
{
    return draw_hits_only(field, camera, stripe);
}

}  // namespace lumi::bench
