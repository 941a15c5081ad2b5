// SPDX-License-Identifier: MIT
// Which vertices and opaque patches belong to the body of a field and which to its moving parts.
#pragma once

#include "field/sections.h"
#include "lumi/surface/field.h"

namespace lumi::detail
{

struct NumberRange {
    uint32_t begin, end;

    bool has(uint32_t k) const { return k >= begin && k < end; }
};

struct OwnerRanges {
    NumberRange viewed, plain, patches;

    bool has_vertex(uint32_t k) const { return viewed.has(k) || plain.has(k); }
};

inline const uint8_t* part_record(const SurfaceField& field, uint32_t part)
{
    return field.parts + part * format::kPartBytes;
}

// 0 for a part that moves by itself, k for a shadow of part k - 1.
inline uint32_t followed(const SurfaceField& field, uint32_t part)
{
    return part_record(field, part)[format::part::kFollowsAt];
}

// Owner 0 is the body, owner k is part k - 1.
inline OwnerRanges owner_ranges(const SurfaceField& field, uint32_t owner)
{
    using container::load_u16;
    OwnerRanges r = {{0, field.viewed_count}, {field.viewed_count, field.vertex_count}, {0, field.patch_count}};
    if (owner != 0) {
        const uint8_t* const own = part_record(field, owner - 1);
        r.viewed.begin = load_u16(own + format::part::kFirstViewedAt);
        r.plain.begin = load_u16(own + format::part::kFirstPlainAt);
        r.patches.begin = load_u16(own + format::part::kFirstPatchAt);
    }
    if (owner != field.part_count) {
        const uint8_t* const next = part_record(field, owner);
        r.viewed.end = load_u16(next + format::part::kFirstViewedAt);
        r.plain.end = load_u16(next + format::part::kFirstPlainAt);
        r.patches.end = load_u16(next + format::part::kFirstPatchAt);
    }
    return r;
}

}  // namespace lumi::detail
