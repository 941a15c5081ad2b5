// SPDX-License-Identifier: MIT
#include "planner/ram.h"

#include "lumi/chord/render_spans.h"

namespace lumi::planner
{

Ram ram_of(const host::SurfaceCounts& field, const host::ScreenSize& screen)
{
    return {host::surface_view_bytes<PixelRgb565>(field, screen), host::stripe_pixel_bytes<PixelRgb565>(screen)};
}

Ram ram_of(const tools::FieldFile& field, SurfaceMode finest, const host::ScreenSize& screen)
{
    if (!field.is_surface())
        return {host::chord_view_bytes(fits_spans(field.field())), host::stripe_pixel_bytes<PixelRgb565>(screen)};
    const SeeThroughField& surface = field.surface();
    return ram_of({surface.vertex_count, surface.patch_count, finest, surface.see_through_count}, screen);
}

uint32_t stack_of(const tools::FieldFile& field)
{
    if (field.is_surface()) return kSurfaceStackBytes;
    return fits_spans(field.field()) ? kSpanStackBytes : kExactStackBytes;
}

}  // namespace lumi::planner
