// SPDX-License-Identifier: MIT
// `lumi view` through the program.
#include <catch2/catch.hpp>
#include <filesystem>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "surface/states_bytes.h"
#include "viewer/modules.h"

namespace lumi::tools
{

namespace
{

const test::TemporaryFolder& folder()
{
    static const test::TemporaryFolder all;
    return all;
}

// A surface field.
std::string field()
{
    const std::string path = folder() / "cube.lumi";
    if (!std::filesystem::exists(path)) test::write_content(path, test::small_surface_bytes());
    return path;
}

test::Outcome view(const test::Arguments& arguments)
{
    return test::lumi(test::joined({"view", field()}, arguments));
}

bool has_modules()
{
    return !surface_module().empty();
}

void write_turntable(const std::string& name, int pictures)
{
    std::filesystem::create_directory(folder() / name);
    for (int k = 0; k < pictures; ++k) write_png(folder() / name + "/t-00" + std::to_string(k) + ".png", Picture(8, 8));
}

}  // namespace

TEST_CASE("a program that was built without clang and lld says what to install")
{
    if (has_modules()) return;
    check_refused(view({"-o", folder() / "page.html"}), 1, "apt-get install clang lld");
    CHECK_FALSE(std::filesystem::exists(folder() / "page.html"));
}

TEST_CASE("view names what is wrong with a call")
{
    CHECK(test::lumi({"view"}).code == 2);
    CHECK(view({"-o", folder() / "p.html", "--orbit", "30,20,9"}).code == 2);
    CHECK(view({"-o", folder() / "p.html", "--background", "red"}).code == 2);
    CHECK(view({"-o", field()}).code == 2);
    CHECK(test::lumi({"view", LUMI_TEST_SCENE, "-o", folder() / "p.html"}).code == 1);
    CHECK_FALSE(std::filesystem::exists(folder() / "p.html"));
}

TEST_CASE("without -o and without xdg-open, view says how to write the page to a file")
{
    if (!has_modules()) return;
    const test::TemporaryFolder temporary;
    const auto view_in = [](const std::string& folder) {
        return test::run_program({"/usr/bin/env", "PATH=/none", "TMPDIR=" + folder, LUMI_PROGRAM, "view", field()});
    };
    check_refused(view_in(temporary.path()), 1, Catch::Contains("xdg-open") && Catch::Contains("-o view.html"));
    CHECK(temporary.entries() == 0);
    check_refused(view_in(""), 1, Catch::Contains("xdg-open"));
    check_refused(view_in(temporary / "none"), 1,
                  Catch::Contains(temporary / "none: ") && Catch::Contains("; set TMPDIR to a folder"));
}

TEST_CASE("a page takes a turntable to compare with, and refuses what is none")
{
    if (!has_modules()) return;
    const std::string page = folder() / "compared.html";
    write_turntable("whole", 3);
    done(view({"-o", page, "--reference", folder() / "whole"}));
    const std::string html = test::content_of(page);
    size_t pictures = 0;
    for (size_t at = 0; (at = html.find("iVBORw0KGgo", at)) != std::string::npos; ++at) ++pictures;
    CHECK(pictures == 3);

    write_turntable("short", 1);
    write_turntable("broken", 3);
    std::filesystem::remove(folder() / "broken/t-001.png");
    write_turntable("mixed", 2);
    write_png(folder() / "mixed/other-000.png", Picture(8, 8));
    write_turntable("sizes", 2);
    write_png(folder() / "sizes/t-001.png", Picture(8, 9));
    for (const char* wrong : {"none", "short", "broken", "mixed", "sizes"}) {
        const test::Outcome refused = view({"-o", page, "--reference", folder() / wrong});
        INFO(wrong << ": " << refused.err);
        CHECK(refused.code == 1);
    }
}

TEST_CASE("a title cannot break out of the page, and need not be UTF-8")
{
    if (!has_modules()) return;
    const std::string page = folder() / "title.html";
    done(view({"-o", page, "--title", "caf\xe9</script><b>{{field}}"}));
    const std::string html = test::content_of(page);
    CHECK_THAT(html, !Catch::Contains("</script><b>"));
    CHECK_THAT(html, Catch::Contains("&lt;/script&gt;&lt;b&gt;{{field}}"));
}

#ifdef LUMI_NODE
TEST_CASE("a page's module draws what render draws, for fields of both layouts and every texel format")
{
    if (!has_modules()) return;
    std::vector<std::string> fields = {field(), LUMI_OLD_FIELD};
    for (const std::string texels : {"rgb888", "rgb565", "luma8"}) {
        fields.push_back(folder() / texels + ".lumi");
        REQUIRE(test::lumi({"bake", LUMI_TEST_SCENE, "-o", fields.back(), "--origins", "90", "--directions", "90",
                            "--spp", "1", "--texel", texels})
                    .code == 0);
    }
    fields.push_back(folder() / "small.lumi");  // too small for spans
    REQUIRE(test::lumi(
                {"bake", LUMI_TEST_SCENE, "-o", fields.back(), "--origins", "20", "--directions", "20", "--spp", "1"})
                .code == 0);
    fields.push_back(folder() / "parts.lumi");
    const lumi::test::Bytes parts = lumi::test::lit_file(lumi::test::moving_ball());
    test::write_content(fields.back(), std::string(parts.begin(), parts.end()));
    for (size_t k = 0; k < fields.size(); ++k) {
        const std::string& path = fields[k];
        test::Arguments call = {LUMI_NODE, LUMI_MODULE_TEST, LUMI_PROGRAM, path};
        if (k >= 2) call.push_back("frames");  // each layout has had the other tests
        done(test::run_program(call));
    }
}
#endif

}  // namespace lumi::tools
