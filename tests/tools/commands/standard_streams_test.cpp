// SPDX-License-Identifier: MIT
// A result that did not arrive on standard output is no success.
#include <catch2/catch.hpp>
#include <filesystem>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

namespace
{

using test::Outcome;

// Calls with results on standard output. %F is a field, %A a picture, %O a new file.
const char* const kCalls[] = {
    "inspect %F",
    "inspect %F --json --verify",
    "render %F -o %O.png --size 16x16",
    "embed %F -o %O.S",
    "compare %A %A",
    "compare %A %A --json",
    "bake " LUMI_TEST_SCENE " -o %O --origins 8 --directions 8 --spp 1",
    "bake " LUMI_TEST_SCENE " -o %O --origins 8 --directions 8 --spp 1 --progress json",
    "reference " LUMI_TEST_SCENE " -o %O.png --size 16x16 --spp 1",
    "report " LUMI_TEST_SCENE " %F --spp 1 --count 1 --size 32 --cache %O.cache",
    "report " LUMI_TEST_SCENE " %F --spp 1 --count 1 --size 32 --cache %O.cache --json --for rp2040",
    "--help",
    "bake --help",
    "--version",
};

struct Desk {
    test::TemporaryFolder folder;

    Desk()
    {
        test::write_content(folder / "F", test::field_bytes({}));
        write_png(folder / "A", Picture(20, 20));
    }

    Outcome run(std::string call, const std::string& redirection) const
    {
        for (size_t at = 0; (at = call.find('%')) != std::string::npos;) call.replace(at, 1, folder.path() + "/");
        return test::run_program({"sh", "-c", "exec '" + std::string(LUMI_PROGRAM) + "' " + call + redirection});
    }
};

}  // namespace

TEST_CASE("a full disk behind standard output is a failure that is told, whatever the command")
{
    for (const char* call : kCalls) {
        const Desk desk;
        check_refused(desk.run(call, " > /dev/full"), 1,
                      Catch::Contains("lumi: standard output: cannot be written") &&
                          Catch::Contains("; free some space on that disk, or send it elsewhere\n"));
    }
}

TEST_CASE("a closed standard output is a failure too, and no file gets what was meant for it")
{
    for (const char* call : kCalls) {
        const Desk open, closed;
        REQUIRE(open.run(call, "").code == 0);
        check_refused(closed.run(call, " >&-"), 1, "lumi: standard output: cannot be written");
        for (const char* output : {"O", "O.png"})
            if (std::filesystem::exists(open.folder / output))
                CHECK((test::content_of(open.folder / output) == test::content_of(closed.folder / output)));
    }
}

TEST_CASE("what is written to /dev/stdout goes through a pipe whole, and nothing else does")
{
    const std::string calls[] = {"render %F --size 16x16", "view %F",
                                 "reference " LUMI_TEST_SCENE " --size 16x16 --spp 1 --threads 1"};
    for (const std::string& call : calls) {
        const Desk desk;
        INFO(call);
        const int code = desk.run(call, " -o '" + (desk.folder / "file.png") + "'").code;
        if (code != 0 && call == calls[1]) continue;  // built without clang and lld
        REQUIRE(code == 0);
        desk.run(call, " -o /dev/stdout | cat > '" + (desk.folder / "piped") + "'");
        CHECK((test::content_of(desk.folder / "piped") == test::content_of(desk.folder / "file.png")));
    }
}

TEST_CASE("a failure keeps its own exit code when standard output is full")
{
    const Desk desk;
    CHECK(desk.run("inspect %none", " > /dev/full").code == 1);
    CHECK(desk.run("inspect --frob", " > /dev/full").code == 2);
    CHECK(desk.run("inspect %F", " > /dev/null").code == 0);
}

}  // namespace lumi::tools
