// SPDX-License-Identifier: MIT
// A file that appears under its name only when it is complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace lumi::baker
{

class PartFile
{
public:
    // Creates `target` + ".part". Throws BakeError if that cannot be written.
    explicit PartFile(const std::filesystem::path& target);
    // Removes the part unless it was committed.
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    // Each throws BakeError where the disk refuses.
    void write(const std::vector<uint8_t>& bytes);
    void commit();

private:
    std::filesystem::path target_, part_;
    std::ofstream stream_;
    bool committed_ = false;
};

}  // namespace lumi::baker
