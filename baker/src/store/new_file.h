// SPDX-License-Identifier: MIT
// A file that appears under its name only when it is complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "store/posix_file.h"

namespace lumi::baker
{

class NewFile
{
public:
    // Creates `target` + ".new". Throws BakeError if that cannot be written, FileClash where either is an input.
    explicit NewFile(const std::filesystem::path& target);
    // Removes it unless it was committed.
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    // Each throws BakeError where the disk refuses.
    void append(const std::vector<uint8_t>& bytes);
    void overwrite(uint64_t offset, const std::vector<uint8_t>& bytes);
    // Everything is on the disk before the name is, so that a loss of power leaves the old file or the whole new one.
    void commit();

private:
    std::filesystem::path target_;
    PosixFile file_;
    uint64_t size_ = 0;
    bool committed_ = false;
};

}  // namespace lumi::baker
