// SPDX-License-Identifier: MIT
// Writes the frame list for fields that the loader put into PSRAM, kSlotBytes apart.
#include "frame_list.h"
#include "lumi/mps2/board.h"

namespace
{

constexpr uint32_t kSlotBytes = 1024 * 1024;

}  // namespace

int main(int, char**)
{
    lumi::firmware::FieldBytes fields[lumi::firmware::kListedFields];
    uint32_t at = 0;
    for (lumi::firmware::FieldBytes& bytes : fields) {
        const lumi::mps2::LoadedField field = lumi::mps2::loaded_field(at);
        bytes = {field.bytes, field.size};
        at += kSlotBytes;
    }
    return lumi::firmware::write_frame_crcs(fields, lumi::mps2::write) ? 0 : 1;
}
