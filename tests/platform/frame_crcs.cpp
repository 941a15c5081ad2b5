// SPDX-License-Identifier: MIT
// lumi_frame_crcs RGB888 RGB565 PALETTE8 LUMA8 GUIDED: writes the frame list for five field files, as the host draws
// it.
#include "frame_list.h"

#include <cstdio>
#include <cstring>

#include "lumi/host/mapped_file.h"

namespace
{

constexpr uint32_t kFiles = lumi::format::kTexelFormats + 1;
constexpr int kUsageExitCode = 64;  // EX_USAGE of sysexits.h

void write_text(const char* text)
{
    std::fputs(text, stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 1 + static_cast<int>(kFiles)) {
        std::fputs("usage: lumi_frame_crcs RGB888 RGB565 PALETTE8 LUMA8 GUIDED (field files)\n", stderr);
        return kUsageExitCode;
    }
    lumi::host::MappedFile files[kFiles];
    lumi::firmware::FieldBytes fields[lumi::format::kTexelFormats];
    for (uint32_t i = 0; i < kFiles; ++i) {
        if (const int error = files[i].open(argv[i + 1]); error != 0) {
            std::fprintf(stderr, "%s: %s\n", argv[i + 1], std::strerror(error));
            return 1;
        }
        if (i < lumi::format::kTexelFormats) fields[i] = {files[i].bytes(), files[i].size()};
    }
    const lumi::host::MappedFile& guided = files[lumi::format::kTexelFormats];
    return lumi::firmware::write_frame_crcs(fields, write_text) &&
                   lumi::firmware::write_guided_crcs({guided.bytes(), guided.size()}, write_text)
               ? 0
               : 1;
}
