// SPDX-License-Identifier: MIT
// An open file that is read and written at offsets, and reaches the disk when told to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

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

// A file that appears under its name only when it is complete.

// Where a file lies until it is whole.
std::filesystem::path unfinished(const std::filesystem::path& file);

class NewFile
{
public:
    // Creates `target` + ".new". Throws BakeError if that cannot be written, FileClash where either is an input.
    explicit NewFile(const std::filesystem::path& target);
    // Removes it unless it was committed.
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    // Each throws BakeError where the disk refuses.
    void append(const std::vector<uint8_t>& bytes);
    void overwrite(uint64_t offset, const std::vector<uint8_t>& bytes);
    // Everything is on the disk before the name is, so that a loss of power leaves the old file or the whole new one.
    void commit();

private:
    std::filesystem::path target_;
    PosixFile file_;
    uint64_t size_ = 0;
    bool committed_ = false;
};

}  // namespace lumi::baker
