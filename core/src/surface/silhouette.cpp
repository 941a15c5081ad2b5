// SPDX-License-Identifier: MIT
#include "surface/silhouette.h"

#include "surface/cut_pixels.h"

namespace lumi::detail
{

LUMI_HOT void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to, const Target& target)
{
    mark_cut_pixels<false>(from, to, target);
}

}  // namespace lumi::detail
