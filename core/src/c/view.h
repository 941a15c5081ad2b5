// SPDX-License-Identifier: MIT
// What lies behind a lumi_view, by the macros of lumi.h. Every source of lumi::c includes it, with the same macros.
// Each background has a source of its own: the compiler then builds its renderer as if there were no other.
#pragma once

#include "types.h"

#if defined(LUMI_C_SURFACE) || defined(LUMI_C_SEE_THROUGH) || !defined(LUMI_C_TEXEL)
#define LUMI_C_DRAWS_SURFACES
#include "surface_drawing.h"
#endif
#ifdef LUMI_C_TEXEL
#include "chord_drawing.h"
#endif
#include "either_drawing.h"

#ifndef LUMI_C_PIXEL
#define LUMI_C_PIXEL PixelRgb565Swapped
#endif
#ifndef LUMI_C_BACKGROUND
#define LUMI_C_BACKGROUND OverBlack()
#endif

namespace lumi::detail::c
{

using Pixel = LUMI_C_PIXEL;

#ifdef LUMI_C_SEE_THROUGH
using Surfaces = SurfaceDrawingInC<Pixel, SeeThroughParts>;
#elif defined(LUMI_C_DRAWS_SURFACES)
using Surfaces = SurfaceDrawingInC<Pixel, OpaqueParts>;
#endif
#ifdef LUMI_C_TEXEL
using Chords = ChordDrawingInC<Pixel, LUMI_C_TEXEL>;
#endif

#if defined(LUMI_C_DRAWS_SURFACES) && defined(LUMI_C_TEXEL)
using Drawing = EitherDrawingInC<Surfaces, Chords>;
#elif defined(LUMI_C_TEXEL)
using Drawing = Chords;
#else
using Drawing = Surfaces;
#endif

}  // namespace lumi::detail::c

struct lumi_view {
    lumi_screen screen;
    bool has_look;
    lumi::detail::c::Drawing drawing;

    static void* operator new(size_t, void* memory) { return memory; }  // <new> is not everywhere
};

namespace lumi::detail::c
{

constexpr lumi_error code(ViewError error)
{
    return static_cast<lumi_error>(error);
}

// draw(stripe, part) with a stripe that was checked.
template <class Draw>
lumi_error drawn(const lumi_view* view, const lumi_stripe& s, uint32_t pixel_bytes, const Draw& draw)
{
    if (view == nullptr) return code(ViewError::no_field);
    if (!view->has_look) return code(ViewError::no_look);
    const Stripe stripe = in_cpp(s);
    StripePart part = {};
    const ViewError error = check_stripe(stripe, {view->screen.width_px, view->screen.height_px}, pixel_bytes, part);
    return code(error == ViewError::none ? draw(stripe, part) : error);
}

template <class Background>
lumi_error drawn_over(const Background& background, const lumi_view* view, const lumi_stripe& s)
{
    return drawn(
        view, s, Pixel::kBytes,
        [&](const Stripe& stripe, const StripePart& part) { return view->drawing.draw(stripe, part, background); });
}

}  // namespace lumi::detail::c
