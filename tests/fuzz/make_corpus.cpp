// SPDX-License-Identifier: MIT
// lumi_make_fuzz_corpus FOLDER: seeds of field_fuzz.cpp, fields of each kind that are drawn in several ways. All are
// smaller than 4 KiB, so that a fuzzer runs many a second.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "surface/surface_bytes.h"

namespace
{

using namespace lumi;

constexpr int kSeeds = 6;  // a field
constexpr int kControlBytes = 48;

void write_seeds(const std::filesystem::path& folder, const std::string& name, const test::Bytes& field)
{
    static std::minstd_rand random(1);
    for (int k = 0; k < kSeeds; ++k) {
        std::ofstream out(folder / (name + '-' + std::to_string(k)), std::ios::binary);
        for (const uint8_t b : field) out.put(static_cast<char>(b));
        for (int byte = 0; byte < kControlBytes; ++byte) out.put(static_cast<char>(random() >> 8));
    }
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

void write_all(const std::filesystem::path& folder)
{
    constexpr uint32_t kSizes[][3] = {{20, 24, 20}, {5, 9, 3}, {36, 22, 30}};  // M, N, origins used
    for (uint32_t texel = 0; texel < format::kTexelFormats; ++texel) {
        for (const uint32_t(&size)[3] : kSizes) {
            test::TestLayout layout;
            layout.origins = size[0];
            layout.directions = size[1];
            layout.used_origins = size[2];
            layout.texel = static_cast<format::TexelFormat>(texel);
            write_seeds(folder, "chord-" + std::to_string(texel) + '-' + std::to_string(size[0]),
                        test::sample_field(layout));
        }
    }
    write_seeds(folder, "ball", test::surface_file(small_ball()));
    write_seeds(folder, "sheet", test::surface_file(test::wavy_sheet()));
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: lumi_make_fuzz_corpus FOLDER\n", stderr);
        return 64;
    }
    std::filesystem::create_directories(argv[1]);
    write_all(argv[1]);
    return 0;
}
