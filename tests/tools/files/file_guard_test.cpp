// SPDX-License-Identifier: MIT
#include "lumi/baker/file_guard.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "files/output_file.h"
#include "support/temporary_folder.h"

namespace lumi::baker
{

namespace
{

namespace fs = std::filesystem;
using tools::test::content_of;
using tools::test::TemporaryFolder;
using tools::test::write_content;

struct Folder : TemporaryFolder {
    Folder()
    {
        for (const char* name : {"a", "b"}) write_content(*this / name, name);
        fs::create_symlink("a", *this / "soft");
        fs::create_hard_link(*this / "a", *this / "hard");
        fs::create_symlink("none", *this / "dangling");
        fs::create_directory_symlink(".", *this / "deep");
    }
};

}  // namespace

TEST_CASE("a file guard refuses an output that is an input, whichever is named first and by whatever name")
{
    const Folder folder;
    for (const char* name : {"a", "./a", "deep/a", "soft", "deep/soft", "hard"}) {
        INFO(name);
        const fs::path file = folder / name;
        {
            const FileGuard guard;
            note_input(folder / "a");
            CHECK_THROWS_AS(announce_outputs({folder / "b", file}), FileClash);
            CHECK_THROWS_AS(require_no_input(file), FileClash);
            CHECK_NOTHROW(require_no_input(folder / "b"));
        }
        const FileGuard guard;
        announce_outputs({file});
        CHECK_THROWS_AS(note_input(folder / "a"), FileClash);
        CHECK_NOTHROW(note_input(folder / "b"));
    }
}

TEST_CASE("a file guard refuses two outputs in one file, also in one that is still to come")
{
    const Folder folder;
    const FileGuard guard;
    announce_outputs({folder / "a", folder / "b", folder / "none", folder / "other"});
    for (const char* name : {"a", "soft", "hard", "none", "deep/none", "dangling"}) {
        INFO(name);
        CHECK_THROWS_AS(announce_outputs({folder / name}), FileClash);
    }
}

TEST_CASE("a file guard names the output, the input and the mend")
{
    const Folder folder;
    const FileGuard guard;
    note_input(folder / "a");
    CHECK_THROWS_WITH(require_no_input(folder / "a"),
                      (folder / "a") +
                          ": this command reads this file and would overwrite it; choose another name for "
                          "the output");
    CHECK_THROWS_WITH(require_no_input(folder / "soft"), (folder / "soft") + ": leads to the same file as " +
                                                             (folder / "a") +
                                                             ", which this command reads and would overwrite; choose "
                                                             "another name for the output");
}

TEST_CASE("a file guard forgets with its last holder, and without one nothing is refused")
{
    const Folder folder;
    note_input(folder / "a");
    announce_outputs({folder / "a", folder / "a"});
    {
        const FileGuard outer;
        {
            const FileGuard inner;
            note_input(folder / "a");
        }
        CHECK_THROWS_AS(require_no_input(folder / "a"), FileClash);
    }
    const FileGuard other;
    CHECK_NOTHROW(require_no_input(folder / "a"));
    CHECK_NOTHROW(announce_outputs({folder / "a"}));
}

TEST_CASE("a file guard keeps an input whose name was replaced, and lets a gone one's inode be used again")
{
    const Folder folder;
    const FileGuard guard;
    note_input(folder / "a");
    write_content(folder / "a.new", "a");
    fs::rename(folder / "a.new", folder / "a");
    CHECK_THROWS_AS(require_no_input(folder / "a"), FileClash);
    note_input(folder / "b");
    fs::rename(folder / "b", folder / "c");  // the same inode under a name that is no input
    CHECK_NOTHROW(require_no_input(folder / "c"));
}

TEST_CASE("a file guard lets devices, pipes and folders be read and written as often as one likes")
{
    const Folder folder;
    const FileGuard guard;
    for (const std::string& name : {std::string("/dev/null"), folder.path()}) {
        note_input(name);
        announce_outputs({name, name});
        CHECK_NOTHROW(require_no_input(name));
    }
}

TEST_CASE("a file guard is asked again at the moment of writing")
{
    const Folder folder;
    const FileGuard guard;
    tools::announce_outputs({folder / "out"});
    note_input(folder / "a");
    fs::create_symlink("a", folder / "out");  // by someone else, while the command works
    CHECK_THROWS_AS(tools::write_output(folder / "out", "x"), FileClash);
    CHECK(content_of(folder / "a") == "a");
}

// New readers and writers are found by what they call: whoever opens files by hand must say so to the guard.
TEST_CASE("every source that opens a file for reading or writing tells the file guard")
{
    const fs::path root = fs::path(LUMI_TEST_SCENE).parent_path() / "../..";
    // They carry out what their callers have told: the class of files, and what looks at a command's own earlier
    // output.
    const std::set<std::string> told_by_callers = {"posix_file.cpp", "checkpoint.cpp", "embed_purpose.cpp",
                                                   "references.cpp"};
    const std::vector<std::string> reads = {"std::ifstream", ".open(path)", "Mode::read", "fopen("};
    const std::vector<std::string> writes = {"std::ofstream", "Mode::create", "rename(", "O_CREAT"};
    size_t found = 0;
    const auto check = [&](const std::string& name, const std::string& text, const std::vector<std::string>& calls,
                           const std::string& duty) {
        for (const std::string& call : calls) {
            if (text.find(call) == std::string::npos) continue;
            INFO(name << " has " << call << " but no " << duty);
            CHECK(text.find(duty) != std::string::npos);
            ++found;
        }
    };
    for (const char* tree : {"baker/src", "tools/src"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / tree)) {
            const std::string name = entry.path().filename().string();
            if (entry.path().extension() != ".cpp" || told_by_callers.count(name) > 0) continue;
            const std::string text = content_of(entry.path().string());
            if (name != "output_file.cpp") check(name, text, reads, "note_input(");  // it looks at what it replaces
            check(name, text, writes, "require_no_input(");
        }
    }
    CHECK(found >= 8);
}

}  // namespace lumi::baker
