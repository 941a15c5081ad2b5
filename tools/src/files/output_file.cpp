// SPDX-License-Identifier: MIT
#include "files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error)
{
    const char* mend = "check the path and its permissions";
    if (error == ENOENT || error == ENOTDIR)
        mend = "create its folder first or choose another path";
    else if (error == EISDIR)
        mend = "name a file, not a folder";
    else if (error == ENOSPC)
        mend = "free some space on that disk";
    throw Failure(path, std::string("cannot be written (") + std::strerror(error) + ")", mend);
}

// Where the bytes end up: the target of a link, so that the link itself survives.
fs::path resolved(const std::string& path)
{
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : target;
}

bool holds_earlier_output(const fs::path& path)
{
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) return true;
    if (S_ISDIR(status.st_mode)) fail(path.string(), EISDIR);
    return S_ISREG(status.st_mode);
}

// Returns 0 or an errno.
int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return errno;
        bytes.remove_prefix(count > 0 ? static_cast<size_t>(count) : 0);
    }
    return 0;
}

void write_straight(const std::string& path, std::string_view bytes)
{
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path, errno);
    const int error = write_all(descriptor, bytes);
    close(descriptor);
    if (error != 0) fail(path, error);
}

// A new file beside `target`, with the permissions that a plain new file would have.
std::string create_beside(const fs::path& target, int& descriptor)
{
    constexpr mode_t kPlainFile = 0666;
    std::string name = target.string() + ".part-XXXXXX";
    descriptor = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0) fail(target.string(), errno);
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, kPlainFile & ~mask);
    return name;
}

}  // namespace

void write_output(const std::string& path, std::string_view bytes)
{
    baker::require_no_input(path);
    const fs::path target = resolved(path);
    if (!holds_earlier_output(target)) return write_straight(path, bytes);
    int descriptor = -1;
    const std::string temporary = create_beside(target, descriptor);
    int error = write_all(descriptor, bytes);
    if (close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) {
        unlink(temporary.c_str());
        fail(path, error);
    }
}

std::string regular_target(const std::string& path)
{
    const fs::path target = resolved(path);
    if (!holds_earlier_output(target)) throw Failure(path, "is a device or a pipe", "name a file");
    return target.string();
}

void require_writable(const std::string& path)
{
    const fs::path target = resolved(path);
    if (!holds_earlier_output(target)) return;
    int descriptor = -1;
    const std::string temporary = create_beside(target, descriptor);
    close(descriptor);
    unlink(temporary.c_str());
}

void announce_outputs(const std::vector<std::string>& paths)
{
    std::vector<fs::path> files;
    for (const std::string& path : paths)
        if (!path.empty()) files.emplace_back(path);
    baker::announce_outputs(files);
    for (const fs::path& file : files) require_writable(file.string());
}

}  // namespace lumi::tools
