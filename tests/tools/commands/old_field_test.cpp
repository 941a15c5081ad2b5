// SPDX-License-Identifier: MIT
// A chord field that lumi of commit 420e9fe baked (testcard.obj, 72 × 96 rays, palette8, 16 light paths) opens, and
// `render` draws what it drew then. Spans draw other bits since tricks were weighed (docs/log/chord.md).
#include <catch2/catch.hpp>

#include "image/picture_file.h"
#include "lumi/detail/crc32.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

// The picture of "linear" is that since Linear is continuous, those of "nearest" and "paper" since distances are those
// of differences: one pixel shows another point, and 151 of 6,144 differ by one level (docs/log/chord.md).
TEST_CASE("a chord field of an earlier version draws the pictures that it drew then")
{
    const test::TemporaryFolder folder;
    const std::string png = folder / "o.png";
    const struct {
        const char* mode;
        uint32_t crc;
    } pictures[] = {{"nearest", 0xECC0FEB2}, {"linear", 0x0BB98C58}, {"paper", 0x3ED96147}};
    for (const auto& p : pictures) {
        CAPTURE(p.mode);
        done(test::lumi({"render", LUMI_OLD_FIELD, "-o", png, "--size", "96x64", "--orbit", "37,23,3", "--fov", "40",
                         "--background", "black", "--mode", p.mode}));
        const Picture picture = read_png(png);
        CHECK(detail::crc32(0, picture.rgb.data(), picture.rgb.size()) == p.crc);
    }
}

}  // namespace lumi::tools
