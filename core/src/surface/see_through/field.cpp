// SPDX-License-Identifier: MIT
#include "lumi/surface/see_through_frame.h"
#include "surface/open_mesh.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;

// Parts the see-through patches from the opaque ones.
FieldError part_patches(const uint8_t* section, SeeThroughField& field)
{
    const uint32_t first = container::load_u16(section + see_through::kFirstAt);
    const uint32_t order = container::load_u16(section + see_through::kOrderAt);
    if (order >= kDrawingOrders || first >= field.patch_count) return FieldError::bad_see_through;
    field.is_in_order = static_cast<DrawingOrder>(order) == DrawingOrder::of_the_file;
    field.see_through_count = static_cast<uint16_t>(field.patch_count - first);
    field.see_through_palette = section + see_through::kPaletteAt;
    field.patch_count = first;
    return has_fitting_neighbours(field) ? FieldError::none : FieldError::bad_neighbours;
}

}  // namespace

FieldError open_surface(const uint8_t* bytes, size_t size, SeeThroughField& out)
{
    SeeThroughField field;
    if (const FieldError error = open_mesh(bytes, size, kSeeThroughSections, field); error != FieldError::none)
        return error;
    if (container::Section section{}; container::find_section(bytes, kSeeThroughSection, section)) {
        if (section.size != kSeeThroughBytes) return FieldError::bad_see_through;
        if (const FieldError error = part_patches(bytes + section.offset, field); error != FieldError::none)
            return error;
    }
    out = field;
    return FieldError::none;
}

}  // namespace lumi
