// SPDX-License-Identifier: MIT
// Mixes the light of states by their weights: palettes when a weight changes, vertices in every frame.
#include "lumi/surface/states.h"

#include "lumi/surface/parts.h"
#include "surface/levels.h"
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

// A state whose light shows, and how much of what its entries say is added: weight times scale, at most 16 bits.
struct ShownState {
    uint32_t palette_at, nodes_at, gains_at;  // behind those of state 0, and in a vertex's bytes
    uint32_t factor_q12[kChannels];
};

struct Mix {
    uint32_t count;
    ShownState state[kMaxStates];
};

Mix mix_of(const SurfaceField& field, const SurfaceMemory& memory)
{
    Mix mix;
    mix.count = 0;
    for (uint32_t k = 0; k < field.state_count; ++k) {
        const uint32_t scale_q4 = field.states[kStatesHeaderBytes + k * kStateBytes + state::kScaleAt];
        const StateWeight& weight = weight_of(field, memory, k);
        if ((weight.r_q12 | weight.g_q12 | weight.b_q12) == 0) continue;
        const auto factor = [&](uint32_t weight_q12) { return (weight_q12 * scale_q4 + 8) >> 4; };
        mix.state[mix.count++] = {k * state::kPaletteBytes,
                                  k * view_colours_bytes(field.code_bits),
                                  1 + k * kGainBytes,
                                  {factor(weight.r_q12), factor(weight.g_q12), factor(weight.b_q12)}};
    }
    return mix;
}

LUMI_ALWAYS_INLINE uint32_t light_q17_of(uint32_t factor_q12, uint32_t level_q2)
{
    return factor_q12 * kLevels.light_q15[level_q2] >> 10;
}

// Mixes the palettes that lie behind `entries`, one for each state, into every `stride` bytes of `out`.
void mix_palette(const Mix& mix, const uint8_t* entries, uint8_t* out, uint32_t stride)
{
    for (uint32_t n = 0; n < kPaletteEntries; ++n, out += stride) {
        for (uint32_t c = 0; c < kChannels; ++c, ++entries) {
            uint32_t light_q17 = 0;
            for (uint32_t k = 0; k < mix.count; ++k) {
                const ShownState& shown = mix.state[k];
                light_q17 += light_q17_of(shown.factor_q12[c], 4u * entries[shown.palette_at]);
            }
            out[c] = static_cast<uint8_t>((level_q6_of(light_q17) + 32) >> 6);
        }
    }
}

// Frames that keep their body must not keep this light.
void mix_all(SurfaceField& field, const SurfaceMemory& memory)
{
    const Mix mix = mix_of(field, memory);
    uint8_t* const palette = palette_of(field, memory);
    mix_palette(mix, field.states + states_palettes_at(field.state_count), palette, state::kEntryBytes);
    if (field.see_through_count != 0)
        mix_palette(mix, field.states + states_see_through_at(field.state_count),
                    palette + state::kPaletteBytes + see_through::kPaletteAt, see_through::kEntryBytes);
    if (may_move(field, memory)) moving_parts(field, memory).has_body = false;
}

bool are_same(const StateWeight& a, const StateWeight& b)
{
    return a.r_q12 == b.r_q12 && a.g_q12 == b.g_q12 && a.b_q12 == b.b_q12;
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

// Lighting vertices needs this of a frame.
struct StateLight {
    const SurfaceField& field;
    const uint8_t *palettes, *nodes, *vertices;
    uint32_t vertex_bytes;
    Mix mix;
};

// The level of a channel of a vertex's mean, and what its view table adds to it.
LUMI_ALWAYS_INLINE uint32_t seen_q2(uint32_t mean, int32_t sum, uint32_t gain)
{
    // Weights have 8 bits of fraction, gains 6, the result 2, rounded down.
    const int32_t level = (sum * static_cast<int32_t>(gain) + static_cast<int32_t>(mean << 14)) >> 12;
    if (__builtin_expect(static_cast<uint32_t>(level) > static_cast<uint32_t>(kMostQ2), 0))
        return level < 0 ? 0 : kMostQ2;
    return static_cast<uint32_t>(level);
}

LUMI_ALWAYS_INLINE uint32_t colour_by_states(const StateLight& light, const SurfaceProjection& projection,
                                             uint32_t vertex)
{
    LUMI_TALLY(Work::lit, 1);
    const uint32_t bits = light.field.code_bits;
    const uint8_t* const record = light.field.views + vertex * view_bytes(bits);
    const ViewTaps taps = taps_of_vertex(light.field, projection, vertex, record + view_turn_at(bits));
    const auto tap = [&](int m) __attribute__((always_inline))
    {
        const uint32_t node = taps.node[m];
        return light.nodes + ((node << bits) + code_of(record, node, bits)) * kNodeColourBytes;
    };
    const uint8_t *const tap0 = tap(0), *const tap1 = tap(1), *const tap2 = tap(2);
    const uint8_t* const own = light.vertices + vertex * light.vertex_bytes;
    const uint32_t mean = own[0] * state::kEntryBytes;
    uint32_t r_q17 = 0, g_q17 = 0, b_q17 = 0;
    for (const ShownState* shown = light.mix.state; shown != light.mix.state + light.mix.count; ++shown) {
        int32_t r = 0, g = 0, b = 0;
        const auto add = [&](const uint8_t* colour, int32_t weight) __attribute__((always_inline))
        {
            r += weight * signed_byte(colour);
            g += weight * signed_byte(colour + 1);
            b += weight * signed_byte(colour + 2);
        };
        add(tap0 + shown->nodes_at, taps.weight_q8[0]);
        add(tap1 + shown->nodes_at, taps.weight_q8[1]);
        add(tap2 + shown->nodes_at, taps.weight_q8[2]);
        const uint8_t* const gain = own + shown->gains_at;
        const uint8_t* const entry = light.palettes + shown->palette_at + mean;
        r_q17 += light_q17_of(shown->factor_q12[0], seen_q2(entry[0], r, gain[0]));
        g_q17 += light_q17_of(shown->factor_q12[1], seen_q2(entry[1], g, gain[1]));
        b_q17 += light_q17_of(shown->factor_q12[2], seen_q2(entry[2], b, gain[2]));
    }
    const uint8_t* const mixed = light.field.palette + mean;
    const auto difference_q2 = [](uint32_t light_q17, uint32_t level) {
        return static_cast<int32_t>((level_q6_of(light_q17) + 8) >> 4) - static_cast<int32_t>(4 * level);
    };
    return packed_small_fields(difference_q2(r_q17, mixed[0]), difference_q2(g_q17, mixed[1]),
                               difference_q2(b_q17, mixed[2]));
}

StateLight light_of(const SurfaceFrame& frame)
{
    const SurfaceField& field = frame.field;
    const uint32_t states = field.state_count;
    const uint8_t* const nodes = field.states + states_views_at(states, field.has_states_of_see_through);
    return {field,
            field.states + states_palettes_at(states),
            nodes,
            nodes + states * view_colours_bytes(field.code_bits),
            state_view_bytes(states),
            mix_of(field, frame.memory)};
}

// Every so many vertices. One of a triangle that was listed has the colour 0: no table of the file has lit it.
__attribute__((noinline)) void light_by_states(const SurfaceFrame& frame, const StateLight& light,
                                               const SurfaceProjection& projection, const NumberRange& vertices,
                                               uint32_t step)
{
    SurfaceVertex* at = frame.memory.vertices + vertices.begin;
    for (uint32_t k = vertices.begin; k < vertices.end; k += step, at += step)
        if (at->colour == 0) at->colour = colour_by_states(light, projection, k);
}

// Where nothing shows, vertices may not be known.
bool is_lit_by_states(const SurfaceFrame& frame)
{
    return are_mixed(frame.field, frame.memory) && frame.columns.begin != frame.columns.end;
}

}  // namespace

void detail::put_states_of_half(const SurfaceFrame& frame, uint32_t half)
{
    if (!is_lit_by_states(frame)) return;
    const uint32_t end = owner_ranges(frame.field, 0).viewed.end;
    light_by_states(frame, light_of(frame), frame.projection, {half, end}, 2);
}

void detail::put_states(const SurfaceFrame& frame)
{
    if (!is_lit_by_states(frame)) return;
    const StateLight light = light_of(frame);
    for (uint32_t owner = 0; owner <= frame.field.part_count; ++owner) {
        const SurfaceProjection& projection =
            owner == 0 ? frame.projection : moving_part(moving_parts(frame.field, frame.memory), owner - 1).projection;
        light_by_states(frame, light, projection, owner_ranges(frame.field, owner).viewed, 1);
    }
}

namespace
{

// From here on the field reads palettes that are to be mixed.
void begin_mixing(SurfaceField& field, const SurfaceMemory& memory)
{
    for (uint32_t k = 0; k < field.state_count; ++k) weight_of(field, memory, k) = default_weight(field, k);
    uint8_t* const palette = palette_of(field, memory);
    if (field.see_through_count != 0) {
        uint8_t* const see_through = palette + state::kPaletteBytes;
        for (uint32_t k = 0; k < kSeeThroughBytes; ++k) see_through[k] = field.see_through[k];
        field.see_through = see_through;
    }
    field.palette = palette;
    field.lit_count = 0;
}

}  // namespace

StateWeight default_weight(const SurfaceField& field, uint32_t state)
{
    const uint8_t* const less = field.states + kStatesHeaderBytes + state * kStateBytes + state::kDefaultAt;
    const auto weight = [&](uint32_t c) {
        return static_cast<uint16_t>((kLevels.light_q15[4 * (255u - less[c])] + 4) >> 3);
    };
    return {weight(0), weight(1), weight(2)};
}

void reset_states(SurfaceField& field, const SurfaceMemory& memory)
{
    if (!has_memory(field, memory)) return;
    begin_mixing(field, memory);
    mix_all(field, memory);
}

bool set_state(SurfaceField& field, const SurfaceMemory& memory, uint32_t state, const StateWeight& weight)
{
    if (!has_memory(field, memory) || state >= field.state_count) return false;
    const auto within = [](uint16_t w) { return w < kFullWeight ? w : static_cast<uint16_t>(kFullWeight); };
    const StateWeight next = {within(weight.r_q12), within(weight.g_q12), within(weight.b_q12)};
    if (!are_mixed(field, memory)) {
        if (are_same(next, default_weight(field, state))) return true;
        begin_mixing(field, memory);
    }
    StateWeight& now = weight_of(field, memory, state);
    if (are_same(now, next)) return true;
    now = next;
    mix_all(field, memory);
    return true;
}

}  // namespace lumi
