// SPDX-License-Identifier: MIT
// A folder for the files that a fuzz target makes of its input, removed at the end. TMPDIR says where it lies.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace lumi::fuzz
{

class FuzzFolder
{
public:
    FuzzFolder() : path_(std::filesystem::temp_directory_path() / ("lumi-fuzz-" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(path_);
    }
    ~FuzzFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    FuzzFolder(const FuzzFolder&) = delete;
    FuzzFolder& operator=(const FuzzFolder&) = delete;

    std::filesystem::path write(const char* name, const std::string& bytes) const
    {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    std::filesystem::path at(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

}  // namespace lumi::fuzz
