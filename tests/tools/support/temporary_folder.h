// SPDX-License-Identifier: MIT
// A folder of its own for each test, gone afterwards, whose files are named by texts.
#pragma once

#include <string_view>

#include "../../baker/support/scratch_folder.h"

namespace lumi::tools::test
{

class TemporaryFolder : public baker::testing::ScratchFolder
{
public:
    std::string operator/(const std::string& name) const { return at(name).string(); }
    std::string path() const { return path_.string(); }
    size_t entries() const { return file_count(); }
};

inline std::string content_of(const std::string& path)
{
    return baker::testing::read_bytes(path);
}

inline void write_content(const std::string& path, std::string_view bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace lumi::tools::test
