// SPDX-License-Identifier: MIT
#include "files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "lumi/baker/file_guard.h"
#include "lumi/field_format.h"
#include "terminal/failure.h"
#include "terminal/text.h"

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
    else if (error == ELOOP)
        mend = "remove that link or choose another path";
    else if (error == EFBIG)
        mend = "raise `ulimit -f`";
    else if (error == ENOSPC || error == EDQUOT)
        mend = "free some space on that disk";
    else if (error == EIO)
        mend = "check the disk";
    throw Failure(path, std::string("cannot be written (") + std::strerror(error) + ")", mend);
}

// Where the bytes end up: the target of a link, so that the link itself survives. A pipe that /dev/stdout leads to has
// no path of its own.
fs::path resolved(const std::string& path)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::is_symlink(path, ignored) || (fs::exists(status) && !fs::is_regular_file(status))) return path;
    return baker::followed(path);
}

const std::string_view kFieldMark(reinterpret_cast<const char*>(detail::format::kMagic), sizeof detail::format::kMagic);

// How files begin that lumi writes under endings of other work: fields, programs, models, scenes and their parts;
// nothing: it writes none. Fields and shards have their own way to disk (field_target).
struct OtherWork {
    std::string_view ending, mark;
};
const OtherWork kOtherWork[] = {{".obj", ""},         {".json", "{\n  \"budget_bytes\""},  // a plan
                                {".bin", kFieldMark}, {".s", kSourceMark},
                                {".c", kSourceMark},  {".cpp", kSourceMark},
                                {".lumi", ""},        {".shard", ""},
                                {".mtl", ""},         {".gltf", ""},
                                {".glb", ""},         {".stl", ""},
                                {".ply", ""},         {".nii", ""},
                                {".gz", ""},          {".vdb", ""},
                                {".hdr", ""},         {".jpg", ""},
                                {".jpeg", ""}};

// A mistyped output must not cost anybody's work. An empty file holds none.
void require_begin(const fs::path& path, const std::string& name, std::string_view mark)
{
    std::string begin(std::max<size_t>(1, mark.size()), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<size_t>(file.gcount()));
    if (!begin.empty() && (mark.empty() || begin != mark))
        throw Failure(name, "this holds other work, which the output would replace",
                      "choose another name for the output");
}

void require_no_other_work(const fs::path& path, const std::string& name)
{
    const std::string ending = small_ending(path.string());
    for (const OtherWork& other : kOtherWork)
        if (ending == other.ending) require_begin(path, name, other.mark);
}

// Whether a file is there or may be made, which an output may replace; no device and no pipe.
bool is_file(const fs::path& path)
{
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) {
        if (errno == ELOOP) fail(path.string(), ELOOP);
        return true;
    }
    if (S_ISDIR(status.st_mode)) fail(path.string(), EISDIR);
    return S_ISREG(status.st_mode);
}

// Whether an output may take the place of what is there; `name` leads to `path`.
bool holds_earlier_output(const fs::path& path, const std::string& name)
{
    if (!is_file(path)) return false;
    require_no_other_work(path, name);
    return true;
}

// Returns 0 or an errno.
int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return errno;
        if (count == 0) return EIO;  // else a file system that takes nothing is asked for ever
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

// A file that waits beside its target.
class PendingOutput
{
public:
    PendingOutput(const std::string& path, std::string_view bytes) : path_(path), target_(resolved(path))
    {
        int descriptor = -1;
        temporary_ = create_beside(target_, descriptor);
        int error = write_all(descriptor, bytes);
        if (close(descriptor) != 0 && error == 0) error = errno;
        if (error == 0) return;
        unlink(temporary_.c_str());
        fail(path_, error);
    }
    PendingOutput(PendingOutput&& other) noexcept = default;
    ~PendingOutput()
    {
        if (!temporary_.empty()) unlink(temporary_.c_str());
        if (!earlier_.empty()) unlink(earlier_.c_str());
    }

    // Takes the target's place. The earlier file stays within reach where the file system knows hard links.
    void take_place()
    {
        const std::string earlier = temporary_ + "~";
        if (link(target_.c_str(), earlier.c_str()) == 0) earlier_ = earlier;
        if (!baker::has_renamed(temporary_, target_)) fail(path_, errno);
        temporary_.clear();
    }
    void give_back()
    {
        if (!temporary_.empty()) return;
        if (earlier_.empty())
            unlink(target_.c_str());
        else if (rename(earlier_.c_str(), target_.c_str()) == 0)
            earlier_.clear();
    }

private:
    std::string path_;
    fs::path target_;
    std::string temporary_, earlier_;
};

OutputSet::OutputSet() = default;
OutputSet::~OutputSet() = default;

void OutputSet::add(const std::string& path, std::string_view bytes)
{
    baker::require_no_input(path);
    if (holds_earlier_output(resolved(path), path))
        files_.emplace_back(path, bytes);
    else
        streams_.emplace_back(path, bytes);
}

void OutputSet::take_places()
{
    for (const auto& [path, bytes] : streams_) write_straight(path, bytes);
    try {
        for (PendingOutput& file : files_) file.take_place();
    } catch (...) {
        for (PendingOutput& file : files_) file.give_back();
        throw;
    }
    streams_.clear();
    files_.clear();
}

void write_outputs(const std::vector<Output>& outputs)
{
    OutputSet set;
    for (const Output& output : outputs) set.add(output.path, output.bytes);
    set.take_places();
}

void write_output(const std::string& path, std::string_view bytes)
{
    write_outputs({{path, bytes}});
}

namespace
{

void try_beside(const fs::path& target)
{
    int descriptor = -1;
    const std::string temporary = create_beside(target, descriptor);
    close(descriptor);
    unlink(temporary.c_str());
}

}  // namespace

std::string field_target(const std::string& path)
{
    const fs::path target = resolved(path);
    if (!is_file(target)) throw Failure(path, "is a device or a pipe", "name a file");
    const std::string ending = small_ending(target.string());
    if (ending != ".lumi" && ending != ".shard") require_begin(target, path, kFieldMark);
    baker::announce_outputs({path});
    try_beside(target);
    return target.string();
}

void require_writable(const std::string& path)
{
    const fs::path target = resolved(path);
    if (holds_earlier_output(target, path)) try_beside(target);
}

void announce_outputs(const std::vector<std::string>& paths)
{
    std::vector<fs::path> files;
    for (const std::string& path : paths)
        if (!path.empty()) files.emplace_back(path);
    baker::announce_outputs(files);
    for (const fs::path& file : files) require_writable(file.string());
}

std::filesystem::path new_temporary_folder(const std::string& mend)
{
    const char* const named = std::getenv("TMPDIR");  // an empty one is none, as for mktemp(1)
    const fs::path parent = named == nullptr || *named == 0 ? "/tmp" : named;
    std::error_code ignored;
    if (!fs::is_directory(parent, ignored)) throw Failure(parent.string(), "is no folder for temporary files", mend);
    std::string pattern = (parent / "lumi-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        throw Failure(parent.string(), std::string("takes no temporary folder (") + std::strerror(errno) + ")", mend);
    return pattern;
}

}  // namespace lumi::tools
