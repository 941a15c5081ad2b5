// SPDX-License-Identifier: MIT
// Composes files of surface fields with light states, written from surface/format.h.
#pragma once

#include "parts_bytes.h"

namespace lumi::test
{

struct TestState {
    std::string name;
    uint32_t scale_q4 = 16;
};

inline std::vector<TestState> two_states()
{
    return {{"base", 16}, {"lamp", 40}};
}

// The section of states says this of a mesh; levels look like chance.
struct TestLight {
    std::vector<TestState> states;
    Bytes palettes, glasses, nodes, means, gains;  // of all states; `means` and `gains` of all vertices
};

inline Bytes scattered_bytes(size_t count, uint32_t seed)
{
    Bytes b;
    for (uint32_t k = 0; k < count; ++k) b.push_back(static_cast<uint8_t>(scattered(k + (seed << 16))));
    return b;
}

inline TestLight light_of(const TestSurface& s, const std::vector<TestState>& states)
{
    using namespace detail::format;
    const size_t count = states.size();
    return {states,
            scattered_bytes(count * state::kPaletteBytes, 1),
            scattered_bytes(count * state::kPaletteBytes, 2),
            scattered_bytes(s.viewed == 0 ? 0 : count * view_colours_bytes(s.code_bits), 3),
            scattered_bytes(s.viewed, 4),
            scattered_bytes(count * s.viewed * kGainBytes, 5)};
}

inline TestSection states_section(const TestLight& light, bool has_glass)
{
    Bytes b;
    put32(b, static_cast<uint32_t>(light.states.size()));
    for (const TestState& state : light.states) {
        b.insert(b.end(), state.name.begin(), state.name.end());
        b.resize(b.size() + detail::format::state::kNameBytes - state.name.size());
        put32(b, state.scale_q4);
    }
    const auto add = [&](const Bytes& bytes) { b.insert(b.end(), bytes.begin(), bytes.end()); };
    add(light.palettes);
    if (has_glass) add(light.glasses);
    add(light.nodes);
    const size_t gains = light.states.size() * detail::format::kGainBytes;
    for (size_t v = 0; v < light.means.size(); ++v) {
        b.push_back(light.means[v]);
        for (size_t k = 0; k < gains; ++k) b.push_back(light.gains[v * gains + k]);
    }
    return {detail::format::kStateSection, 0, b};
}

// Adds it to sections that were written before.
inline Bytes file_with_states(std::vector<TestSection> sections, const TestLight& light)
{
    bool has_glass = false;
    for (const TestSection& s : sections) has_glass = has_glass || s.type == detail::format::kSeeThroughSection;
    sections.push_back(states_section(light, has_glass));
    return file_of(sections);
}

inline Bytes lit_file(const TestMover& m, const std::vector<TestState>& states = two_states())
{
    return file_with_states(mover_sections(m), light_of(m.all, states));
}

inline TestSurface ball_with_tables(uint32_t bits = 4)
{
    TestSurface s = bumpy_ball();
    s.code_bits = bits;
    return s;
}

inline Bytes lit_ball_file(const std::vector<TestState>& states = two_states())
{
    return file_with_states(surface_sections(ball_with_tables()), light_of(ball_with_tables(), states));
}

inline std::vector<TestState> four_states()
{
    return {{"base", 16}, {"lamp", 255}, {"a lamp by the bed, in green", 19}, {"d", 64}};
}

}  // namespace lumi::test
