// SPDX-License-Identifier: MIT
// Reads and checks the section of gloss maps.
#include "field/sections.h"
#include "lumi/surface/detail/gloss.h"
#include "surface/owners.h"
#include "surface/view_light.h"

namespace lumi::detail
{
namespace
{

using namespace format;
using namespace container;

// Whether the patches' maps exist, and they are opaque ones of the body whose corners have view tables.
bool choices_fit(const SurfaceField& field)
{
    const NumberRange body = owner_ranges(field, 0).patches;
    for (uint32_t k = 0; k < uint32_t{field.patch_count} + field.see_through_count; ++k) {
        const uint32_t map = gloss_of(field, k);
        if (map == 0) continue;
        if (map > gloss_count(field) || !body.has(k)) return false;
        for (const uint32_t corner : surface_patch(field, k).corner)
            if (corner != kNoVertex && corner >= field.viewed_count) return false;
    }
    return true;
}

// Whether the vertices' turns are of unit length at most, but for their rounding: products of longer ones would
// overflow.
bool turns_fit(const SurfaceField& field)
{
    constexpr int32_t kMost = 128;  // one is 127
    for (uint32_t k = 0; k < field.viewed_count; ++k) {
        const uint8_t* const turn = field.views + k * view_bytes(field.code_bits) + view_turn_at(field.code_bits);
        int32_t square = 0;
        for (int c = 0; c < 3; ++c) square += signed_byte(turn + c) * signed_byte(turn + c);
        if (square > kMost * kMost) return false;
    }
    return true;
}

}  // namespace

FieldError read_gloss(const uint8_t* bytes, SurfaceField& field)
{
    Section section{}, surface{};
    if (!find_section(bytes, kGlossSection, section)) return FieldError::none;
    if (has_section(bytes, kStateSection) || section.size < kGlossHeaderBytes) return FieldError::bad_gloss;
    const uint8_t* const at = bytes + section.offset;
    const uint32_t maps = at[0];
    find_section(bytes, kSurfaceSection, surface);
    const uint32_t patches = load_u16(bytes + surface.offset + surface::kPatchesAt);
    if (maps == 0 || maps > kMaxGlossMaps || (at[1] | at[2] | at[3]) != 0 || section.size != gloss_bytes(maps, patches))
        return FieldError::bad_gloss;
    for (uint32_t k = 0; k < maps; ++k)
        if (at[kGlossHeaderBytes + k * kGlossGainBytes + 3] != 0) return FieldError::bad_gloss;
    field.gloss = at;
    return choices_fit(field) && turns_fit(field) ? FieldError::none : FieldError::bad_gloss;
}

}  // namespace lumi::detail
