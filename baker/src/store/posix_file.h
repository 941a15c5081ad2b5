// SPDX-License-Identifier: MIT
// An open file that is read and written at offsets, and reaches the disk when told to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace lumi::baker
{

// Any number of threads may read and write different places of one file at once. Every failure is a BakeError that
// names the file and the mend.
class PosixFile
{
public:
    enum class Mode : uint8_t { read, update, create };  // update: also written; create: made if there is none

    PosixFile(std::filesystem::path path, Mode mode);
    ~PosixFile();
    PosixFile(const PosixFile&) = delete;
    PosixFile& operator=(const PosixFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    // The file keeps its identity when it gets another name; messages name the new one from then on.
    void rename_to(std::filesystem::path path);

    // False if another process holds the lock. It ends with this object or this process, however that ends.
    bool try_lock();
    // Whether `path` still leads to this file.
    bool is_at_its_path() const;

    uint64_t size() const;
    // The count of bytes read: fewer than `size` at the end of the file.
    size_t read_at(uint64_t offset, uint8_t* bytes, size_t size) const;
    void write_at(uint64_t offset, const uint8_t* bytes, size_t size);
    void cut(uint64_t size);
    // Takes the disk space for `size` bytes now, rather than failing for want of it later.
    void reserve(uint64_t size);
    // Returns when everything written so far would survive a loss of power.
    void sync();

private:
    [[noreturn]] void fail(const char* action) const;

    std::filesystem::path path_;
    int descriptor_;
};

// Makes a renaming in this folder survive a loss of power, where the file system can.
void sync_folder(const std::filesystem::path& folder);

}  // namespace lumi::baker
