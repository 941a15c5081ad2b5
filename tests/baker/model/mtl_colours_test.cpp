// SPDX-License-Identifier: MIT
#include "model/mtl_colours.h"

#include <catch2/catch.hpp>

#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

struct Read {
    MtlMaterial first;
    std::string warnings;
};

Read read(const std::string& text, ColourScale colours = ColourScale::unstated)
{
    const testing::ScratchFolder folder;
    std::vector<std::string> lines;
    Read result = {read_mtl(folder.write("m.mtl", text), lines, colours).front(), ""};
    for (const std::string& line : lines) result.warnings += line + "\n";
    return result;
}

}  // namespace

TEST_CASE("MTL colours: those of a display become linear light, and no other number does")
{
    const std::string text =
        "newmtl a\nKd 0.5 0 1\nKs 0.25 0.25 0.25\nKe 0.5 0.5 0.5\nTf 0.75 1 1\nPr 0.5\nd 0.5\nNi 1.5\n";
    const MtlMaterial linear = read(text, ColourScale::linear).first, display = read(text, ColourScale::display).first;
    CHECK(linear.colour("Kd").r == 0.5f);
    CHECK(display.colour("Kd").r == Approx(0.2140).epsilon(1e-3));
    CHECK(display.colour("Kd").g == 0);
    CHECK(display.colour("Kd").b == 1);
    CHECK(display.colour("Ks").g == Approx(0.0509).epsilon(1e-3));
    CHECK(display.colour("Ke").g == Approx(0.2140).epsilon(1e-3));
    CHECK(display.colour("Tf").r == Approx(0.5225).epsilon(1e-3));
    for (const char* keyword : {"Pr", "Ni"}) CHECK(display.number(keyword, 0) == linear.number(keyword, 0));
    CHECK(display.opacity == 0.5f);
}

TEST_CASE("MTL colours: a file of whole 255ths, or of a program that writes them, is warned of")
{
    const std::string picked = "newmtl a\nKd 0.588235 0.545098 0.231373\nKs 0 0 0\n";
    CHECK_THAT(read(picked).warnings, Catch::Contains("m.mtl: ") && Catch::Contains("--colours display"));
    CHECK(read(picked, ColourScale::linear).warnings.empty());
    CHECK(read(picked, ColourScale::display).warnings.empty());
    for (const char* program : {"# 3ds Max Wavefront OBJ Exporter v0.97b\n", "#\n  # Exported from SketchUp\n"})
        CHECK_FALSE(read(std::string(program) + "newmtl a\nKd 0.3 0.3 0.3\n").warnings.empty());
}

TEST_CASE("MTL colours: what people and Blender write is not warned of")
{
    for (const char* text : {"newmtl a\nKd 0.8 0.8 0.8\nKs 0.5 0.5 0.5\n", "newmtl a\nKd 0.14 0.3 0.25\n",
                             "newmtl a\nKd 0.2 0.4 0.6\nKs 1 1 1\nnewmtl b\nKd 0 1 0.2\n",
                             "# Blender 3.4.1 MTL File: 'mug.blend'\nnewmtl a\nKd 0.603827 0.027321 0.130136\n",
                             "newmtl SketchUp\nKd 0.3 0.35 0.7\n", "# 3ds Max\nnewmtl a\nKd 1 1 1\n"}) {
        INFO(text);
        CHECK(read(text).warnings.empty());
    }
}

}  // namespace lumi::baker
