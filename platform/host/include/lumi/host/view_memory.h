// SPDX-License-Identifier: MIT
// RAM of a view (lumi/view.h) on a device whose pointers have 4 bytes, to the byte of its sizeof there, for programs
// that know field and screen only when they run. tests/cross/view_memory.cpp compares it with the compilers of M0+ and
// M4.
#pragma once

#include "lumi/surface/render.h"

namespace lumi::host
{

// This is an image, drawn at most so many rows at once, like lumi::Screen.
struct ScreenSize {
    int32_t width_px = 240, height_px = 240, rows = 16;

    constexpr int32_t stripe_rows() const { return rows < height_px ? rows : height_px; }
};

// These are the parameters of SurfaceDrawing.
struct SurfaceCounts {
    uint32_t vertices, patches;
    SurfaceMode finest;
    uint32_t see_through;
    uint32_t parts = 0, states = 0;
    uint32_t gloss = 0, viewed = 0;  // the second counts only where there is gloss
};

// Those of a field that is drawn in modes up to `finest`.
inline SurfaceCounts counts_of(const SurfaceField& field, SurfaceMode finest)
{
    return {field.vertex_count, field.patch_count, finest, field.see_through_count, field.part_count, field.state_count,
            gloss_count(field), field.viewed_count};
}

// Counts the bytes of a stripe's pixels.
template <class Pixel>
constexpr uint32_t stripe_pixel_bytes(const ScreenSize& screen)
{
    return static_cast<uint32_t>(screen.width_px * screen.stripe_rows()) * Pixel::kBytes;
}

// The view that `lumi embed` writes for a surface field: its numbers, then vertices, lists, samples of a stripe.
template <class Pixel>
constexpr uint32_t surface_view_bytes(const SurfaceCounts& field, const ScreenSize& screen)
{
    constexpr uint32_t kNumbers = 1292, kWord = 4, kHalf = 2, kVertex = 12;
    const auto words = [](uint32_t bytes) { return (bytes + kWord - 1) / kWord * kWord; };
    const uint32_t patches = field.patches == 0 ? 1 : field.patches;  // memory for none is no array
    const uint32_t bands = surface_bands(screen.height_px, surface_band_log2(screen.stripe_rows()));
    const uint32_t features = see_through_words(field.see_through) + part_words(field.parts) +
                              state_words(field.states, field.see_through) + gloss_words(field.gloss, field.viewed);
    return kNumbers + kWord * features + kVertex * field.vertices + words(kHalf * (surface_links(patches) + bands)) +
           words(surface_stripe_bytes_up_to<Pixel>(screen.width_px, screen.stripe_rows(), field.finest));
}

// Counts the bytes of the view of a chord field, for every screen: by spans, or exact.
constexpr uint32_t chord_view_bytes(bool by_spans)
{
    return by_spans ? 288 : 280;
}

}  // namespace lumi::host
