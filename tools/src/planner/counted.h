// SPDX-License-Identifier: MIT
// Frames drawn by the core that counts what it does. It lies in a namespace of its own, so these names are C's, and
// what is given to it is its own by the same bytes.
#pragma once

#include <cstdint>

extern "C" {

// Draw a frame of RGB565 over black in stripes, and add what it took to `work`, in the order of detail::Work.
// `preparing`: what of it came before the first stripe.
// `field`: SurfaceField or Field; `camera`: SurfaceCamera or Camera; modes are numbers of SurfaceMode and tools::Mode.
void lumi_count_surface(const void* field, const void* camera, int mode, int32_t stripe_rows, uint64_t* work,
                        uint64_t* preparing);

// Tells where texels are read, from the first one on.
using lumi_note_read = void (*)(void* reads, uint32_t address, uint32_t bytes);
// span_px: 0 draws every pixel exactly. Paper has 5 points a side.
void lumi_count_chord(const void* field, const void* camera, int mode, int32_t span_px, int32_t stripe_rows,
                      uint64_t* work, lumi_note_read note, void* reads);
}
