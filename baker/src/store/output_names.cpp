// SPDX-License-Identifier: MIT
#include "store/output_names.h"

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

}  // namespace lumi::baker
