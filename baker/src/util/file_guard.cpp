// SPDX-License-Identifier: MIT
#include "lumi/baker/file_guard.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;

// A file, by its inode and an empty name; or the place of one, by its folder's inode and its name there. The place is
// what a file keeps when a rename replaces it.
using FileId = std::tuple<dev_t, ino_t, std::string>;
using Book = std::map<FileId, fs::path>;

struct Books {
    std::mutex mutex;
    int guards = 0;
    Book inputs, outputs;
};

Books& books()
{
    static Books all;
    return all;
}

// None for what no output could destroy.
std::vector<FileId> ids_of(const fs::path& file)
{
    struct stat status = {};
    std::vector<FileId> ids;
    if (stat(file.c_str(), &status) == 0) {
        if (!S_ISREG(status.st_mode)) return {};
        ids.emplace_back(status.st_dev, status.st_ino, "");
    }
    const fs::path place = followed(file);
    if (stat(place.parent_path().c_str(), &status) == 0)
        ids.emplace_back(status.st_dev, status.st_ino, place.filename().string());
    return ids;
}

bool is_regular(const fs::path& file)
{
    std::error_code ignored;
    return fs::is_regular_file(file, ignored);
}

// The name under which the book holds the file, or nothing. An inode may have been used again since it was noted, so
// that the name must still lead to it.
const fs::path* find(const Book& book, const std::vector<FileId>& ids)
{
    for (const FileId& id : ids) {
        const auto found = book.find(id);
        if (found == book.end()) continue;
        const std::vector<FileId> now = ids_of(found->second);
        if (std::find(now.begin(), now.end(), id) != now.end()) return &found->second;
    }
    return nullptr;
}

void enter(Book& book, const std::vector<FileId>& ids, const fs::path& file)
{
    for (const FileId& id : ids) book.insert_or_assign(id, file);
}

[[noreturn]] void refuse_input(const fs::path& output, const fs::path& input)
{
    const std::string what = output == input ? "this command reads this file and would overwrite it"
                                             : "leads to the same file as " + input.string() +
                                                   ", which this command reads and would overwrite";
    throw FileClash(output.string() + ": " + what + "; choose another name for the output");
}

[[noreturn]] void refuse_twin(const fs::path& output, const fs::path& other)
{
    const std::string what = output == other
                                 ? "this command would write two outputs to this file"
                                 : "leads to the same file as " + other.string() + ", another output of this command";
    throw FileClash(output.string() + ": " + what + "; give each output a name of its own");
}

void announce(Books& all, const fs::path& file)
{
    const std::vector<FileId> ids = ids_of(file);
    if (const fs::path* input = find(all.inputs, ids)) refuse_input(file, *input);
    if (const fs::path* other = find(all.outputs, ids)) refuse_twin(file, *other);
    enter(all.outputs, ids, file);
}

}  // namespace

fs::path followed(fs::path file)
{
    constexpr int kMaxLinks = 40;  // as many as Linux follows
    std::error_code failed;
    for (int k = 0; k < kMaxLinks && fs::is_symlink(file, failed); ++k) {
        const fs::path link = fs::read_symlink(file, failed);
        file = file.parent_path() / link;
    }
    const fs::path place = fs::weakly_canonical(fs::absolute(file, failed), failed);
    return failed ? file : place;
}

bool has_renamed(const fs::path& from, const fs::path& to)
{
    struct stat before = {}, after = {};
    const bool was_there = stat(from.c_str(), &before) == 0;
    if (std::rename(from.c_str(), to.c_str()) == 0) return true;
    const int error = errno;
    const bool is_there = was_there && error == ENOENT && stat(to.c_str(), &after) == 0 &&
                          before.st_ino == after.st_ino && before.st_dev == after.st_dev;
    errno = error;
    return is_there;
}

FileGuard::FileGuard()
{
    const std::lock_guard<std::mutex> lock(books().mutex);
    ++books().guards;
}

FileGuard::~FileGuard()
{
    const std::lock_guard<std::mutex> lock(books().mutex);
    if (--books().guards == 0) {
        books().inputs.clear();
        books().outputs.clear();
    }
}

void announce_outputs(const std::vector<fs::path>& files)
{
    Books& all = books();
    const std::lock_guard<std::mutex> lock(all.mutex);
    for (const fs::path& file : files)
        if (all.guards != 0) announce(all, file);
}

void note_input(const fs::path& file)
{
    Books& all = books();
    const std::lock_guard<std::mutex> lock(all.mutex);
    if (all.guards == 0 || !is_regular(file)) return;
    const std::vector<FileId> ids = ids_of(file);
    if (const fs::path* output = find(all.outputs, ids)) refuse_input(*output, file);
    enter(all.inputs, ids, file);
}

void require_no_input(const fs::path& file)
{
    Books& all = books();
    const std::lock_guard<std::mutex> lock(all.mutex);
    if (all.guards == 0) return;
    if (const fs::path* input = find(all.inputs, ids_of(file))) refuse_input(file, *input);
}

}  // namespace lumi::baker
