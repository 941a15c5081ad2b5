// SPDX-License-Identifier: MIT
#include "store/shard_set.h"

#include <algorithm>

#include "lumi/baker/file_guard.h"
#include "lumi/baker/merge.h"
#include "lumi/detail/lattice.h"
#include "util/text_lines.h"

namespace lumi::baker
{

namespace
{

// A fixed lot for each round: the top bits of a multiplicative hash, scaled to 0 .. shards - 1.
uint32_t turn(uint32_t round, uint32_t shards)
{
    uint32_t h = (round + 1) * 0x9E3779B9u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h ^= h >> 13;
    return static_cast<uint32_t>(static_cast<uint64_t>(h) * shards >> 32);
}

}  // namespace

void check_shard(const Shard& shard)
{
    if (shard.count < 1 || shard.count > detail::kMaxLatticeSize || shard.index < 1 || shard.index > shard.count) {
        throw BakeError("there is no shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count) +
                        "; shards are counted from 1");
    }
}

uint32_t ShardRows::index_of(uint32_t row, uint32_t shards)
{
    return (row % shards + turn(row / shards, shards)) % shards + 1;
}

uint32_t ShardRows::row(uint32_t slot) const
{
    const uint32_t n = shard_.count;
    return slot * n + (shard_.index - 1 + n - turn(slot, n)) % n;
}

uint32_t ShardRows::size() const
{
    const uint32_t whole_rounds = rows_ / shard_.count;
    return whole_rounds + (rows_ % shard_.count != 0 && row(whole_rounds) < rows_ ? 1 : 0);
}

namespace fs = std::filesystem;

MergeError::MergeError(std::vector<std::string> all) : BakeError(joined(all, "\n")), problems(std::move(all)) {}

ShardSet::ShardSet(const std::vector<fs::path>& files, RequirePossible require_possible)
{
    for (const fs::path& file : files) open(file, require_possible);
    if (!opened_.empty()) sort_out(most_common());
}

void ShardSet::say(const fs::path& file, const std::string& text)
{
    problems_.push_back(file.string() + ": " + text);
}

void ShardSet::say_missing(const fs::path& file, size_t missing, uint32_t all, uint32_t first_origin)
{
    say(file, std::to_string(missing) + " of " + std::to_string(all) +
                  " rows are missing or damaged, first that of origin " + std::to_string(first_origin) +
                  "; run its bake again, which traces only these");
}

void ShardSet::throw_problems()
{
    name_missing();
    if (opened_.empty() && problems_.empty())
        problems_.push_back("there are no shards to merge; name the files that `lumi bake --shard` wrote");
    if (!problems_.empty()) throw MergeError(std::move(problems_));
}

void ShardSet::open(const fs::path& file, RequirePossible require_possible)
{
    note_input(file);
    try {
        auto blocks = std::make_unique<BlockFile>(std::make_unique<PosixFile>(file, PosixFile::Mode::read));
        require_possible(blocks->identity());
        opened_.push_back(std::move(blocks));
    } catch (const BakeError& error) {
        problems_.push_back(error.what());
    }
}

// The bake that most shards belong to, by its first shard.
const BlockFile& ShardSet::most_common() const
{
    const auto relatives = [&](const std::unique_ptr<BlockFile>& shard) {
        return std::count_if(
            opened_.begin(), opened_.end(),
            [&](const std::unique_ptr<BlockFile>& other) {
                return difference(other->identity(), shard->identity()).empty();
            });
    };
    return **std::max_element(opened_.begin(), opened_.end(),
                              [&](const auto& a, const auto& b) { return relatives(a) < relatives(b); });
}

void ShardSet::sort_out(const BlockFile& model)
{
    for (const std::unique_ptr<BlockFile>& shard : opened_) {
        const std::string text = difference(shard->identity(), model.identity());
        if (!text.empty()) {
            const bool stale = !same_program(shard->identity(), model.identity());
            say(shard->path(), std::string(stale ? "is stale" : "belongs to another bake than ") +
                                   (stale ? ", against " : "") + model.path().string() + " (" + text +
                                   "); leave it out, or bake it again with the scene and options of the others");
            continue;
        }
        const auto [twin, is_new] = shards_.emplace(shard->identity().shard.index, shard.get());
        if (!is_new) {
            say(shard->path(), "is shard " + std::to_string(twin->first) + ", as " + twin->second->path().string() +
                                   " is; leave one of them out");
        }
    }
}

void ShardSet::name_missing()
{
    if (shards_.empty() || shards_.size() == count()) return;
    constexpr size_t kMostNamed = 20;  // a damaged file may say that there are a million
    std::string list;
    size_t named = 0;
    for (uint32_t k = 1; k <= count() && named < kMostNamed; ++k) {
        if (shards_.count(k)) continue;
        list += (list.empty() ? "" : ", ") + std::to_string(k);
        ++named;
    }
    const size_t missing = count() - shards_.size();
    if (missing > named) list += " and " + std::to_string(missing - named) + " more";
    const bool one = missing == 1;
    problems_.push_back((one ? "shard " : "shards ") + list + " of " + std::to_string(count()) +
                        (one ? " is missing; bake it with --shard " : " are missing; bake each with --shard ") +
                        (one ? list : std::string("K")) + "/" + std::to_string(count()));
}

std::string changed_meanwhile(const fs::path& file)
{
    return file.string() + ": changes while it is read; merge again when its bake has ended";
}

}  // namespace lumi::baker
