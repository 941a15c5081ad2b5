// SPDX-License-Identifier: MIT
// Names the files that a bake finds and makes beside its output.
#pragma once

#include <filesystem>

#include "store/block_file.h"

namespace lumi::baker
{

// Where the checkpoint of an output lies. Throws BakeError where the output is a folder, FileClash where the output or
// a file that the bake makes beside it is an input.
std::filesystem::path checkpoint_of(const std::filesystem::path& output);

// Where the results of a surface bake's stages lie.
std::filesystem::path stages_of(const std::filesystem::path& output);

// Whether `output` is a shard of this very bake already, with all that has_all asks for. One that is damaged becomes
// the checkpoint, unless there is one.
bool is_finished_shard(const std::filesystem::path& output, const BakeIdentity& identity,
                       bool (*has_all)(BlockFile& file));

}  // namespace lumi::baker
