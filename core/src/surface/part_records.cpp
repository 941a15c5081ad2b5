// SPDX-License-Identifier: MIT
// Reads and checks the section of moving parts.
#include "surface/owners.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;
using namespace detail::container;

constexpr int32_t kFarthestQ20 = 2 * kOneQ20;  // pivots, and ends of slides

int32_t load_s32(const uint8_t* p)
{
    return static_cast<int32_t>(load_u32(p));
}

bool is_unit(const Vec3q30& axis)
{
    constexpr int32_t kMost = kOneQ30 + (kOneQ30 >> 12);
    constexpr int64_t kOneQ60 = int64_t{1} << 60;
    const auto fits = [](int32_t c) { return c >= -kMost && c <= kMost; };
    return fits(axis.x) && fits(axis.y) && fits(axis.z) && magnitude(dot_q60(axis, axis) - kOneQ60) <= kOneQ60 >> 11;
}

bool is_near(int64_t q20)
{
    return q20 >= -kFarthestQ20 && q20 <= kFarthestQ20;
}

// Zeros alone are no name.
bool is_name_or_none(const uint8_t* text)
{
    uint32_t end = 0;
    while (end < part::kNameBytes && text[end] != 0) ++end;
    for (uint32_t k = end; k < part::kNameBytes; ++k)
        if (text[k] != 0) return false;
    return true;
}

bool is_record(const uint8_t* record, const PartMotion& m)
{
    if (record[part::kMotionAt] >= kMotions || !is_unit(m.axis)) return false;
    if (!is_near(m.pivot.x) || !is_near(m.pivot.y) || !is_near(m.pivot.z)) return false;
    if (m.slides &&
        ((m.pivot.x | m.pivot.y | m.pivot.z) != 0 || !is_near(m.from) || !is_near(int64_t{m.from} + m.span)))
        return false;
    const bool has_name = record[part::kNameAt] != 0, follows = record[part::kFollowsAt] != 0;
    return has_name != follows && is_name_or_none(record + part::kNameAt);
}

// Whether what does not move by itself follows what does, in the same way.
bool has_sound_shadows(const SurfaceField& field)
{
    const uint32_t movers = mover_count(field);
    for (uint32_t k = movers; k < field.part_count; ++k) {
        const uint32_t leader = followed(field, k);
        if (leader == 0 || leader > movers) return false;
        if (part_motion(field, leader - 1).slides != part_motion(field, k).slides) return false;
    }
    return true;
}

// Whether ranges follow each other within those of the field.
bool are_in_order(const SurfaceField& field)
{
    const auto is_range = [](const NumberRange& r, uint32_t most) { return r.begin <= r.end && r.end <= most; };
    for (uint32_t owner = 0; owner <= field.part_count; ++owner) {
        const OwnerRanges r = owner_ranges(field, owner);
        if (!is_range(r.viewed, field.viewed_count) || !is_range(r.plain, field.vertex_count) ||
            !is_range(r.patches, field.patch_count) || r.plain.begin < field.viewed_count ||
            (owner != 0 && owner <= mover_count(field) && r.patches.begin == r.patches.end))
            return false;
        if (owner > mover_count(field) && (r.patches.begin != r.patches.end || r.viewed.begin != r.viewed.end))
            return false;
    }
    return true;
}

// Whether the corners of patches are their owner's vertices.
bool own_corners(const SurfaceField& field, const OwnerRanges& owner, const NumberRange& patches)
{
    for (uint32_t k = patches.begin; k < patches.end; ++k)
        for (const uint32_t corner : surface_patch(field, k).corner)
            if (corner != kNoVertex && !owner.has_vertex(corner)) return false;
    return true;
}

bool own_neighbours(const SurfaceField& field, const NumberRange& patches)
{
    for (uint32_t k = 4 * patches.begin; k < 4 * patches.end; ++k) {
        const uint32_t triangle = load_u16(field.neighbours + 2 * k) & kNeighbourMask;
        if (triangle != kNoNeighbour && !patches.has(triangle / 2)) return false;
    }
    return true;
}

// The shadow, as an owner, that has a patch's first corner; 0 for the body.
uint32_t shadow_of(const SurfaceField& field, uint32_t patch)
{
    const uint32_t corner = surface_patch(field, patch).corner[0];
    for (uint32_t owner = mover_count(field) + 1; owner <= field.part_count; ++owner)
        if (owner_ranges(field, owner).plain.has(corner)) return owner;
    return 0;
}

FieldError check_owners(const SurfaceField& field)
{
    if (!are_in_order(field)) return FieldError::bad_parts;
    for (uint32_t owner = 0; owner <= field.part_count; ++owner) {
        const OwnerRanges r = owner_ranges(field, owner);
        if (!own_corners(field, r, r.patches)) return FieldError::bad_parts;
        if (field.neighbours != nullptr && !own_neighbours(field, r.patches)) return FieldError::bad_neighbours;
    }
    const uint32_t opaque = field.patch_count;
    for (uint32_t k = opaque; k < opaque + field.see_through_count; ++k)
        if (!own_corners(field, owner_ranges(field, shadow_of(field, k)), {k, k + 1})) return FieldError::bad_parts;
    return FieldError::none;
}

}  // namespace

FieldError detail::read_parts(const uint8_t* bytes, SurfaceField& field)
{
    Section section{};
    if (!find_section(bytes, kPartsSection, section)) return FieldError::none;
    const uint8_t* const at = bytes + section.offset;
    if (section.size < kPartsHeaderBytes) return FieldError::bad_parts;
    const uint32_t count = load_u16(at);
    if (count < 1 || count > kMaxParts || load_u16(at + 2) != 0 ||
        section.size != kPartsHeaderBytes + count * kPartBytes)
        return FieldError::bad_parts;
    field.parts = at + kPartsHeaderBytes;
    field.part_count = static_cast<uint8_t>(count);
    for (uint32_t k = 0; k < count; ++k)
        if (!is_record(part_record(field, k), part_motion(field, k))) return FieldError::bad_parts;
    return has_sound_shadows(field) ? check_owners(field) : FieldError::bad_parts;
}

uint32_t mover_count(const SurfaceField& field)
{
    uint32_t count = 0;
    while (count < field.part_count && followed(field, count) == 0) ++count;
    return count;
}

PartMotion part_motion(const SurfaceField& field, uint32_t part)
{
    const uint8_t* const r = part_record(field, part);
    const uint8_t *const axis = r + part::kAxisAt, *const pivot = r + part::kPivotAt;
    const Motion motion = static_cast<Motion>(r[part::kMotionAt]);
    return {motion == Motion::slide,
            motion == Motion::turn_below_light,
            {load_s32(axis), load_s32(axis + 4), load_s32(axis + 8)},
            {load_s32(pivot), load_s32(pivot + 4), load_s32(pivot + 8)},
            load_s32(r + part::kFromAt),
            load_u32(r + part::kSpanAt)};
}

uint32_t first_patch_of_part(const SurfaceField& field, uint32_t part)
{
    return owner_ranges(field, part + 1).patches.begin;
}

PartName part_name(const SurfaceField& field, uint32_t part)
{
    const uint8_t* const text = part_record(field, part) + part::kNameAt;
    uint32_t bytes = 0;
    while (bytes < part::kNameBytes && text[bytes] != 0) ++bytes;
    return {reinterpret_cast<const char*>(text), bytes};
}

}  // namespace lumi
