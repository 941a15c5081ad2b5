// SPDX-License-Identifier: MIT
// Readers of chord and surface fields share the container of field_format.h: header, section table, sections.
#pragma once

#include "lumi/field.h"
#include "lumi/field_format.h"

namespace lumi::detail::container
{

inline uint32_t load_u16(const uint8_t* p)
{
    return static_cast<uint32_t>(p[0]) | static_cast<uint32_t>(p[1]) << 8;
}

inline uint32_t load_u32(const uint8_t* p)
{
    return load_u16(p) | load_u16(p + 2) << 16;
}

struct Section {
    uint32_t type, flags, offset, size, crc;
};

// Lists the section types that a reader understands.
struct KnownTypes {
    const uint32_t* types;
    uint32_t count;

    bool has(uint32_t type) const
    {
        for (uint32_t i = 0; i < count; ++i)
            if (types[i] == type) return true;
        return false;
    }
};

template <uint32_t Count>
constexpr KnownTypes known_types(const uint32_t (&types)[Count])
{
    return {types, Count};
}

// Checks the header and that the table is there, undamaged. Only then may the functions below be called.
FieldError check_table(const uint8_t* bytes, size_t size);

uint32_t section_count(const uint8_t* bytes);
Section section_at(const uint8_t* bytes, uint32_t index);

// Checks that every section lies inside the file, that nothing needed is unknown and that nothing known occurs twice.
FieldError check_sections(const uint8_t* bytes, KnownTypes known);

// Sets `out` where the type occurs first.
bool find_section(const uint8_t* bytes, uint32_t type, Section& out);
bool has_section(const uint8_t* bytes, uint32_t type);

// A sphere as both kinds of field store it: centre (3 × binary32), radius (binary32).
struct BoundsBits {
    uint32_t centre[3], radius;
};

// False unless the centre is finite and the radius finite and positive.
bool read_bounds(const uint8_t* centre, const uint8_t* radius, BoundsBits& out);

}  // namespace lumi::detail::container
