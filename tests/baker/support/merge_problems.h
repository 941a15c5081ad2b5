// SPDX-License-Identifier: MIT
// What merging shards says of them, the same for every layout.
#pragma once

#include <catch2/catch.hpp>

#include "lumi/baker/merge.h"
#include "support/scratch_folder.h"

namespace lumi::baker::testing
{

using Paths = std::vector<std::filesystem::path>;

// What merging says; the output must then be as before.
inline std::vector<std::string> problems_of(const ScratchFolder& folder, const Paths& shards)
{
    folder.write("f.lumi", "earlier");
    try {
        merge_shards(shards, folder.at("f.lumi"));
    } catch (const MergeError& error) {
        CHECK(read_bytes(folder.at("f.lumi")) == "earlier");
        return error.problems;
    }
    return {};
}

}  // namespace lumi::baker::testing
