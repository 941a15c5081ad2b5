// SPDX-License-Identifier: MIT
// Writes the frame list for five fields that the loader put into PSRAM, kSlotBytes apart: four in the order of
// TexelFormat and a guided one.
#include "frame_list.h"
#include "lumi/mps2/loaded_field.h"
#include "lumi/mps2/semihosting.h"

namespace
{

constexpr uint32_t kSlotBytes = 1024 * 1024;

}  // namespace

int main(int, char**)
{
    lumi::firmware::FieldBytes fields[lumi::format::kTexelFormats];
    for (uint32_t i = 0; i < lumi::format::kTexelFormats; ++i) {
        const lumi::mps2::LoadedField field = lumi::mps2::loaded_field(i * kSlotBytes);
        fields[i] = {field.bytes, field.size};
    }
    if (!lumi::firmware::write_frame_crcs(fields, lumi::mps2::write)) return 1;
    const lumi::mps2::LoadedField guided = lumi::mps2::loaded_field(lumi::format::kTexelFormats * kSlotBytes);
    return lumi::firmware::write_guided_crcs({guided.bytes, guided.size}, lumi::mps2::write) ? 0 : 1;
}
