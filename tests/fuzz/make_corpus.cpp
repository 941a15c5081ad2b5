// SPDX-License-Identifier: MIT
// lumi_make_fuzz_corpus FOLDER: seeds of field_fuzz.cpp in FOLDER/field, fields of each kind that are drawn in several
// ways, and of extreme_fuzz.cpp in FOLDER/extreme, numbers from which it makes fields. All are smaller than 8 KiB, so
// that a fuzzer runs many a second.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "chord/extreme_chords.h"
#include "surface/extreme_surfaces.h"
#include "surface/gloss_bytes.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;

constexpr int kSeeds = 6;  // a field
constexpr int kControlBytes = 48;
constexpr uint32_t kExtremeFields = 12;
constexpr int kExtremeSeeds = 40, kExtremeBytes = 600;

// Some bytes, and then chance.
void write_seed(const std::filesystem::path& path, const test::Bytes& field, int chance_bytes)
{
    static std::minstd_rand random(1);
    std::ofstream out(path, std::ios::binary);
    for (const uint8_t b : field) out.put(static_cast<char>(b));
    for (int byte = 0; byte < chance_bytes; ++byte) out.put(static_cast<char>(random() >> 8));
}

void write_seeds(const std::filesystem::path& folder, const std::string& name, const test::Bytes& field)
{
    for (int k = 0; k < kSeeds; ++k) write_seed(folder / (name + '-' + std::to_string(k)), field, kControlBytes);
}

// As test::bumpy_ball, with fewer patches: view tables on most vertices, a triangle through it and one without area.
test::TestSurface small_ball()
{
    test::TestSurface s = test::BumpyBall(2).take();
    const auto last = static_cast<uint32_t>(s.vertices.size()) - 1;
    s.patches.push_back({0, last / 2, last});
    s.patches.push_back({1, 2, 2});
    s.viewed = last - 8;
    test::put_texels(s);
    return s;
}

void write_extremes(const std::filesystem::path& folder)
{
    test::Choices choices(1);
    test::ExtremeChords chords(choices, test::kSmallChord);
    test::ExtremeSurfaces surfaces(choices, test::kSmallSurface);
    for (uint32_t k = 0; k < kExtremeFields; ++k)
        write_seed(folder / ("extreme-" + std::to_string(k)),
                   k % 4 == 0   ? chords.next()
                   : k % 4 == 1 ? surfaces.next()
                   : k % 4 == 2 ? surfaces.next_see_through()
                                : surfaces.next_with_gloss(),
                   kControlBytes);
}

void write_fields(const std::filesystem::path& folder)
{
    constexpr uint32_t kSizes[][3] = {{20, 24, 20}, {5, 9, 3}, {36, 22, 30}};  // M, N, origins used
    for (uint32_t texel = 0; texel < detail::format::kTexelFormats; ++texel) {
        for (const uint32_t(&size)[3] : kSizes) {
            test::TestLayout layout;
            layout.origins = size[0];
            layout.directions = size[1];
            layout.used_origins = size[2];
            layout.texel = static_cast<TexelFormat>(texel);
            write_seeds(folder, "chord-" + std::to_string(texel) + '-' + std::to_string(size[0]),
                        test::sample_field(layout));
        }
    }
    write_seeds(folder, "ball", test::surface_file(small_ball()));
    const auto turns = [](uint32_t span) {
        return test::TestPart{test::placed(test::ball(1, 6), 0.3, {0.4, 0, 0}), "p", false, {0, 0, 1}, {}, 0, span};
    };
    test::TestPart slides = turns(1 << 20);
    slides.slides = true;
    write_seeds(folder, "parts", test::mover_file(test::mover(test::ball(1, 3), {turns(UINT32_MAX), slides}, 2)));
    test::TestSurface few = test::ball(1, 3);
    few.code_bits = 2;
    write_seeds(folder, "states",
                test::lit_file(test::mover(few, {turns(UINT32_MAX)}), {{"base"}, {"lamp", 30}, {"x"}}));
    few.viewed = static_cast<uint32_t>(few.vertices.size());
    write_seeds(folder, "gloss", test::glossy_file(few, test::any_gloss(few)));
    write_seeds(folder, "sheet", test::surface_file(test::wavy_sheet()));
    write_extremes(folder);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: lumi_make_fuzz_corpus FOLDER\n", stderr);
        return 64;
    }
    const std::filesystem::path fields = std::filesystem::path(argv[1]) / "field";
    const std::filesystem::path extremes = std::filesystem::path(argv[1]) / "extreme";
    std::filesystem::create_directories(fields);
    std::filesystem::create_directories(extremes);
    write_fields(fields);
    for (int k = 0; k < kExtremeSeeds; ++k) write_seed(extremes / std::to_string(k), {}, kExtremeBytes);
    return 0;
}
