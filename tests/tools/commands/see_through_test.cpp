// SPDX-License-Identifier: MIT
// Surface fields with see-through parts through the program.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "surface/see_through_bytes.h"

namespace lumi::tools
{

using test::lumi;
using test::Outcome;

namespace
{

constexpr uint8_t kSquareTexel = 200, kPaneTexel = 7;
constexpr int kSquare[] = {200, 55, 140};  // surface_palette_section() of that texel
constexpr lumi::test::TestGlass kPane = {{60, 20, 40}, {128, 64, 192}};

// From above: a square in the middle, and a smaller pane over it.
void write_pane_above_square(const std::string& path)
{
    lumi::test::GlassPalette palette{};
    palette[kPaneTexel] = kPane;
    const lumi::test::TestSurface surface = lumi::test::panes({{8000, -4000, kSquareTexel}, {4000, 4000, kPaneTexel}});
    const lumi::test::Bytes bytes = lumi::test::see_through_file(surface, 1, palette);
    test::write_content(path, std::string(bytes.begin(), bytes.end()));
}

Outcome success(const test::Arguments& call)
{
    const test::Outcome outcome = done(lumi(call));
    return outcome;
}

}  // namespace

TEST_CASE("render shows in every mode what stands behind a pane, and beside the pane the same without it")
{
    constexpr int kRounding = 3, kMiddle = 32, kBesidePane = 43;
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi", picture = folder / "o.png";
    write_pane_above_square(field);
    for (const char* mode : {"one-sample", "antialiased", "2x2"}) {
        INFO(mode);
        success({"render", field, "-o", picture, "--size", "64x64", "--orbit", "0,90,3", "--background", "black",
                 "--mode", mode});
        const Picture drawn = read_png(picture);
        for (size_t c = 0; c < kPane.added.size(); ++c) {
            const int through = kPane.added[c] + kPane.passed[c] * kSquare[c] / 255;
            CHECK(std::abs(drawn.pixel(kMiddle, kMiddle)[c] - through) <= kRounding);
            CHECK(std::abs(drawn.pixel(kBesidePane, kMiddle)[c] - kSquare[c]) <= kRounding);
        }
    }
}

TEST_CASE("inspect counts see-through patches")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    write_pane_above_square(field);
    const auto json = nlohmann::json::parse(success({"inspect", field, "--json", "--verify"}).out);
    CHECK(json["patches"] == 1);
    CHECK(json["see_through_patches"] == 1);
    CHECK_THAT(success({"inspect", field}).out,
               Catch::Contains("see-through   1 patches besides") && Catch::Contains("SSEE"));
}

TEST_CASE("the view of an embedded field has room for its see-through patches, and compiles")
{
    const test::TemporaryFolder folder;
    write_pane_above_square(folder / "f.lumi");
    success({"embed", folder / "f.lumi", "-o", folder / "pane.S"});
    CHECK_THAT(test::content_of(folder / "pane.h"),
               Catch::Contains("using pane_view = lumi::View<lumi::SurfaceDrawing<8, 1, Finest, 1>, Screen>;") &&
                   Catch::Contains("enum { pane_vertices = 8, pane_patches = 1, pane_see_through = 1 };"));
    test::write_content(folder / "main.cpp",
                        "#include \"pane.h\"\n"
                        "static pane_view<lumi::Screen<64, 64, 16>> view;\n"
                        "bool opens() { return view.open(pane, pane_size()) == lumi::ViewError::none; }\n");
    done(test::run_program({LUMI_CXX_COMPILER, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I",
                            LUMI_CORE_INCLUDE, "-I", folder.path(), folder / "main.cpp"}));
}

}  // namespace lumi::tools
