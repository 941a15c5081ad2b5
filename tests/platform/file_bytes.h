// SPDX-License-Identifier: MIT
// The bytes of a file; none where it cannot be read.
#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <vector>

namespace lumi::test
{

inline std::vector<uint8_t> file_bytes(const char* path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace lumi::test
