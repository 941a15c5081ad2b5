// SPDX-License-Identifier: MIT
// lumi_frame_crcs RGB888 RGB565 PALETTE8 LUMA8 SURFACE SHEET: writes the frame list for six field files, as the host
// draws it.
#include "frame_list.h"

#include <cstdio>

#include "file_bytes.h"

namespace
{

constexpr uint32_t kFiles = lumi::firmware::kListedFields;
constexpr int kUsageExitCode = 64;  // EX_USAGE of sysexits.h

void write_text(const char* text)
{
    std::fputs(text, stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 1 + static_cast<int>(kFiles)) {
        std::fputs("usage: lumi_frame_crcs RGB888 RGB565 PALETTE8 LUMA8 SURFACE SHEET (field files)\n", stderr);
        return kUsageExitCode;
    }
    std::vector<uint8_t> files[kFiles];
    lumi::firmware::FieldBytes fields[kFiles];
    for (uint32_t i = 0; i < kFiles; ++i) {
        files[i] = lumi::test::file_bytes(argv[i + 1]);
        fields[i] = {files[i].data(), files[i].size()};
    }
    return lumi::firmware::write_frame_crcs(fields, write_text) ? 0 : 1;
}
