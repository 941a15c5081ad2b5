// SPDX-License-Identifier: MIT
// Mixes the light of states by their weights: palettes when a weight changes, vertices in every frame.
#include "lumi/surface/states.h"

#include "lumi/surface/parts.h"
#include "math/generate.h"
#include "math/reciprocal.h"
#include "surface/owners.h"
#include "surface/view_light.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;

constexpr uint32_t kWordsAWeight = 2;
constexpr uint32_t kChannels = 3;
constexpr int32_t kWhiteQ2 = 4 * 255;

// Linear light: white is 2^15 in the table of levels and 2^17 in sums.
constexpr uint32_t kWhiteQ15 = 1u << 15, kWhiteQ17 = 1u << 17;
// Below this light a level is a multiple of it; above there are so many steps to each doubling of light.
constexpr uint32_t kLinearLog2 = 8, kStepsLog2 = 4, kDoublings = 17 - kLinearLog2;
constexpr uint32_t kSlopeQ16 = 105427;  // 12.92 · 255 · 2^6 / 2^17, Q16

struct Levels {
    uint16_t light_q15[kPaletteEntries + 1];  // of every level; the last is read, but not used
    uint16_t level_q6[(kDoublings << kStepsLog2) + 1];
};

// v^(1/n), 0 < v <= 1.
constexpr double nth_root(double v, int n)
{
    double y = 1;
    for (int step = 0; step < 64; ++step) {
        double power = 1;
        for (int k = 1; k < n; ++k) power *= y;
        y += (v / power - y) / n;
    }
    return y;
}

// IEC 61966-2-1.
constexpr double light_of(double level)
{
    if (level <= 0.04045) return level / 12.92;
    const double x = (level + 0.055) / 1.055;
    return x * x * nth_root(x * x, 5);
}
constexpr double level_of(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * nth_root(light * light * light * light * light, 12) - 0.055;
}

constexpr Levels make_levels()
{
    Levels levels{};
    for (uint32_t k = 0; k < kPaletteEntries; ++k)
        levels.light_q15[k] = static_cast<uint16_t>(light_of(k / 255.0) * kWhiteQ15 + 0.5);
    for (uint32_t k = 0; k <= kDoublings << kStepsLog2; ++k) {
        const uint32_t steps = (1u << kStepsLog2) + (k & ((1u << kStepsLog2) - 1)), doubling = k >> kStepsLog2;
        const double light = static_cast<double>(steps << doubling << (kLinearLog2 - kStepsLog2)) / kWhiteQ17;
        levels.level_q6[k] = static_cast<uint16_t>(level_of(light) * 255 * 64 + 0.5);
    }
    return levels;
}

constexpr Levels kLevels = make_levels();

LUMI_ALWAYS_INLINE uint32_t light_of_level(int32_t level_q2)
{
    const uint16_t* const light = kLevels.light_q15 + (level_q2 >> 2);
    return light[0] + (static_cast<uint32_t>(light[1] - light[0]) * static_cast<uint32_t>(level_q2 & 3) >> 2);
}

// Returns the level of a sum of light: white for all that is more.
LUMI_ALWAYS_INLINE uint32_t level_q6_of(uint32_t light_q17)
{
    if (light_q17 >= kWhiteQ17) return 255 << 6;
    if (light_q17 < 1u << kLinearLog2) return (light_q17 * kSlopeQ16 + (1 << 15)) >> 16;
    const Normalized n = normalized(light_q17);
    constexpr uint32_t kRestBits = 31 - kStepsLog2;
    const uint32_t doubling = 31 - kLinearLog2 - static_cast<uint32_t>(n.leading);
    const uint32_t step = (n.v >> kRestBits) - (1u << kStepsLog2), rest_q16 = n.v << (1 + kStepsLog2) >> 16;
    const uint16_t* const level = kLevels.level_q6 + (doubling << kStepsLog2) + step;
    return level[0] + (static_cast<uint32_t>(level[1] - level[0]) * rest_q16 >> 16);
}

// Memory of states, behind that of see-through patches and parts: weights, the palette, see-through parts.
uint32_t* words_of(const SurfaceField& field, const SurfaceMemory& memory)
{
    return memory.features + see_through_words(field.see_through_count) + part_words(field.part_count);
}

StateWeight& weight_of(const SurfaceField& field, const SurfaceMemory& memory, uint32_t state)
{
    return *reinterpret_cast<StateWeight*>(words_of(field, memory) + kWordsAWeight * state);
}

uint8_t* palette_of(const SurfaceField& field, const SurfaceMemory& memory)
{
    return reinterpret_cast<uint8_t*>(words_of(field, memory) + kWordsAWeight * field.state_count);
}

// How much of the light that a state's entries say is added: weight times scale, at most 16 bits.
struct Mix {
    uint32_t count;
    uint32_t factor_q12[kMaxStates][kChannels];
};

Mix mix_of(const SurfaceField& field, const SurfaceMemory& memory)
{
    Mix mix{};
    mix.count = field.state_count;
    for (uint32_t k = 0; k < mix.count; ++k) {
        const uint32_t scale_q4 = field.states[kStatesHeaderBytes + k * kStateBytes + state::kScaleAt];
        const StateWeight& weight = weight_of(field, memory, k);
        const auto factor = [&](uint32_t weight_q12) { return (weight_q12 * scale_q4 + 8) >> 4; };
        mix.factor_q12[k][0] = factor(weight.r_q12);
        mix.factor_q12[k][1] = factor(weight.g_q12);
        mix.factor_q12[k][2] = factor(weight.b_q12);
    }
    return mix;
}

LUMI_ALWAYS_INLINE uint32_t scaled(uint32_t factor_q12, uint32_t light_q15)
{
    return factor_q12 * light_q15 >> 10;  // Q17
}

// Mixes the palettes that lie behind `entries`, one for each state, into every `stride` bytes of `out`.
void mix_palette(const Mix& mix, const uint8_t* entries, uint8_t* out, uint32_t stride)
{
    for (uint32_t n = 0; n < kPaletteEntries; ++n, out += stride) {
        for (uint32_t c = 0; c < kChannels; ++c, ++entries) {
            uint32_t light_q17 = 0;
            for (uint32_t k = 0; k < mix.count; ++k)
                light_q17 += scaled(mix.factor_q12[k][c], kLevels.light_q15[entries[k * state::kPaletteBytes]]);
            out[c] = static_cast<uint8_t>((level_q6_of(light_q17) + 32) >> 6);
        }
    }
}

// Frames that keep their body must not keep this light.
void mix_all(SurfaceField& field, const SurfaceMemory& memory)
{
    const Mix mix = mix_of(field, memory);
    uint8_t* const palette = palette_of(field, memory);
    mix_palette(mix, field.states + states_palettes_at(mix.count), palette, state::kEntryBytes);
    if (field.see_through_count != 0)
        mix_palette(mix, field.states + states_see_through_at(mix.count),
                    palette + state::kPaletteBytes + see_through::kPaletteAt, see_through::kEntryBytes);
    if (may_move(field, memory)) moving_parts(field, memory).has_body = false;
}

bool has_memory(const SurfaceField& field, const SurfaceMemory& memory)
{
    return field.state_count != 0 && memory.features != nullptr;
}

// Whether a field reads palettes that were mixed here.
bool are_mixed(const SurfaceField& field, const SurfaceMemory& memory)
{
    return has_memory(field, memory) && field.palette == palette_of(field, memory);
}

// What lighting vertices needs of a frame.
struct StateLight {
    const SurfaceField& field;
    const uint8_t *palettes, *mixed, *nodes, *vertices;
    uint32_t node_bytes;
    Mix mix;
};

// The level of a channel of a vertex's mean, and what its view table adds to it.
LUMI_ALWAYS_INLINE int32_t seen_q2(uint32_t mean, int32_t sum, uint32_t gain)
{
    // Weights have 8 bits of fraction, gains 6, the result 2.
    const int32_t level = static_cast<int32_t>(4 * mean) + ((sum * static_cast<int32_t>(gain) + 2048) >> 12);
    return level < 0 ? 0 : level > kWhiteQ2 ? kWhiteQ2 : level;
}

uint32_t colour_by_states(const StateLight& light, const SurfaceProjection& projection, uint32_t vertex)
{
    LUMI_TALLY(Work::lit, 1);
    const uint32_t bits = light.field.code_bits;
    const uint8_t* const record = light.field.views + vertex * view_bytes(bits);
    const ViewTaps taps = taps_of_vertex(light.field, projection, vertex, record + view_turn_at(bits));
    const uint8_t* tap[3];
    for (int m = 0; m < 3; ++m) {
        const uint32_t node = taps.node[m];
        tap[m] = light.nodes + ((node << bits) + code_of(record, node, bits)) * kNodeColourBytes;
    }
    const uint8_t* gain = light.vertices + vertex * state_view_bytes(light.mix.count);
    const uint32_t mean = *gain++ * state::kEntryBytes;
    const uint8_t* entry = light.palettes + mean;
    uint32_t light_q17[kChannels] = {};
    for (uint32_t k = 0; k < light.mix.count; ++k) {
        for (uint32_t c = 0; c < kChannels; ++c) {
            const int32_t sum = taps.weight_q8[0] * signed_byte(tap[0] + c) +
                                taps.weight_q8[1] * signed_byte(tap[1] + c) +
                                taps.weight_q8[2] * signed_byte(tap[2] + c);
            light_q17[c] += scaled(light.mix.factor_q12[k][c], light_of_level(seen_q2(entry[c], sum, gain[c])));
        }
        for (const uint8_t*& at : tap) at += light.node_bytes;
        gain += kGainBytes;
        entry += state::kPaletteBytes;
    }
    const auto difference_q2 = [&](uint32_t c) {
        return static_cast<int32_t>((level_q6_of(light_q17[c]) + 8) >> 4) - 4 * int32_t{light.mixed[mean + c]};
    };
    return packed_fields(difference_q2(0), difference_q2(1), difference_q2(2));
}

// A vertex of a triangle that was listed has the colour 0: no table of the file has lit it.
void light_vertices(const SurfaceFrame& frame, const StateLight& light, const SurfaceProjection& projection,
                    const NumberRange& vertices)
{
    for (uint32_t k = vertices.begin; k < vertices.end; ++k)
        if (frame.memory.vertices[k].colour == 0)
            frame.memory.vertices[k].colour = colour_by_states(light, projection, k);
}

}  // namespace

void detail::put_states(SurfaceFrame& frame)
{
    const SurfaceField& field = frame.field;
    if (!are_mixed(field, frame.memory)) return;
    if (frame.columns.begin == frame.columns.end) return;  // nothing shows, and vertices may not be known
    const uint8_t* const nodes = field.states + states_views_at(field.state_count, field.has_states_of_see_through);
    const uint32_t node_bytes = view_colours_bytes(field.code_bits);
    const StateLight light = {field,
                              field.states + states_palettes_at(field.state_count),
                              field.palette,
                              nodes,
                              nodes + field.state_count * node_bytes,
                              node_bytes,
                              mix_of(field, frame.memory)};
    for (uint32_t owner = 0; owner <= field.part_count; ++owner) {
        const SurfaceProjection& projection =
            owner == 0 ? frame.projection : moving_part(moving_parts(field, frame.memory), owner - 1).projection;
        light_vertices(frame, light, projection, owner_ranges(field, owner).viewed);
    }
}

void reset_states(SurfaceField& field, const SurfaceMemory& memory)
{
    if (!has_memory(field, memory)) return;
    constexpr uint16_t kFull = kFullWeight;
    for (uint32_t k = 0; k < field.state_count; ++k) weight_of(field, memory, k) = {kFull, kFull, kFull};
    uint8_t* const palette = palette_of(field, memory);
    if (field.see_through_count != 0) {
        uint8_t* const see_through = palette + state::kPaletteBytes;
        for (uint32_t k = 0; k < kSeeThroughBytes; ++k) see_through[k] = field.see_through[k];
        field.see_through = see_through;
    }
    field.palette = palette;
    field.lit_count = 0;
    mix_all(field, memory);
}

bool set_state(SurfaceField& field, const SurfaceMemory& memory, uint32_t state, const StateWeight& weight)
{
    if (!has_memory(field, memory) || state >= field.state_count) return false;
    if (!are_mixed(field, memory)) reset_states(field, memory);
    const auto within = [](uint16_t w) { return w < kFullWeight ? w : static_cast<uint16_t>(kFullWeight); };
    const StateWeight next = {within(weight.r_q12), within(weight.g_q12), within(weight.b_q12)};
    StateWeight& now = weight_of(field, memory, state);
    if (now.r_q12 == next.r_q12 && now.g_q12 == next.g_q12 && now.b_q12 == next.b_q12) return true;
    now = next;
    mix_all(field, memory);
    return true;
}

}  // namespace lumi
