// SPDX-License-Identifier: MIT
// Bakes of both layouts have this in common.
//
// A bake keeps what is done in a checkpoint, the output's name + ".part". However it ends, the same call goes on from
// there, and the bytes of the field are those of a bake that was never stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace lumi::baker
{

// One of `count` parts that bake independently, 1 <= index <= count. Each shard bakes one of
// every `count` origins in a row, drawn by lot. So shards have equal size (to one row) and equal cost.
struct Shard {
    uint32_t index = 1, count = 1;
};

// Says what to do with a checkpoint, and with a shard file of the same bake, that lies there already.
enum class Earlier : uint8_t { resume, discard };

// Says what could not be baked or written; what() names the setting or the file and the mend.
struct BakeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The files that a bake makes beside `output` until it ends: its checkpoint, and files that are not whole yet. Throws
// BakeError where the output is a folder.
std::vector<std::filesystem::path> working_files_of(const std::filesystem::path& output);

}  // namespace lumi::baker
