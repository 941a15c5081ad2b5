// SPDX-License-Identifier: MIT
// Bakes that run out of room.
#include <catch2/catch.hpp>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::content_of;
using test::lumi;
using test::Outcome;

namespace
{

// 160 kB.
const std::string kBake =
    std::string(" bake ") + LUMI_TEST_SCENE + " --origins 200 --directions 400 --spp 2 --texel rgb565 -o ";

Outcome shell(const std::string& script)
{
    return test::run_program({"sh", "-c", script});
}

// A script in which `$folder` is a disk of that size, or nothing where this machine does not allow that.
Outcome on_small_disk(const std::string& folder, const std::string& size, const std::string& script)
{
    const std::string mount = "mount -t tmpfs -o size=" + size + " lumi-test '" + folder + "' && ";
    return test::run_program({"unshare", "-rm", "sh", "-c", mount + "folder='" + folder + "' && " + script});
}

}  // namespace

TEST_CASE("a bake that the disk has no room for says so before the work and leaves an earlier field as it was")
{
    const test::TemporaryFolder folder;
    if (on_small_disk(folder.path(), "100k", "true").code != 0) {
        WARN("not tried: this machine lets nobody mount a small disk");
        return;
    }
    const Outcome outcome = on_small_disk(folder.path(), "100k",
                                          "echo earlier > $folder/f.lumi; " + std::string(LUMI_PROGRAM) + kBake +
                                              "$folder/f.lumi; echo code $?; cat $folder/f.lumi; ls $folder");
    CHECK(outcome.out == "code 1\nearlier\nf.lumi\n");
    CHECK_THAT(outcome.err, Catch::Contains("f.lumi.part: cannot be ") && Catch::Contains("No space left on device") &&
                                Catch::Contains("free some space on that disk"));
    CHECK_THAT(outcome.err, !Catch::Contains("rays/s"));
}

TEST_CASE("a bake whose field no longer fits keeps its rows, and the same command ends it once there is room")
{
    const test::TemporaryFolder folder, kept;
    if (on_small_disk(folder.path(), "100k", "true").code != 0) {
        WARN("not tried: this machine lets nobody mount a small disk");
        return;
    }
    const std::string bake = std::string(LUMI_PROGRAM) + kBake;
    const Outcome outcome = on_small_disk(
        folder.path(), "260k",
        bake + "$folder/f.lumi; echo code $?; ls $folder; mount -o remount,size=4m $folder && " + bake +
            "$folder/f.lumi --progress json | head -1; cp $folder/f.lumi '" + (kept / "small.lumi") + "'; ls $folder");
    INFO(outcome.out << outcome.err);
    CHECK_THAT(outcome.out, Catch::StartsWith("code 1\nf.lumi.part\n") && Catch::EndsWith("\nf.lumi\n") &&
                                Catch::Contains("\"rays_done\":160000,"));
    CHECK_THAT(outcome.err, Catch::Contains("No space left on device"));
    REQUIRE(shell(bake + "'" + (kept / "whole.lumi") + "'").code == 0);
    CHECK(content_of(kept / "small.lumi") == content_of(kept / "whole.lumi"));
}

}  // namespace lumi::tools
