// SPDX-License-Identifier: MIT
#include "lumi/host/mapped_file.h"

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstring>
#include <utility>

#include "support/temporary_folder.h"

namespace lumi::host
{

TEST_CASE("a mapped file shows the file's bytes until it is closed")
{
    const tools::test::TemporaryFolder folder;
    tools::test::write_content(folder / "a", "field");
    MappedFile file;
    REQUIRE(file.open(folder / "a") == 0);
    REQUIRE(file.size() == 5);
    CHECK(std::memcmp(file.bytes(), "field", 5) == 0);
    MappedFile moved = std::move(file);
    CHECK(moved.size() == 5);
    CHECK(moved.bytes()[0] == 'f');
    moved.close();
    CHECK(moved.bytes() == nullptr);
    CHECK(moved.size() == 0);
}

TEST_CASE("an empty file maps to no bytes")
{
    const tools::test::TemporaryFolder folder;
    tools::test::write_content(folder / "a", "");
    MappedFile file;
    CHECK(file.open(folder / "a") == 0);
    CHECK(file.size() == 0);
}

TEST_CASE("what is no regular file is refused with the reason and maps nothing")
{
    const tools::test::TemporaryFolder folder;
    tools::test::write_content(folder / "a", "field");
    MappedFile file;
    REQUIRE(file.open(folder / "a") == 0);
    CHECK(file.open(folder / "none") == ENOENT);
    CHECK(file.open(folder.path()) == EISDIR);
    CHECK(file.open("/dev/null") == ENODEV);
    CHECK(file.size() == 0);
    CHECK(file.bytes() == nullptr);
}

}  // namespace lumi::host
