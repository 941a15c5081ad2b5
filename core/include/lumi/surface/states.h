// SPDX-License-Identifier: MIT
// Light states of a surface field: each is a group of lights, and weights of them are chosen while a device runs. A
// weight is of linear light, for each channel, so it dims a lamp or gives it a colour. State 0 is all light that no
// other state names.
//
//     set_state(field, memory, 1, {2048, 1024, 0});            // memory: of SurfaceFrame, with feature_words()
//     prepare_surface<PixelRgb565, kFinest, SurfaceFeatures::all>(field, camera, mode, memory, frame);
//
// Until a weight is another one a field shows all states at their default weights, as the file has them; from then on
// it reads palettes from this memory. A weight that changes makes them anew, and the whole frame.
#pragma once
#pragma GCC system_header

#include "lumi/color.h"
#include "lumi/surface/frame.h"

namespace lumi
{

// A state's name as the file has it: `bytes` of UTF-8, without a zero behind them.
struct StateName {
    const char* text;
    uint32_t bytes;
};
// Returns that of a state below state_count.
StateName state_name(const SurfaceField& field, uint32_t state);

// Tells whether it is no light but the base colour of a material, which is its weight.
bool is_tint(const SurfaceField& field, uint32_t state);
// Returns the weight that it has until another is set: mostly kFullWeight; of a tint the colour of the model.
StateWeight default_weight(const SurfaceField& field, uint32_t state);

// Sets all weights to their defaults, and mixes them; a field that was just opened does not need it. Nothing happens to
// a field without states, or without memory.
void reset_states(SurfaceField& field, const SurfaceMemory& memory);

// Returns false if there is no such state. A weight that stays as it is costs nothing, another one two palettes.
bool set_state(SurfaceField& field, const SurfaceMemory& memory, uint32_t state, const StateWeight& weight);

}  // namespace lumi
