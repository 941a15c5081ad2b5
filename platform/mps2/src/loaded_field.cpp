// SPDX-License-Identifier: MIT
#include "lumi/mps2/loaded_field.h"

#include "lumi/field_format.h"

extern "C" const uint8_t lumi_psram_start[];  // the linker script defines it

namespace lumi::mps2
{
namespace
{

uint32_t read_u32(const uint8_t* at)
{
    return at[0] | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
           static_cast<uint32_t>(at[3]) << 24;
}

}  // namespace

LoadedField loaded_field(uint32_t offset)
{
    const uint8_t* bytes = lumi_psram_start + offset;
    const uint32_t available = kLoadedFieldMemoryBytes - offset;
    const uint32_t stated = read_u32(bytes + detail::format::header::kFileBytesAt);
    return {bytes, stated < available ? stated : available};
}

}  // namespace lumi::mps2
