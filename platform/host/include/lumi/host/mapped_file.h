// SPDX-License-Identifier: MIT
// A file mapped read-only into memory: on a host, what flash is to firmware.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace lumi::host
{

// Owns the mapping: bytes() is valid until close() or the end of its life, for a file that nobody shortens meanwhile.
// Movable, not copyable.
class MappedFile
{
public:
    MappedFile() = default;
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile() { close(); }

    // Maps `path`, a regular file. Returns 0, or the errno of what failed; then nothing is mapped.
    // An empty file maps to no bytes.
    [[nodiscard]] int open(const std::string& path);
    void close();

    const uint8_t* bytes() const { return bytes_; }
    size_t size() const { return size_; }

private:
    const uint8_t* bytes_ = nullptr;
    size_t size_ = 0;
};

}  // namespace lumi::host
