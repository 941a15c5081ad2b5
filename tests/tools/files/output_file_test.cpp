// SPDX-License-Identifier: MIT
#include "files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "support/temporary_folder.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace fs = std::filesystem;

TEST_CASE("an output replaces what stood there and leaves nothing beside it")
{
    const test::TemporaryFolder folder;
    write_output(folder / "a", "first");
    write_output(folder / "a", "second");
    CHECK(test::content_of(folder / "a") == "second");
    CHECK(folder.entries() == 1);
}

TEST_CASE("outputs that are made one after the other take their places together or not at all")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "a", "old");
    {
        OutputSet stopped;
        stopped.add(folder / "a", "new");
        stopped.add(folder / "b", "new");
        CHECK(test::content_of(folder / "a") == "old");
        CHECK_FALSE(fs::exists(folder / "b"));
    }
    CHECK(test::content_of(folder / "a") == "old");
    CHECK(folder.entries() == 1);

    OutputSet whole;
    whole.add(folder / "a", "new");
    whole.add(folder / "b", "new");
    whole.take_places();
    CHECK(test::content_of(folder / "a") == "new");
    CHECK(test::content_of(folder / "b") == "new");
    CHECK(folder.entries() == 2);
}

TEST_CASE("a new output has the permissions of any new file")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "plain", "x");
    write_output(folder / "a", "x");
    CHECK(fs::status(folder / "a").permissions() == fs::status(folder / "plain").permissions());
}

TEST_CASE("an output that cannot be written says so and leaves what stood there")
{
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "directory");
    CHECK_THROWS_WITH(write_output(folder / "directory", "x"), Catch::Contains("name a file"));
    CHECK_THROWS_WITH(write_output(folder / "none/a", "x"), Catch::Contains("create its folder"));
    CHECK_THROWS_AS(require_writable(folder / "none/a"), Failure);
    CHECK(folder.entries() == 1);
}

TEST_CASE("asking whether an output is writable changes nothing")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "a", "old");
    require_writable(folder / "a");
    require_writable(folder / "b");
    CHECK(test::content_of(folder / "a") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a symbolic link stays a link and its target gets the output")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "target", "old");
    fs::create_symlink("target", folder / "link");
    write_output(folder / "link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(test::content_of(folder / "target") == "new");
}

TEST_CASE("a pipe is written to, never replaced")
{
    const test::TemporaryFolder folder;
    const std::string pipe = folder / "pipe";
    constexpr mode_t kPrivate = 0600;
    REQUIRE(mkfifo(pipe.c_str(), kPrivate) == 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    write_output(pipe, "x");
    char received = 0;
    CHECK(read(reader, &received, 1) == 1);
    CHECK(received == 'x');
    close(reader);
    CHECK(fs::is_fifo(pipe));
    CHECK_THROWS_WITH(field_target(pipe), Catch::Contains("name a file"));
}

TEST_CASE("what a rename must replace is the file itself or a link's target")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "target", "\x89LUMI\r\n\x1a");
    fs::create_symlink("target", folder / "link");
    CHECK(fs::path(field_target(folder / "link")).filename() == "target");
    CHECK(fs::path(field_target(folder / "new")).filename() == "new");
    CHECK_THROWS_AS(field_target(folder.path()), Failure);
}

}  // namespace lumi::tools
