// SPDX-License-Identifier: MIT
#include "store/stage_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "support/scratch_folder.h"

namespace lumi::baker::testing
{
namespace
{

using Bytes = std::vector<uint8_t>;

const Digest::Value kFirst = {1, 2}, kSecond = {3, 4};
const Bytes kFew = {5, 6, 7}, kMany(5000, 8);

std::string file_of_two(const ScratchFolder& folder)
{
    StageFile file(folder.at("f.stages"));
    file.add(kFirst, kFew);
    file.add(kSecond, kMany);
    return read_bytes(folder.at("f.stages"));
}

bool holds(const ScratchFolder& folder, const Digest::Value& key, const Bytes& expected)
{
    Bytes bytes;
    return StageFile(folder.at("f.stages")).find(key, bytes) && bytes == expected;
}

}  // namespace

TEST_CASE("stage file: what was added is found by its key, by the next process too")
{
    const ScratchFolder folder;
    {
        const StageFile none(folder.at("f.stages"));
        Bytes bytes;
        CHECK_FALSE(none.find(kFirst, bytes));
    }
    CHECK(folder.file_count() == 0);  // nothing is made for nothing
    file_of_two(folder);
    CHECK(holds(folder, kFirst, kFew));
    CHECK(holds(folder, kSecond, kMany));
    Bytes bytes;
    CHECK_FALSE(StageFile(folder.at("f.stages")).find({1, 4}, bytes));
}

TEST_CASE("stage file: of a file that was cut at any length, whole results are found and the others can be added again")
{
    const ScratchFolder folder;
    const std::string whole = file_of_two(folder);
    const size_t first = whole.size() - kMany.size() - 28;
    for (size_t size = 0; size < whole.size(); size += size < first + 40 ? 1 : 331) {
        folder.write("f.stages", whole.substr(0, size));
        INFO(size);
        CHECK(holds(folder, kFirst, kFew) == (size >= first));
        CHECK_FALSE(holds(folder, kSecond, kMany));
        StageFile(folder.at("f.stages")).add(kSecond, kMany);
        CHECK(holds(folder, kSecond, kMany));
    }
}

TEST_CASE("stage file: a damaged byte loses its result, and never gives a wrong one")
{
    const ScratchFolder folder;
    const std::string whole = file_of_two(folder);
    const size_t first = whole.size() - kMany.size() - 28;
    for (size_t at = 0; at < whole.size(); at += at < first + 40 ? 1 : 331) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x80);
        folder.write("f.stages", damaged);
        INFO(at);
        const StageFile file(folder.at("f.stages"));
        Bytes bytes;
        CHECK((at >= first || !file.find(kFirst, bytes)));
        CHECK((at < first || !file.find(kSecond, bytes)));
        if (at >= first) {
            REQUIRE(file.find(kFirst, bytes));
            CHECK((bytes == kFew));
        }
    }
}

TEST_CASE("stage file: where it cannot be written or another process has it, nothing is kept and nothing fails")
{
    const ScratchFolder folder;
    Bytes bytes;
    StageFile nowhere(folder.at("none/f.stages"));
    nowhere.add(kFirst, kFew);
    CHECK_FALSE(nowhere.find(kFirst, bytes));
    StageFile unnamed{std::filesystem::path()};
    unnamed.add(kFirst, kFew);
    CHECK_FALSE(unnamed.find(kFirst, bytes));
    std::filesystem::create_directories(folder.at("d.stages"));
    StageFile at_folder(folder.at("d.stages"));
    at_folder.add(kFirst, kFew);
    CHECK(std::filesystem::is_directory(folder.at("d.stages")));

    StageFile owner(folder.at("f.stages"));
    owner.add(kFirst, kFew);
    StageFile second(folder.at("f.stages"));  // the lock is held
    CHECK_FALSE(second.find(kFirst, bytes));
    second.add(kSecond, kMany);
    CHECK(owner.find(kFirst, bytes));
    CHECK_FALSE(owner.find(kSecond, bytes));
}

}  // namespace lumi::baker::testing
