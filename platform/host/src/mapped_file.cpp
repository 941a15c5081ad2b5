// SPDX-License-Identifier: MIT
#include "lumi/host/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace lumi::host
{

namespace
{

// Maps the open file; returns 0 or an errno.
int map(int descriptor, const uint8_t*& bytes, size_t& size)
{
    struct stat status = {};
    if (fstat(descriptor, &status) != 0) return errno;
    if (S_ISDIR(status.st_mode)) return EISDIR;
    if (!S_ISREG(status.st_mode)) return ENODEV;
    size = static_cast<size_t>(status.st_size);
    if (size == 0) return 0;
    void* address = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (address == MAP_FAILED) return errno;
    bytes = static_cast<const uint8_t*>(address);
    return 0;
}

}  // namespace

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, nullptr)), size_(std::exchange(other.size_, 0))
{
}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept
{
    std::swap(bytes_, other.bytes_);
    std::swap(size_, other.size_);
    return *this;
}

int MappedFile::open(const std::string& path)
{
    close();
    const int descriptor =
        ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);  // a pipe is refused, not waited for
    if (descriptor < 0) return errno;
    const int error = map(descriptor, bytes_, size_);
    ::close(descriptor);  // the mapping outlives the descriptor
    if (error != 0) size_ = 0;
    return error;
}

void MappedFile::close()
{
    if (bytes_ != nullptr) munmap(const_cast<uint8_t*>(bytes_), size_);
    bytes_ = nullptr;
    size_ = 0;
}

}  // namespace lumi::host
