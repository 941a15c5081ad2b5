// SPDX-License-Identifier: MIT
// Fuzz target: a shard or checkpoint from a stranger, merged. The first byte chooses what the others are: the file with
// its head's checksum made right; the same with the seals of rows made right, as no fuzzer guesses them; or a basis and
// a state, divided at the place that two bytes name.
#include <algorithm>
#include <map>

#include "chord/field_writer.h"
#include "fuzz_folder.h"
#include "lumi/baker/bake.h"
#include "lumi/baker/merge.h"
#include "lumi/detail/crc32.h"
#include "store/block_file.h"
#include "surface/surface_file_store.h"

namespace
{

using namespace lumi::baker;

// Today's lumi begins a file with these, and with the sum of the head.
void reseal(std::string& file)
{
    if (file.size() < kHeadBytes) return;
    static const std::vector<uint8_t> head = encode_head({});
    constexpr std::ptrdiff_t kBegin = 8 + 4;  // name and version
    std::copy_n(head.begin(), kBegin, file.begin());
    const size_t at = kHeadBytes - kSealBytes;
    const uint32_t crc = lumi::detail::crc32(0, reinterpret_cast<const uint8_t*>(file.data()), at);
    for (size_t k = 0; k < kSealBytes; ++k) file[at + k] = static_cast<char>(crc >> (8 * k));
}

void reseal_rows(const std::filesystem::path& path)
{
    BlockFile file(std::make_unique<PosixFile>(path, PosixFile::Mode::update));
    if (!std::holds_alternative<BakeSettings>(file.identity().settings)) return;
    RowFile rows(file);
    Palette palette{};
    static_cast<void>(rows.read_palette(palette));
    if (rows.layout().texel == lumi::TexelFormat::palette8) rows.write_palette(palette);
    std::vector<uint8_t> row;
    for (uint32_t slot = 0; slot < rows.slots_within_file(); ++slot) {
        static_cast<void>(rows.read_row(slot, row));  // gives what is there
        rows.write_row(slot, row);
    }
}

void merge(const std::string& bytes, bool has_right_rows)
{
    static lumi::fuzz::FuzzFolder folder;
    std::string file = bytes;
    reseal(file);
    const std::filesystem::path& shard = folder.write(has_right_rows ? "b.shard" : "a.shard", file);
    if (has_right_rows) reseal_rows(shard);
    merge_shards({shard}, folder.at("out.lumi"));
}

// Made once: its powers took a tenth of the time.
const EncodedTone& tone_of(ToneCurve curve)
{
    static std::map<ToneCurve, EncodedTone> tones;
    return tones.try_emplace(curve, curve).first->second;
}

void decode(const uint8_t* data, size_t size)
{
    if (size < 2) return;
    const size_t end = std::min<size_t>(2 + data[0] + 256u * data[1], size);
    std::optional<FitBasis> basis = decode_basis({data + 2, data + end});
    if (!basis) return;
    const FitShape shape(std::move(basis->mesh), basis->densities, std::move(basis->see_through),
                         std::move(basis->gloss));
    FitState state(shape, tone_of(basis->tone));
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
            merge({reinterpret_cast<const char*>(data) + 1, size - 1}, (data[0] & 2) != 0);
        else
            decode(data + 1, size - 1);
    } catch (const BakeError&) {
    }
    return 0;
}
