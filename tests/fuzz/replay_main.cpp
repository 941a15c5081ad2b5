// SPDX-License-Identifier: MIT
// Runs a fuzz target over the files of the folders that the command line names, without a fuzzer: any compiler will do.
// Each file is also run with some bytes changed, the same ones every time.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

constexpr int kChangedRuns = 200;  // a file

std::vector<uint8_t> bytes_of(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void run_changed(std::vector<uint8_t> bytes, uint32_t seed)
{
    std::minstd_rand random(seed + 1);
    for (uint32_t k = 1 + random() % 8; k > 0 && !bytes.empty(); --k) {
        bytes[random() % bytes.size()] = static_cast<uint8_t>(random() >> 8);
    }
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

}  // namespace

int main(int argc, char** argv)
{
    size_t files = 0;
    for (int k = 1; k < argc; ++k) {
        for (const auto& entry : std::filesystem::directory_iterator(argv[k])) {
            const std::vector<uint8_t> bytes = bytes_of(entry.path());
            LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
            for (int run = 0; run < kChangedRuns; ++run) run_changed(bytes, static_cast<uint32_t>(run));
            ++files;
        }
    }
    std::printf("%zu files, %zu executions without a finding\n", files, files * (1 + kChangedRuns));
    return files == 0 ? 1 : 0;
}
