// SPDX-License-Identifier: MIT
// lumi_make_fuzz_corpus FOLDER: seeds of field_fuzz.cpp, small fields of each kind that are drawn in several ways.
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

void write_all(const std::filesystem::path& folder)
{
    constexpr uint32_t kSizes[][3] = {{64, 96, 64}, {5, 9, 3}, {120, 70, 100}};  // M, N, origins used
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
    write_seeds(folder, "surface", test::surface_file(test::bumpy_ball()));
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
