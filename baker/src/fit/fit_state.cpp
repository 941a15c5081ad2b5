// SPDX-License-Identifier: MIT
#include "fit/fit_state.h"

#include <algorithm>
#include <utility>

#include "lumi/baker/bake.h"
#include "util/byte_stream.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kStateTag = 0x55465253;

// Numbers of few bytes where they are small (LEB128), signed ones in zigzag order.
void put_number(ByteWriter& out, uint64_t v)
{
    for (; v >= 0x80; v >>= 7) out.put8(static_cast<uint8_t>(v | 0x80));
    out.put8(static_cast<uint8_t>(v));
}
uint64_t get_number(ByteReader& in)
{
    uint64_t v = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const uint8_t byte = in.get8();
        v |= uint64_t{byte & 0x7Fu} << shift;
        if (byte < 0x80) break;
    }
    return v;
}
void put_signed(ByteWriter& out, int64_t v)
{
    put_number(out, static_cast<uint64_t>(v) << 1 ^ static_cast<uint64_t>(v >> 63));
}
int64_t get_signed(ByteReader& in)
{
    const uint64_t v = get_number(in);
    return static_cast<int64_t>(v >> 1) ^ -static_cast<int64_t>(v & 1);
}

// Returns the pilot's result as bytes to keep.
std::vector<uint8_t> pilot_bytes(const FitModel& expected, const std::vector<uint32_t>& lines)
{
    ByteWriter out;
    out(expected, lines);
    return out.bytes();
}

void put(ByteWriter& out, const PatchSums& sums)
{
    for (const TexelSums& texel : sums.texels) {
        put_number(out, texel.count);
        for (size_t c = 0; c < 3; ++c) {
            put_signed(out, texel.target[c]);
            put_signed(out, texel.predicted[c]);
            put_signed(out, texel.cut_off[c]);
            put_signed(out, texel.light[c]);
        }
        put_number(out, texel.scatter);
        put_number(out, texel.whole_scatter);
    }
    for (const uint32_t crossed : sums.crossed) put_number(out, crossed);
    for (const std::array<int64_t, 3>& target : sums.targets)
        for (const int64_t channel : target) put_signed(out, channel);
    uint64_t pairs = 0;
    sums.pairs.each([&](uint32_t, uint32_t, int64_t) { ++pairs; });
    put_number(out, pairs);
    sums.pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
        put_number(out, a * kPatchNodes + b);
        put_signed(out, sum);
    });
}

// A shard may hold anything: only its seal was checked.
void add_to(int64_t& sum, int64_t more)
{
    if (__builtin_add_overflow(sum, more, &sum))
        throw BakeError("the sums of a shard or checkpoint are beyond all bounds; bake it again");
}

void add(ByteReader& in, PatchSums& sums)
{
    for (TexelSums& texel : sums.texels) {
        texel.count += static_cast<uint32_t>(get_number(in));
        require_few_enough(texel.count);
        for (size_t c = 0; c < 3; ++c) {
            add_to(texel.target[c], get_signed(in));
            add_to(texel.predicted[c], get_signed(in));
            add_to(texel.cut_off[c], get_signed(in));
            add_to(texel.light[c], get_signed(in));
        }
        texel.scatter += get_number(in);
        texel.whole_scatter += get_number(in);
    }
    for (uint32_t& crossed : sums.crossed) crossed += static_cast<uint32_t>(get_number(in));
    for (std::array<int64_t, 3>& target : sums.targets)
        for (int64_t& channel : target) add_to(channel, get_signed(in));
    const uint64_t pairs = std::min<uint64_t>(get_number(in), uint64_t{kPatchNodes} * kPatchNodes);
    for (uint64_t k = 0; k < pairs; ++k) {
        const uint64_t key = std::min<uint64_t>(get_number(in), kPatchNodes * kPatchNodes - 1);
        sums.pairs.add(static_cast<uint16_t>(key / kPatchNodes), static_cast<uint16_t>(key % kPatchNodes),
                       get_signed(in));
    }
}

}  // namespace

std::vector<uint8_t> encode(const FitState& state)
{
    ByteWriter out;
    out.put32(kStateTag);
    out.put32(state.batches);
    out.put32(state.wanted);
    out.put32(state.shape.layout.texels);
    out.put64(state.paths);
    out(state.expected, state.lines);
    for (const PatchSums& patch : state.sums.patches()) put(out, patch);
    return out.bytes();
}

bool is_complete(const std::vector<uint8_t>& state)
{
    ByteReader in(state.data(), state.size());
    const uint32_t tag = in.get32(), batches = in.get32();
    return tag == kStateTag && batches == in.get32();
}

bool add_encoded(const std::vector<uint8_t>& bytes, FitState& state)
{
    ByteReader in(bytes.data(), bytes.size());
    const uint32_t tag = in.get32(), batches = in.get32();
    in.get32();  // what is wanted
    if (tag != kStateTag || in.get32() != state.shape.layout.texels) return false;
    state.batches += batches;
    state.paths += in.get64();
    FitModel expected;
    std::vector<uint32_t> lines;
    in(expected, lines);
    if (!is_of(expected, state.shape) || lines.size() != state.shape.mesh.patches.size()) return false;
    if (state.has_pilot && pilot_bytes(expected, lines) != pilot_bytes(state.expected, state.lines)) return false;
    state.expected = std::move(expected);
    state.lines = std::move(lines);
    state.has_pilot = true;
    for (PatchSums& patch : state.sums.patches()) add(in, patch);
    return true;
}

}  // namespace lumi::baker
