// SPDX-License-Identifier: MIT
// A folder for the files that a fuzz target makes of its input, removed at the end.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <map>
#include <string_view>

#include "support/scratch_folder.h"

namespace lumi::fuzz
{

class FuzzFolder : public baker::testing::ScratchFolder
{
public:
    // Leaves a file as it is that has these bytes already: most changes of an input of two files change one of them.
    const std::filesystem::path& write(const char* name, const std::string& bytes)
    {
        File& file = files_[name];
        if (file.path.empty()) file.path = path_ / name;
        if (!file.is_written || file.bytes != bytes) put(file, bytes);
        return file.path;
    }

private:
    struct File {
        std::filesystem::path path;
        std::string bytes;
        bool is_written = false;
    };

    static void put(File& file, const std::string& bytes)
    {
        const int descriptor = open(file.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        if (descriptor < 0 || ::write(descriptor, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
            std::abort();  // the disk is full
        close(descriptor);
        file.bytes = bytes;
        file.is_written = true;
    }

    std::map<std::string, File> files_;
};

// Whoever is refused is told how to mend it.
inline void check_message(const std::exception& refused)
{
    if (std::string_view(refused.what()).find("; ") != std::string_view::npos) return;
    std::fprintf(stderr, "a message without a mend: %s\n", refused.what());
    std::abort();
}

}  // namespace lumi::fuzz
