// SPDX-License-Identifier: MIT
// Reads and checks the section of light states.
#include "field/sections.h"
#include "lumi/surface/states.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;
using namespace detail::container;

bool is_zero(const uint8_t* bytes, uint32_t count)
{
    for (uint32_t k = 0; k < count; ++k)
        if (bytes[k] != 0) return false;
    return true;
}

uint32_t name_bytes(const uint8_t* record)
{
    uint32_t bytes = 0;
    while (bytes < state::kNameBytes && record[bytes] != 0) ++bytes;
    return bytes;
}

bool is_record(const uint8_t* record)
{
    const uint32_t bytes = name_bytes(record);
    return bytes != 0 && is_zero(record + bytes, state::kNameBytes - bytes) && record[state::kScaleAt] >= state::kOneQ4;
}

// Readers that do not know the section take any number of them.
uint32_t sections_of_states(const uint8_t* bytes)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < section_count(bytes); ++k)
        if (section_at(bytes, k).type == kStateSection) ++count;
    return count;
}

}  // namespace

FieldError detail::read_states(const uint8_t* bytes, SurfaceField& field)
{
    Section section{};
    if (!find_section(bytes, kStateSection, section)) return FieldError::none;
    if (sections_of_states(bytes) != 1) return FieldError::duplicate_section;
    const uint8_t* const at = bytes + section.offset;
    if (section.size < kStatesHeaderBytes) return FieldError::bad_states;
    const uint32_t count = at[0];
    const bool has_see_through = has_section(bytes, kSeeThroughSection);
    if (count < kMinStates || count > kMaxStates || at[1] >> count != 0 || !is_zero(at + 2, 2) ||
        section.size != states_bytes(count, has_see_through, field.viewed_count, field.code_bits))
        return FieldError::bad_states;
    for (uint32_t k = 0; k < count; ++k)
        if (!is_record(at + kStatesHeaderBytes + k * kStateBytes)) return FieldError::bad_states;
    field.states = at;
    field.state_count = static_cast<uint8_t>(count);
    field.has_states_of_see_through = has_see_through;
    return FieldError::none;
}

bool is_tint(const SurfaceField& field, uint32_t state)
{
    return (field.states[1] >> state & 1) != 0;
}

StateName state_name(const SurfaceField& field, uint32_t state)
{
    const uint8_t* const record = field.states + kStatesHeaderBytes + state * kStateBytes;
    return {reinterpret_cast<const char*>(record), name_bytes(record)};
}

}  // namespace lumi
