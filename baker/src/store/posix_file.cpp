// SPDX-License-Identifier: MIT
#include "store/posix_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "lumi/baker/bake.h"
#include "lumi/baker/file_guard.h"

namespace lumi::baker
{

namespace
{

constexpr mode_t kPlainFile = 0666;  // less the umask

const char* mend_of(int error)
{
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "free some space on that disk";
        case EFBIG:
            return "raise the limit (ulimit -f), or use a file system for large files";
        case ENOENT:
        case ENOTDIR:
            return "create its folder first or choose another path";
        case EISDIR:
            return "name a file, not a folder";
        case EIO:
            return "check the disk";
        default:
            return "check the path and its permissions";
    }
}

int open_flags(PosixFile::Mode mode)
{
    switch (mode) {
        case PosixFile::Mode::read:
            return O_RDONLY | O_NONBLOCK | O_CLOEXEC;  // nobody waits for a pipe
        case PosixFile::Mode::update:
            return O_RDWR | O_NONBLOCK | O_CLOEXEC;
        case PosixFile::Mode::create:
            return O_RDWR | O_NONBLOCK | O_CREAT | O_CLOEXEC;
    }
    return O_RDONLY;
}

}  // namespace

PosixFile::PosixFile(std::filesystem::path path, Mode mode)
    : path_(std::move(path)), descriptor_(open(path_.c_str(), open_flags(mode), kPlainFile))
{
    if (descriptor_ < 0) fail(mode == Mode::create ? "created" : "opened");
}

PosixFile::~PosixFile()
{
    close(descriptor_);
}

void PosixFile::fail(const char* action) const
{
    const int error = errno;
    throw BakeError(path_.string() + ": cannot be " + action + " (" + std::strerror(error) + "); " + mend_of(error));
}

void PosixFile::rename_to(std::filesystem::path path)
{
    if (!has_renamed(path_, path)) fail("renamed");
    path_ = std::move(path);
}

bool PosixFile::try_lock()
{
    // A file system without locks (ENOLCK, EOPNOTSUPP) is no reason to refuse work: two bakes of the same field write
    // the same bytes.
    return flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

bool PosixFile::is_at_its_path() const
{
    struct stat here = {}, there = {};
    return fstat(descriptor_, &here) == 0 && stat(path_.c_str(), &there) == 0 && here.st_ino == there.st_ino &&
           here.st_dev == there.st_dev;
}

uint64_t PosixFile::size() const
{
    struct stat status = {};
    if (fstat(descriptor_, &status) != 0) fail("read");
    return static_cast<uint64_t>(status.st_size);
}

size_t PosixFile::read_at(uint64_t offset, uint8_t* bytes, size_t size) const
{
    size_t done = 0;
    while (done < size) {
        const ssize_t count = pread(descriptor_, bytes + done, size - done, static_cast<off_t>(offset + done));
        if (count < 0 && errno != EINTR) fail("read");
        if (count == 0) break;
        done += count > 0 ? static_cast<size_t>(count) : 0;
    }
    return done;
}

void PosixFile::write_at(uint64_t offset, const uint8_t* bytes, size_t size)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t count = pwrite(descriptor_, bytes + done, size - done, static_cast<off_t>(offset + done));
        if (count == 0) errno = EIO;  // else a file system that takes nothing is asked for ever
        if (count == 0 || (count < 0 && errno != EINTR)) fail("written");
        done += count > 0 ? static_cast<size_t>(count) : 0;
    }
}

void PosixFile::cut(uint64_t size)
{
    if (ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail("written");
}

void PosixFile::reserve(uint64_t size)
{
    const int error = posix_fallocate(descriptor_, 0, static_cast<off_t>(size));
    if (error == EINVAL || error == EOPNOTSUPP) return;  // this file system cannot promise space
    if (error != 0) {
        errno = error;
        fail("written");
    }
}

void PosixFile::sync()
{
    // EINVAL, EROFS: a file system that has no such notion.
    if (fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail("written");
}

void sync_folder(const std::filesystem::path& folder)
{
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        fsync(descriptor);
        close(descriptor);
    }
}

namespace
{

std::filesystem::path beside(const std::filesystem::path& target)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(target, ignored))
        throw BakeError(target.string() + ": this is a folder; name a file in it");
    std::filesystem::path name = unfinished(target);
    require_no_input(target);
    require_no_input(name);
    return name;
}

}  // namespace

std::filesystem::path unfinished(const std::filesystem::path& file)
{
    std::filesystem::path name = file;
    name += ".new";
    return name;
}

NewFile::NewFile(const std::filesystem::path& target) : target_(target), file_(beside(target), PosixFile::Mode::create)
{
    file_.cut(0);
}

NewFile::~NewFile()
{
    if (!committed_) {
        std::error_code ignored;
        std::filesystem::remove(file_.path(), ignored);
    }
}

void NewFile::append(const std::vector<uint8_t>& bytes)
{
    overwrite(size_, bytes);
    size_ += bytes.size();
}

void NewFile::overwrite(uint64_t offset, const std::vector<uint8_t>& bytes)
{
    file_.write_at(offset, bytes.data(), bytes.size());
}

void NewFile::commit()
{
    file_.sync();
    require_no_input(target_);
    const std::filesystem::path folder = target_.parent_path();  // nothing that may fail comes behind the renaming
    file_.rename_to(target_);
    committed_ = true;
    sync_folder(folder);
}

}  // namespace lumi::baker
