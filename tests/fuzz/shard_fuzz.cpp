// SPDX-License-Identifier: MIT
// Fuzz target: a shard or checkpoint from a stranger, merged. The first byte chooses what the others are: the file with
// its head's checksum made right; or, as no fuzzer guesses the seals of blocks, a basis and a state, divided at the
// place that two bytes name.
#include <cstring>

#include "fuzz_folder.h"
#include "lumi/baker/bake.h"
#include "lumi/baker/merge.h"
#include "lumi/detail/crc32.h"
#include "store/block_file.h"
#include "surface/fit_basis.h"

namespace
{

using namespace lumi::baker;

void reseal(std::string& file)
{
    if (file.size() < kHeadBytes) return;
    std::memcpy(file.data(), "LUMIROWS\4\0\0", 12);
    const size_t at = kHeadBytes - kSealBytes;
    const uint32_t crc = lumi::detail::crc32(0, reinterpret_cast<const uint8_t*>(file.data()), at);
    for (size_t k = 0; k < kSealBytes; ++k) file[at + k] = static_cast<char>(crc >> (8 * k));
}

void merge(const std::string& bytes)
{
    static const lumi::fuzz::FuzzFolder folder;
    std::string file = bytes;
    reseal(file);
    merge_shards({folder.write("a.shard", file)}, folder.at("out.lumi"));
}

void decode(const uint8_t* data, size_t size)
{
    if (size < 2) return;
    const size_t end = std::min<size_t>(2 + data[0] + 256u * data[1], size);
    std::optional<FitBasis> basis = decode_basis({data + 2, data + end});
    if (!basis) return;
    const FitShape shape(std::move(basis->mesh), basis->densities);
    const EncodedTone tone(basis->tone);
    FitState state(shape, tone);
    const std::vector<uint8_t> bytes(data + end, data + size);
    static_cast<void>(is_complete(bytes));
    static_cast<void>(add_encoded(bytes, state) && add_encoded(bytes, state));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    if (size == 0) return 0;
    try {
        if ((data[0] & 1) == 0)
            merge({reinterpret_cast<const char*>(data) + 1, size - 1});
        else
            decode(data + 1, size - 1);
    } catch (const BakeError&) {
    }
    return 0;
}
