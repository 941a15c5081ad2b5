// SPDX-License-Identifier: MIT
#include "store/checkpoint.h"

#include "lumi/baker/file_guard.h"

namespace lumi::baker
{

namespace
{

namespace fs = std::filesystem;

enum class Finished : uint8_t { none, complete, damaged };

Finished find_finished(const fs::path& output, const BakeIdentity& identity, bool (*has_all)(BlockFile& file))
{
    std::error_code ignored;
    if (!fs::is_regular_file(output, ignored)) return Finished::none;
    try {
        BlockFile file(std::make_unique<PosixFile>(output, PosixFile::Mode::read));
        if (!difference(file.identity(), identity).empty() || file.identity().shard.index != identity.shard.index)
            return Finished::none;
        return has_all(file) ? Finished::complete : Finished::damaged;
    } catch (const BakeError&) {
        return Finished::none;  // anything else gets replaced, as any earlier output
    }
}

fs::path with_suffix(fs::path path, const char* suffix)
{
    path += suffix;
    return path;
}

}  // namespace

fs::path checkpoint_of(const fs::path& output)
{
    std::error_code ignored;
    if (fs::is_directory(output, ignored)) throw BakeError(output.string() + ": this is a folder; name a file in it");
    const fs::path part = with_suffix(output, ".part");
    for (const fs::path& file : {output, part, unfinished(output), unfinished(part), stages_of(output)})
        require_no_input(file);
    return part;
}

fs::path stages_of(const fs::path& output)
{
    return with_suffix(output, ".stages");
}

std::vector<fs::path> working_files_of(const fs::path& output)
{
    const fs::path part = checkpoint_of(output);
    return {part, unfinished(output), unfinished(part), stages_of(output)};
}

bool is_finished_shard(const fs::path& output, const BakeIdentity& identity, bool (*has_all)(BlockFile& file))
{
    const Finished finished = find_finished(output, identity, has_all);
    std::error_code ignored;
    const fs::path part = checkpoint_of(output);
    if (finished == Finished::damaged && !fs::exists(part, ignored)) fs::rename(output, part, ignored);
    return finished == Finished::complete;
}

namespace
{

namespace fs = std::filesystem;
using FilePointer = std::unique_ptr<PosixFile>;

constexpr int kTries = 8;  // another process may begin, finish or remove a checkpoint while this one looks

void require_lock(PosixFile& file)
{
    if (!file.try_lock()) {
        throw BakeError(file.path().string() +
                        ": another lumi is baking this; wait for its end, or choose another output");
    }
}

bool is_there(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(path, ignored);
}

// Locked; nothing if it vanished meanwhile.
FilePointer open_locked(const fs::path& path, PosixFile::Mode mode)
{
    auto file = std::make_unique<PosixFile>(path, mode);
    require_lock(*file);
    return file->is_at_its_path() ? std::move(file) : nullptr;
}

// The lock comes before the name, and stays with the file.
FilePointer begin(const fs::path& path, const BakeIdentity& identity)
{
    const fs::path unnamed = unfinished(path);
    require_no_input(unnamed);
    FilePointer file = open_locked(unnamed, PosixFile::Mode::create);
    if (!file) return nullptr;
    try {
        file->cut(0);
        const std::vector<uint8_t> head = encode_head(identity);
        file->write_at(0, head.data(), head.size());
        file->sync();
        file->rename_to(path);
    } catch (const BakeError&) {
        std::error_code ignored;
        fs::remove(unnamed, ignored);
        throw;
    }
    sync_folder(path.parent_path());
    return file;
}

FilePointer open_or_begin(const fs::path& path, const BakeIdentity& identity, Earlier earlier)
{
    require_no_input(path);
    for (int k = 0; k < kTries; ++k) {
        const bool there = is_there(path);
        FilePointer file = there ? open_locked(path, PosixFile::Mode::update) : begin(path, identity);
        if (file && there && earlier == Earlier::discard) {
            fs::remove(path);
            earlier = Earlier::resume;
        } else if (file) {
            return file;
        }
    }
    throw BakeError(path.string() + ": comes and goes; make sure that only one lumi bakes this output");
}

void require_same(const fs::path& path, const BakeIdentity& there, const BakeIdentity& here)
{
    std::string text = difference(there, here);
    if (text.empty() && there.shard.index != here.shard.index) text = "another shard";
    if (!text.empty()) {
        throw BakeError(path.string() + ": holds the finished rows of another bake (" + text +
                        "); finish that one with its own options, or discard it with --restart");
    }
}

}  // namespace

void discard_checkpoint(const fs::path& output)
{
    const fs::path path = with_suffix(output, ".part");
    if (!is_there(path)) return;
    try {
        require_no_input(path);
        PosixFile file(path, PosixFile::Mode::update);
        if (file.try_lock()) fs::remove(path);
    } catch (const std::runtime_error&) {
        return;  // it is no harm where it stays
    }
}

Checkpoint::Checkpoint(const fs::path& path, const BakeIdentity& identity, Earlier earlier)
    : blocks_(open_or_begin(path, identity, earlier)),
      next_sync_((Clock::now() + kSyncInterval).time_since_epoch().count())
{
    require_same(path, blocks_.identity(), identity);
}

// A checkpoint without results would only be in the way of a smaller bake.
void Checkpoint::reserve(uint64_t bytes, bool is_empty)
{
    try {
        blocks_.file().reserve(bytes);
    } catch (const BakeError&) {
        if (is_empty) remove();
        throw;
    }
    // The surplus of a damaged file goes.
    if (blocks_.file().size() > bytes) blocks_.file().cut(bytes);
}

// By whichever thread comes first after the interval; the others go on.
void Checkpoint::sync_now_and_then()
{
    const Clock::time_point now = Clock::now();
    Clock::rep due = next_sync_;
    if (now.time_since_epoch().count() >= due &&
        next_sync_.compare_exchange_strong(due, (now + kSyncInterval).time_since_epoch().count()))
        sync();
}

void Checkpoint::remove()
{
    std::error_code ignored;
    fs::remove(blocks_.path(), ignored);
}

void Checkpoint::rename_to(const fs::path& output)
{
    sync();
    require_no_input(output);
    blocks_.file().rename_to(output);
    sync_folder(output.parent_path());
}

}  // namespace lumi::baker
