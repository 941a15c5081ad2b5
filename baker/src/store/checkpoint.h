// SPDX-License-Identifier: MIT
// Keeps the finished part of a bake where neither the end of the process nor a loss of power loses them.
//
// Blocks are handed to the system at once, so that a killed process loses none; every kSyncInterval they are forced to
// the disk, so that a loss of power loses a few seconds and costs a few writes. The head is on the disk before the file
// has its name: a checkpoint with a damaged head is no remnant of an interruption, and is refused rather than
// overwritten.
#pragma once

#include <atomic>
#include <chrono>
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

inline constexpr std::chrono::seconds kSyncInterval(5);

// Removes the checkpoint of an output that no bake goes on with, unless a process has it.
void discard_checkpoint(const std::filesystem::path& output);

class Checkpoint
{
public:
    // Opens the checkpoint at `path`, or begins one. Holds its lock. Throws BakeError if it belongs to another bake or
    // is in use.
    Checkpoint(const std::filesystem::path& path, const BakeIdentity& identity, Earlier earlier);

    BlockFile& blocks() { return blocks_; }
    // Takes the disk space of `bytes`, the end of the last block, so that a full disk is told before the work. Where
    // that fails, a checkpoint that is_empty goes.
    void reserve(uint64_t bytes, bool is_empty);
    // To be called after each block that was written. Thread-safe.
    void sync_now_and_then();
    void sync() { blocks_.file().sync(); }
    void remove();
    // The complete checkpoint becomes the output itself.
    void rename_to(const std::filesystem::path& output);

private:
    using Clock = std::chrono::steady_clock;

    BlockFile blocks_;
    std::atomic<Clock::rep> next_sync_;
};

}  // namespace lumi::baker
