// SPDX-License-Identifier: MIT
// lumi_make_test_fields FOLDER: writes one small field per texel format, FOLDER/{rgb888,rgb565,palette8,luma8}.lumi,
// and surface fields, FOLDER/surface.lumi and FOLDER/sheet.lumi.
#include <cstdio>
#include <exception>

#include "chord/field_writer.h"
#include "lumi/texel.h"
#include "surface/surface_bytes.h"
#include "synthetic_ray.h"

namespace
{

using namespace lumi;
using format::TexelFormat;

constexpr uint32_t kOrigins = 128;
constexpr uint32_t kUsedOrigins = 120;  // a cap: rows that are not there count as misses
constexpr uint32_t kDirections = 256;
constexpr int kUsageExitCode = 64;  // EX_USAGE of sysexits.h

std::vector<Rgba8> trace()
{
    const Lattice origins(kOrigins);
    const Lattice directions(kDirections);
    std::vector<Rgba8> texels;
    for (uint32_t i = 0; i < kUsedOrigins; ++i) {
        for (uint32_t j = 0; j < kDirections; ++j) {
            texels.push_back(test::synthetic_ray(point(origins, i), point(directions, j)));
        }
    }
    return texels;
}

void put(TexelFormat texel, const baker::Palette& palette, const Rgba8& seen, uint8_t* at)
{
    const bool hit = seen.a != 0;
    const Rgb8 colour = {seen.r, seen.g, seen.b};
    switch (texel) {
        case TexelFormat::rgb888: {
            const Rgb8 v = hit ? TexelRgb888::encode(colour) : Rgb8{0, 0, 0};
            at[0] = v.r;
            at[1] = v.g;
            at[2] = v.b;
            return;
        }
        case TexelFormat::rgb565: {
            const unsigned v = hit ? TexelRgb565::encode(colour) : 0u;
            at[0] = static_cast<uint8_t>(v & 0xFF);
            at[1] = static_cast<uint8_t>(v >> 8);
            return;
        }
        case TexelFormat::palette8:
            *at = baker::nearest_entry(palette, seen);
            return;
        case TexelFormat::luma8:
            *at = hit ? TexelLuma8::encode(colour) : uint8_t{0};
            return;
    }
}

void write(TexelFormat texel, const std::vector<Rgba8>& seen, const std::filesystem::path& path)
{
    const baker::FieldLayout layout = {kOrigins, kDirections, kUsedOrigins, texel, {0, 0, 0}, 1};
    const baker::Palette palette = baker::fit_palette(seen);
    const auto fill = [&](uint32_t i, std::vector<uint8_t>& row) {
        for (uint32_t j = 0; j < kDirections; ++j) {
            put(texel, palette, seen[i * kDirections + j], row.data() + j * format::bytes_per_texel(texel));
        }
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
        write(TexelFormat::rgb888, seen, folder / "rgb888.lumi");
        write(TexelFormat::rgb565, seen, folder / "rgb565.lumi");
        write(TexelFormat::palette8, seen, folder / "palette8.lumi");
        write(TexelFormat::luma8, seen, folder / "luma8.lumi");
        write_surface(test::bumpy_ball(), folder / "surface.lumi");
        write_surface(test::wavy_sheet(), folder / "sheet.lumi");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
    return 0;
}
