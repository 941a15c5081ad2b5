// SPDX-License-Identifier: MIT
#include "lumi/baker/merge.h"

#include <algorithm>
#include <map>

#include "row_file.h"

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines) {
        text += (text.empty() ? "" : "\n") + line;
    }
    return text;
}

// The open shards, and what is wrong with them.
class ShardSet
{
public:
    explicit ShardSet(const std::vector<fs::path>& files)
    {
        for (const fs::path& file : files) {
            open(file);
        }
        if (!opened_.empty()) {
            sort_out(most_common());
        }
    }

    // All problems of the set, or none.
    std::vector<std::string> problems(const std::function<void()>& leave_if_cancelled)
    {
        for (const auto& [index, rows] : shards_) {
            leave_if_cancelled();
            check_rows(*rows);
        }
        check_palettes();
        name_missing();
        if (opened_.empty() && problems_.empty()) {
            problems_.push_back("there are no shards to merge; name the files that `lumi bake --shard` wrote");
        }
        return problems_;
    }

    const FieldLayout& layout() const { return shards_.begin()->second->layout(); }
    uint32_t count() const { return shards_.begin()->second->identity().shard.count; }
    Palette palette() const
    {
        Palette palette{};
        shards_.begin()->second->read_palette(palette);
        return palette;
    }
    const RowFile& of_row(uint32_t i) const { return *shards_.at(ShardRows::index_of(i, count())); }

private:
    void say(const fs::path& file, const std::string& text) { problems_.push_back(file.string() + ": " + text); }

    void open(const fs::path& file)
    {
        try {
            opened_.push_back(std::make_unique<RowFile>(std::make_unique<PosixFile>(file, PosixFile::Mode::read)));
        } catch (const BakeError& error) {
            problems_.push_back(error.what());
        }
    }

    // The bake that most shards belong to, by its first shard.
    const RowFile& most_common() const
    {
        const auto relatives = [&](const std::unique_ptr<RowFile>& rows) {
            return std::count_if(opened_.begin(), opened_.end(), [&](const std::unique_ptr<RowFile>& other) {
                return difference(other->identity(), rows->identity()).empty();
            });
        };
        return **std::max_element(opened_.begin(), opened_.end(),
                                  [&](const auto& a, const auto& b) { return relatives(a) < relatives(b); });
    }

    void sort_out(const RowFile& model)
    {
        for (const std::unique_ptr<RowFile>& rows : opened_) {
            const std::string text = difference(rows->identity(), model.identity());
            if (!text.empty()) {
                const bool stale = !same_program(rows->identity(), model.identity());
                say(rows->path(), std::string(stale ? "is stale" : "belongs to another bake than ") +
                                      (stale ? ", against " : "") + model.path().string() + " (" + text +
                                      "); leave it out, or bake it again with the scene and options of the others");
                continue;
            }
            const auto [twin, is_new] = shards_.emplace(rows->identity().shard.index, rows.get());
            if (!is_new) {
                say(rows->path(), "is shard " + std::to_string(twin->first) + ", as " + twin->second->path().string() +
                                      " is; leave one of them out");
            }
        }
    }

    void check_rows(const RowFile& rows)
    {
        const std::vector<uint32_t> missing = missing_slots(rows);
        if (!missing.empty()) {
            say(rows.path(), std::to_string(missing.size()) + " of " + std::to_string(rows.slot_count()) +
                                 " rows are missing or damaged, first that of origin " +
                                 std::to_string(rows.row_of(missing.front())) +
                                 "; run its bake again, which traces only these");
        }
        if (!rows.has_intact_palette()) {
            say(rows.path(), "its palette is damaged; run its bake again");
        }
    }

    void check_palettes()
    {
        Palette first{}, own{};
        for (const auto& [index, rows] : shards_) {
            if (!rows->read_palette(own)) {
                continue;
            }
            if (rows == shards_.begin()->second) {
                first = own;
            } else if (!std::equal(own.begin(), own.end(), first.begin(), same_colour)) {
                say(rows->path(),
                    "has another palette than the first shard; bake it again on the machine of the others");
            }
        }
    }

    static bool same_colour(const Rgba8& a, const Rgba8& b)
    {
        return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
    }

    void name_missing()
    {
        if (shards_.empty() || shards_.size() == count()) {
            return;
        }
        std::string list;
        for (uint32_t k = 1; k <= count(); ++k) {
            list += shards_.count(k) ? "" : (list.empty() ? "" : ", ") + std::to_string(k);
        }
        const bool one = count() - shards_.size() == 1;
        problems_.push_back((one ? "shard " : "shards ") + list + " of " + std::to_string(count()) +
                            (one ? " is missing; bake it with --shard " : " are missing; bake each with --shard ") +
                            (one ? list : std::string("K")) + "/" + std::to_string(count()));
    }

    std::vector<std::unique_ptr<RowFile>> opened_;
    std::map<uint32_t, const RowFile*> shards_;  // by index, from 1
    std::vector<std::string> problems_;
};

void refuse_own_input(const std::vector<fs::path>& shards, const fs::path& output)
{
    std::error_code ignored;
    for (const fs::path& shard : shards) {
        if (fs::equivalent(shard, output, ignored)) {
            throw BakeError(output.string() + ": is one of the shards; choose another name for the field");
        }
    }
}

}  // namespace

MergeError::MergeError(std::vector<std::string> all) : BakeError(joined(all)), problems(std::move(all)) {}

MergedField merge_shards(const std::vector<fs::path>& shards, const fs::path& output,
                         const std::function<bool()>& keep_going)
{
    const auto leave_if_cancelled = [&] {
        if (keep_going && !keep_going()) {
            throw Cancelled();
        }
    };
    refuse_own_input(shards, output);
    ShardSet set(shards);
    std::vector<std::string> problems = set.problems(leave_if_cancelled);
    if (!problems.empty()) {
        throw MergeError(std::move(problems));
    }
    NewFile out(output);
    const auto read = [&](uint32_t i, std::vector<uint8_t>& row) {
        leave_if_cancelled();
        const RowFile& rows = set.of_row(i);
        if (!rows.read_row(ShardRows::slot_of(i, set.count()), row)) {
            throw BakeError(rows.path().string() + ": changes while it is read; merge again when its bake has ended");
        }
    };
    write_field(set.layout(), read, set.palette(), out);
    out.commit();
    return {file_bytes(set.layout()), set.layout().used_origins, set.layout().directions, set.count()};
}

}  // namespace lumi::baker
