// SPDX-License-Identifier: MIT
// Keeps a command from destroying what it reads, and from writing two outputs to one file.
//
// While a FileGuard lives, all that read a file of the user's note it here, and all that write one ask here; without a
// guard the functions do nothing. Two names are one file if they lead to the same device and inode, through symbolic
// links or hard ones. Devices, pipes and folders hold nothing that an output could destroy: they never clash.
// The files that a bake leaves for itself (an earlier output, a shard, a checkpoint) are no inputs of it.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace lumi::baker
{

// An output that would replace an input or another output; what() names the file and the mend.
struct FileClash : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Where a name leads through links, also if nothing lies there yet. A link that leads nowhere, since it leads to
// itself, stays a link.
std::filesystem::path followed(std::filesystem::path file);

// Whether a file has a new name now. NFS repeats a rename whose answer was lost, and then says that there is no such
// file. Sets errno.
bool has_renamed(const std::filesystem::path& from, const std::filesystem::path& to);

// A command's book of files. An inner guard shares the book of the outer one, which is emptied with the last of them.
// The book belongs to the process; any thread may read and write files meanwhile.
class FileGuard
{
public:
    FileGuard();
    ~FileGuard();
    FileGuard(const FileGuard&) = delete;
    FileGuard& operator=(const FileGuard&) = delete;
};

// Call as early as the names are known, once for each output. Throws FileClash if a file has been noted as an input or
// announced as another output.
void announce_outputs(const std::vector<std::filesystem::path>& files);

// Call before a file is read. Throws FileClash if it is an announced output.
void note_input(const std::filesystem::path& file);

// Call before a file is created, cut or renamed over. Throws FileClash if it is an input.
void require_no_input(const std::filesystem::path& file);

}  // namespace lumi::baker
