// SPDX-License-Identifier: MIT
// The rows of a bake that are done, kept where neither the end of the process nor a loss of power loses them.
//
// Rows are handed to the system at once, so that a killed process loses none; every kSyncInterval they are forced to
// the disk, so that a loss of power loses a few seconds and costs a few writes. The head is on the disk before the file
// has its name: a checkpoint with a damaged head is no remnant of an interruption, and is refused rather than
// overwritten.
#pragma once

#include <atomic>
#include <chrono>
#include <vector>

#include "row_file.h"

namespace lumi::baker
{

inline constexpr std::chrono::seconds kSyncInterval(5);

class Checkpoint
{
public:
    // Opens the checkpoint at `path`, or begins one. Holds its lock. Throws BakeError if it belongs to another bake or
    // is in use.
    Checkpoint(const std::filesystem::path& path, const BakeIdentity& identity, Earlier earlier);

    RowFile& rows() { return rows_; }
    std::vector<uint32_t> missing_slots() const { return baker::missing_slots(rows_); }
    // Thread-safe for different slots.
    void store(uint32_t slot, const std::vector<uint8_t>& row);
    void sync() { rows_.file().sync(); }
    void remove();
    // The complete checkpoint becomes the output itself.
    void rename_to(const std::filesystem::path& output);

private:
    using Clock = std::chrono::steady_clock;

    void reserve();
    void sync_now_and_then();

    RowFile rows_;
    std::atomic<Clock::rep> next_sync_;
};

}  // namespace lumi::baker
