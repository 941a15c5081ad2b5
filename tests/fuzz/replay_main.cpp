// SPDX-License-Identifier: MIT
// Runs a fuzz target over the files of the folders that the command line names, without a fuzzer: any compiler will do.
// Each file is also run with some bytes changed, cut off or put between others, the same ones every time; those of
// folders after --as-is are not: what was found may be slow. The others are seeds, which some targets must read.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace lumi::fuzz
{
// Targets that refuse none of their seeds define it, and count what they could read.
extern size_t inputs_read __attribute__((weak));
}  // namespace lumi::fuzz

namespace
{

constexpr int kChangedRuns = 200;  // a file

std::vector<uint8_t> bytes_of(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Readers of text take these badly.
constexpr std::string_view kWords[] = {"-1", "1e999", "nan", "1e-45", "\"\"", "null", "/*", "99999999999999999999"};

void change(std::vector<uint8_t>& bytes, std::minstd_rand& random)
{
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
    const uint32_t kind = random() / 256 % 16;
    if (kind == 0) {
        bytes.erase(at, bytes.end());
    } else if (kind <= 2) {
        bytes.erase(at, at + std::min<std::ptrdiff_t>(1 + static_cast<std::ptrdiff_t>(random() % 8), bytes.end() - at));
    } else if (kind <= 5) {
        const std::string_view word = kWords[random() % std::size(kWords)];
        bytes.insert(at, word.begin(), word.end());
    } else {
        *at = static_cast<uint8_t>(random() >> 8);
    }
}

void run_changed(std::vector<uint8_t> bytes, uint32_t seed)
{
    std::minstd_rand random(seed + 1);
    for (uint32_t k = 1 + random() % 8; k > 0 && !bytes.empty(); --k) change(bytes, random);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

// False where a target that counts what it reads refuses them.
bool is_read(const std::vector<uint8_t>& bytes)
{
    const size_t* const count = &lumi::fuzz::inputs_read;
    const size_t before = count ? *count : 0;
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    return !count || *count != before;
}

}  // namespace

int main(int argc, char** argv)
{
    size_t files = 0, executions = 0;
    int changed_runs = kChangedRuns;
    for (int k = 1; k < argc; ++k) {
        if (std::string_view(argv[k]) == "--as-is") {
            changed_runs = 0;
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(argv[k])) {
            const std::vector<uint8_t> bytes = bytes_of(entry.path());
            if (!is_read(bytes) && changed_runs != 0) {
                std::fprintf(stderr, "%s: a seed that is refused\n", entry.path().c_str());
                return 1;
            }
            for (int run = 0; run < changed_runs; ++run) run_changed(bytes, static_cast<uint32_t>(run));
            ++files;
            executions += 1 + static_cast<size_t>(changed_runs);
        }
    }
    std::printf("%zu files, %zu executions without a finding\n", files, executions);
    return files == 0 ? 1 : 0;
}
