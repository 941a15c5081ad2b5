// SPDX-License-Identifier: MIT
// Fuzz target: weights of a filter from a stranger. The first byte chooses what the others are: a whole file, or the
// settings and then the numbers, in a container whose sums are right, as no fuzzer guesses them.
#include <algorithm>

#include "filter/weights_file.h"
#include "store/section_writer.h"
#include "terminal/failure.h"

namespace
{

using namespace lumi;

std::string sealed(const std::string& bytes)
{
    const size_t cut = std::min<size_t>(bytes.size(), filter::kSettingsBytes);
    const auto at = [&](size_t k) { return bytes.begin() + static_cast<std::string::difference_type>(k); };
    std::vector<uint8_t> settings(at(0), at(cut)), numbers(at(cut), bytes.end());
    const std::vector<uint8_t> head =
        baker::file_head({{filter::kSettingsSection, settings.size(), baker::crc_of(settings)},
                          {filter::kNumbersSection, numbers.size(), baker::crc_of(numbers)}});
    std::string file(head.begin(), head.end());
    for (std::vector<uint8_t>* section : {&settings, &numbers}) {
        section->resize(baker::aligned(section->size()));
        file.append(section->begin(), section->end());
    }
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    if (size == 0) return 0;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        const filter::Weights weights = filter::decode((data[0] & 1) == 0 ? bytes : sealed(bytes), "weights");
        if (filter::decode(filter::encode(weights), "weights").numbers.size() != weights.numbers.size())
            __builtin_trap();
    } catch (const tools::Failure&) {
    }
    return 0;
}
