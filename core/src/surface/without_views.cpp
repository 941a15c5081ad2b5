// SPDX-License-Identifier: MIT
// A frame of a field without view tables. Apart from prepare(), whose loops stay as they are.
#include "surface/preparing.h"

namespace lumi::detail
{
namespace
{

// For vertices that have their colour already.
LUMI_ALWAYS_INLINE void light_nothing(const SurfaceFrame&, const SurfaceVertex*) {}

}  // namespace

void prepare_without_views(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                           const SurfaceMemory& memory, SurfaceFrame& out)
{
    constexpr uint32_t kAsTexels = 0;
    if (!begin_frame(field, camera, mode, memory, out)) return;
    set_extents(out, put_vertices(out, 0, field.vertex_count, kAsTexels));
    Lister<light_nothing> lister(out, memory.bands);
    for (uint32_t k = 0; k < field.patch_count; ++k) lister.add(k, surface_patch(field, k).corner);
    out.reach = lister.reach();
}

}  // namespace lumi::detail
