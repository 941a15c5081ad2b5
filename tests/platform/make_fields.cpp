// SPDX-License-Identifier: MIT
// lumi_make_test_fields FOLDER: writes one small field per texel format, FOLDER/rgb888.lumi and so on,
// and surface fields, FOLDER/surface.lumi, FOLDER/sheet.lumi and, with parts that move, FOLDER/moving.lumi.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "chord/field_writer.h"
#include "lumi/chord/texel.h"
#include "lumi/detail/lattice.h"
#include "surface/parts_bytes.h"
#include "surface/surface_bytes.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;

constexpr double kBallRadius = 0.6;
constexpr double kSolidRadius = 0.5;  // rays that pass further out see the half-transparent rim
constexpr int kChequersPerRadius = 4;
constexpr uint8_t kRimCoverage = 128;

// A scene in closed form: a chequered ball of half the sphere's radius with a half-transparent rim. Every texel is
// known at once, so that tests of the renderer on boards need no path tracing.
struct Vec3 {
    double x, y, z;
};

Vec3 from_q30(const Vec3q30& v)
{
    return {static_cast<double>(v.x) / kOneQ30, static_cast<double>(v.y) / kOneQ30, static_cast<double>(v.z) / kOneQ30};
}

double dot(const Vec3& a, const Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vec3 along(const Vec3& start, const Vec3& step, double t)
{
    return {start.x + t * step.x, start.y + t * step.y, start.z + t * step.z};
}

// Position as colour, darkened on every other cube of a chequerboard; black occurs.
Rgba8 shade(const Vec3& hit, uint8_t coverage)
{
    const auto cell = [](double v) { return static_cast<int>(std::floor(v * kChequersPerRadius)); };
    const bool dark = ((cell(hit.x) + cell(hit.y) + cell(hit.z)) & 1) != 0;
    const double scale = (dark ? 0.0 : 1.0) * coverage;
    const auto channel = [&](double v) { return static_cast<uint8_t>((v / kBallRadius + 1) / 2 * scale); };
    return {channel(hit.x), channel(hit.y), channel(hit.z), coverage};
}

// Premultiplied colour with coverage of the ray from `origin` to `target` on the unit sphere.
Rgba8 synthetic_ray(const Vec3q30& origin, const Vec3q30& target)
{
    const Vec3 start = from_q30(origin);
    const Vec3 end = from_q30(target);
    const Vec3 step = {end.x - start.x, end.y - start.y, end.z - start.z};
    const double length2 = dot(step, step);
    const double middle = -dot(start, step) / length2;  // both ends lie on the unit sphere: 1/2, but for rounding
    const Vec3 closest = along(start, step, middle);
    const double closest2 = dot(closest, closest);
    if (!(length2 > 0) || closest2 > kBallRadius * kBallRadius) return {};
    const double half_chord = std::sqrt((kBallRadius * kBallRadius - closest2) / length2);
    const bool solid = closest2 <= kSolidRadius * kSolidRadius;
    return shade(along(start, step, middle - half_chord), solid ? 255 : kRimCoverage);
}

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
            texels.push_back(synthetic_ray(point(origins, i), point(directions, j)));
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
