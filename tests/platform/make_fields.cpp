// SPDX-License-Identifier: MIT
// lumi_make_test_fields FOLDER: writes one small field per texel format, FOLDER/rgb888.lumi and so on,
// and surface fields, FOLDER/surface.lumi, FOLDER/sheet.lumi and, with parts that move, FOLDER/moving.lumi.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "lumi/chord/texel.h"
#include "surface/parts_bytes.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;
using test::Bytes;

constexpr int kUsageExitCode = 64;  // EX_USAGE of sysexits.h

// Smooth but eventful texels. Every fifth is a miss, and so are all of the last rows, which are not there; of a palette
// the upper half covers half.
Bytes chord_field(TexelFormat texel)
{
    const test::TestLayout layout = test::layout_of(128, 256, texel, 120);
    const uint32_t bytes = format::bytes_per_texel(texel);
    const auto value = [&](uint32_t i, uint32_t k) {
        return static_cast<uint8_t>(k / bytes % 5 == 0 ? 0 : i * 37 + k * 11 + i * k / 7);
    };
    std::vector<test::TestSection> sections = {test::layout_section(layout), test::texel_section(layout, value)};
    if (texel == TexelFormat::palette8) {
        sections.push_back(test::palette_section());
        Bytes& entries = sections.back().bytes;
        for (size_t k = entries.size() / 2; k < entries.size(); ++k) entries[k] = static_cast<uint8_t>(entries[k] / 2);
    }
    return test::file_of(sections);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: lumi_make_test_fields FOLDER\n", stderr);
        return kUsageExitCode;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const Bytes& bytes) {
        std::ofstream out;
        out.exceptions(std::ios::failbit | std::ios::badbit);
        out.open(folder / (name + ".lumi"), std::ios::binary);
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())).flush();
    };
    for (const TexelFormat texel : AllTexels::kFormats) write(texel_name(texel), chord_field(texel));
    write("surface", test::surface_file(test::bumpy_ball()));
    write("sheet", test::surface_file(test::wavy_sheet()));
    write("moving", test::mover_file(test::shaded_ball(0)));
    return 0;
}
