// SPDX-License-Identifier: MIT
// The one way in which the tools write files: beside the target first, then renamed over it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lumi::tools
{

// How a file begins that embeds a field.
inline constexpr std::string_view kSourceMark = "/* Written by `lumi embed`.";

struct Output {
    std::string path;
    std::string_view bytes;
};

class PendingOutput;

// The outputs of a command that makes them one after the other. Each waits beside its target, under a name of its own,
// until take_places() renames them all: a command that stops before leaves every target as it was.
class OutputSet
{
public:
    OutputSet();
    ~OutputSet();  // removes what still waits
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    // Throws as write_output does.
    void add(const std::string& path, std::string_view bytes);

    // All or none, as far as a file system can. Throws Failure.
    void take_places();

private:
    std::vector<PendingOutput> files_;
    std::vector<std::pair<std::string, std::string>> streams_;  // devices and pipes, with their bytes
};

// Writes all or none, by an OutputSet.
void write_outputs(const std::vector<Output>& outputs);

// Replaces `path` by `bytes`, or throws and leaves what stood there: Failure, also where a field stands there, or a
// model or a program that lumi did not write; FileClash where `path` is a file that the command has read
// (lumi/baker/file_guard.h). A symbolic link is followed; devices and pipes are written straight to, since they hold no
// earlier output. Readers never see half a file.
void write_output(const std::string& path, std::string_view bytes);

// The file that a field or a shard replaces by a rename: `path`, or the target of a link. Announces it. Throws Failure
// for a folder, a device or a pipe, which a rename would destroy, and for other work under another ending than theirs;
// FileClash as announce_outputs does.
std::string field_target(const std::string& path);

// Throws Failure now if write_output(path, …) could not work later: worth asking before minutes of work.
void require_writable(const std::string& path);

// All that a command will write, before it reads anything; empty names are left out. Throws Failure where one is not
// writable, FileClash where two are one file. From then on it is an error to read one of them.
void announce_outputs(const std::vector<std::string>& paths);

// A new folder for temporary files; others can neither read it nor put a link in its place. Throws Failure.
std::filesystem::path new_temporary_folder(const std::string& mend);

}  // namespace lumi::tools
