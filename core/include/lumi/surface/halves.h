// SPDX-License-Identifier: MIT
// Prepares a frame of a surface field on two cores: the same pixels and lists as on one, bit by bit.
//
//     static SurfaceHalves halves;  halves.bands = second_bands;  // surface_bands() numbers
//     prepare_surface<PixelRgb565>(field, camera, mode, memory, frame, halves, [](int32_t step) {
//         begin_on_other_core(step);               // there: prepare_half(halves, step, 1)
//         prepare_half(halves, step, 0);
//         wait_for_other_core();
//     });
//
// The caller's function is called at most three times a frame, for step 0, 1 and 2, or not at all where nothing shows
// or only parts have moved.
// It must call prepare_half(halves, step, 0) and prepare_half(halves, step, 1) once each and come back after both. They
// may run at once on two cores, or one after the other, in any order, on any core. So a core that is busy with
// something else can be done without: run both halves here.
//
// Memory. All that the caller wrote before a step is seen by both halves, and all that they wrote is seen by the caller
// after it: what begins the other core is a release that it acquires, what waits for it an acquire of its release.
// Semaphores and queues of an operating system do that; before a core signals through a register, and after it has read
// one, it takes a barrier instruction (Arm's DMB). Cores whose caches do not keep each other up to date need frame,
// memory and halves in RAM that is not cached.
//
// If a half does not run, its part of the picture is missing or old, but no read or write leaves the memory of a view.
// If it still runs after the function came back, it writes what this core reads: that is the one fault that nothing
// here finds.
//
// Cost: surface_bands() numbers and sizeof(SurfaceHalves). See-through triangles, moving parts, their light and the
// palettes are prepared by the calling core alone.
#pragma once
#pragma GCC system_header

#include "lumi/surface/frame.h"

namespace lumi::detail
{

struct PlaceRange {
    int32_t least, most;
};

// Tells how far vertices reach on the grid of samples.
struct PlacedVertices {
    PlaceRange x_q6, y_q6;
    bool are_whole;  // none is missing
};

}  // namespace lumi::detail

namespace lumi
{

// Both cores share this while they prepare a frame; nothing of it is needed to draw.
struct SurfaceHalves {
    uint16_t* bands;  // the caller's: surface_bands() of the frame, for the lists of the second half
    SurfaceFrame* frame;
    detail::PlacedVertices placed[2];
    int32_t reach[2];
};

}  // namespace lumi

namespace lumi::detail
{

enum PrepareStep : int32_t { kPlaceVertices, kListTriangles, kLightVertices };

// Returns false if nothing shows and no step is needed.
bool begin_halves(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode, const SurfaceMemory& memory,
                  SurfaceFrame& out, SurfaceHalves& halves);
void run_half(SurfaceHalves& halves, int32_t step, uint32_t half);
void join_vertices(SurfaceHalves& halves);
void join_lists(SurfaceHalves& halves);

// Do that for the body alone, where parts may move.
void begin_halves_of_body(SurfaceFrame& frame, SurfaceHalves& halves);
void run_half_of_body(SurfaceHalves& halves, int32_t step, uint32_t half);

// Returns the patches of a half, of so many.
inline PatchRange patches_of(uint32_t count, uint32_t half)
{
    const uint32_t middle = count / 2;
    return half == 0 ? PatchRange{0, middle} : PatchRange{middle, count};
}

// Ends a step: `patches` are those of the half.
template <SurfaceMode kFinest, SurfaceFeatures kFeatures>
void end_half(const SurfaceFrame& frame, int32_t step, [[maybe_unused]] uint32_t half, const PatchRange& patches)
{
    if (step != kLightVertices) return;
    if constexpr (has(kFeatures, SurfaceFeatures::states)) put_states_of_half(frame, half);
    if constexpr (kFinest != SurfaceMode::one_sample)
        if (frame.margin != 0) put_outlines(frame, patches.begin, patches.end);
}

template <class Both>
void run_steps(SurfaceHalves& halves, const Both& both)
{
    both(kPlaceVertices);
    join_vertices(halves);
    both(kListTriangles);
    both(kLightVertices);
    join_lists(halves);
}

}  // namespace lumi::detail

namespace lumi
{

// Runs half 0 or 1 of a step, from the function that prepare_surface() calls; kFinest and kFeatures as there.
template <SurfaceMode kFinest = SurfaceMode::two_by_two, SurfaceFeatures kFeatures = SurfaceFeatures::view_tables>
void prepare_half(SurfaceHalves& halves, int32_t step, uint32_t half)
{
    const SurfaceFrame& frame = *halves.frame;
    if constexpr (has(kFeatures, SurfaceFeatures::parts)) {
        if (detail::may_move(frame.field, frame.memory)) {
            detail::run_half_of_body(halves, step, half);
            const detail::PatchRange parts = detail::patches_of_parts(frame);
            return detail::end_half<kFinest, kFeatures>(frame, step, half, detail::patches_of(parts.begin, half));
        }
    }
    detail::run_half(halves, step, half);
    detail::end_half<kFinest, kFeatures>(frame, step, half, detail::patches_of(frame.field.patch_count, half));
}

// Prepares a frame as prepare_surface() does on one core, and as fast as that if `both` runs both halves here. Give
// `both` as a lambda: no call then goes through a pointer, whose stack has no bound.
template <class Pixel, SurfaceMode kFinest = SurfaceMode::two_by_two,
          SurfaceFeatures kFeatures = SurfaceFeatures::view_tables, class Both>
void prepare_surface(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                     const SurfaceMemory& memory, SurfaceFrame& out, SurfaceHalves& halves, const Both& both)
{
    if constexpr (has(kFeatures, SurfaceFeatures::parts)) {
        if (detail::may_move(field, memory))
            return detail::prepare_moving<Pixel, kFinest, kFeatures>(
                field, camera, mode, memory, out,
                [&] {
                    detail::begin_halves_of_body(out, halves);
                    detail::run_steps(halves, both);
                });
    }
    if (detail::begin_halves(field, camera, mode, memory, out, halves)) detail::run_steps(halves, both);
    detail::end_frame<Pixel, kFeatures>(out);
}

}  // namespace lumi
