// SPDX-License-Identifier: MIT
// Writes the frame list for fields that the emulator's loader put into memory, a slot each.
#include "frame_list.h"
#include "lumi/field_format.h"
#include "virt.h"

extern "C" const uint8_t lumi_fields[];  // the linker script defines it

namespace
{

constexpr uint32_t kSlotBytes = 1024 * 1024;

// Returns what the file's header states: it is opened next.
uint32_t stated_bytes(const uint8_t* file)
{
    const uint8_t* const at = file + lumi::detail::format::header::kFileBytesAt;
    return at[0] | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
           static_cast<uint32_t>(at[3]) << 24;
}

void write(const char* text)
{
    virt::call(virt::Operation::write_text, text);
}

}  // namespace

int main()
{
    lumi::firmware::FieldBytes fields[lumi::firmware::kListedFields];
    const uint8_t* at = lumi_fields;
    for (lumi::firmware::FieldBytes& bytes : fields) {
        bytes = {at, stated_bytes(at)};
        at += kSlotBytes;
    }
    return lumi::firmware::write_frame_crcs(fields, write) ? 0 : 1;
}
