// SPDX-License-Identifier: MIT
// lumi_make_test_fields FOLDER: writes one small field per texel format, FOLDER/rgb888.lumi and so on,
// and surface fields, FOLDER/surface.lumi, FOLDER/sheet.lumi and, with parts that move, FOLDER/moving.lumi.
#include <algorithm>
#include <cstdio>
#include <exception>

#include "chord/field_writer.h"
#include "lumi/chord/texel.h"
#include "surface/parts_bytes.h"
#include "surface/surface_bytes.h"
#include "synthetic_ray.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;

constexpr uint32_t kOrigins = 128;
constexpr uint32_t kUsedOrigins = 120;  // a cap: rows that are not there count as misses
constexpr uint32_t kDirections = 256;
constexpr int kUsageExitCode = 64;  // EX_USAGE of sysexits.h

std::vector<Rgba8> trace()
{
    const Lattice origins(kOrigins);
    const Lattice directions(kDirections);
    std::vector<Rgba8> texels;
    for (uint32_t i = 0; i < kUsedOrigins; ++i)
        for (uint32_t j = 0; j < kDirections; ++j)
            texels.push_back(test::synthetic_ray(point(origins, i), point(directions, j)));
    return texels;
}

void put(TexelFormat texel, const baker::Palette& palette, const Rgba8& seen, uint8_t* at)
{
    with_texel(
        texel,
        [&](auto policy) {
            if constexpr (decltype(policy)::kIndexed)
                *at = baker::nearest_entry(palette, seen);
            else if (seen.a != 0)  // rows start out as zeros, which mean a miss
                policy.store(at, {seen.r, seen.g, seen.b});
        });
}

void write(TexelFormat texel, const std::vector<Rgba8>& seen, const std::filesystem::path& path)
{
    const baker::FieldLayout layout = {kOrigins, kDirections, kUsedOrigins, texel, {0, 0, 0}, 1};
    const baker::Palette palette = baker::fit_palette(seen);
    const auto fill = [&](uint32_t i, std::vector<uint8_t>& row) {
        std::fill(row.begin(), row.end(), uint8_t{0});
        for (uint32_t j = 0; j < kDirections; ++j)
            put(texel, palette, seen[i * kDirections + j], row.data() + j * format::bytes_per_texel(texel));
    };
    baker::NewFile out(path);
    baker::write_field(layout, fill, palette, out);
    out.commit();
}

void write_surface(const test::TestSurface& surface, const std::filesystem::path& path)
{
    const test::Bytes bytes = test::surface_file(surface);
    baker::NewFile out(path);
    out.append(bytes);
    out.commit();
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: lumi_make_test_fields FOLDER\n", stderr);
        return kUsageExitCode;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        const std::vector<Rgba8> seen = trace();
        for (const TexelFormat texel : AllTexels::kFormats)
            write(texel, seen, folder / (std::string(texel_name(texel)) + ".lumi"));
        write_surface(test::bumpy_ball(), folder / "surface.lumi");
        write_surface(test::wavy_sheet(), folder / "sheet.lumi");
        baker::NewFile moving(folder / "moving.lumi");
        moving.append(test::mover_file(test::shaded_ball(0)));
        moving.commit();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
    return 0;
}
