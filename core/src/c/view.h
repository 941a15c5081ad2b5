// SPDX-License-Identifier: MIT
// A lumi_view is a View (lumi/view.h), by the macros of lumi.h, of a screen and a field that are known when it is
// opened. Every source of lumi::c includes it, with the same macros. Each background has a source of its
// own: the compiler then builds its renderer as if there were no other.
#pragma once

#include "lumi/view.h"
#include "types.h"

#if defined(LUMI_C_SURFACE) || defined(LUMI_C_SEE_THROUGH) || defined(LUMI_C_PARTS) || defined(LUMI_C_STATES) || \
    defined(LUMI_C_GLOSS) || !defined(LUMI_C_TEXEL)
#define LUMI_C_DRAWS_SURFACES
#include "surface_drawing.h"
#endif
#ifdef LUMI_C_TEXEL
#include "chord_drawing.h"
#endif

#ifndef LUMI_C_PIXEL
#define LUMI_C_PIXEL PixelRgb565Swapped
#endif
#ifndef LUMI_C_BACKGROUND
#define LUMI_C_BACKGROUND OverBlack()
#endif

namespace lumi::detail::c
{

// Fields of both layouts: a view draws that of its field.
template <class Surface, class Chord>
class EitherDrawing
{
public:
    struct Field {
        bool is_chord;
        typename Surface::Field surface;
        typename Chord::Field chord;
    };

    static ViewError open(const uint8_t* bytes, size_t size, const lumi_screen& screen, Field& out)
    {
        const ViewError error = Surface::open(bytes, size, screen, out.surface);
        out.is_chord = error == ViewError::other_renderer;
        return out.is_chord ? Chord::open(bytes, size, screen, out.chord) : error;
    }

    static size_t bytes_of(const Field& field, const lumi_screen& screen)
    {
        return field.is_chord ? Chord::bytes_of(field.chord, screen) : Surface::bytes_of(field.surface, screen);
    }

    void begin(const Field& field, const lumi_screen& screen, void* memory)
    {
        is_chord_ = field.is_chord;
        if (is_chord_)
            chord_.begin(field.chord, screen, memory);
        else
            surface_.begin(field.surface, screen, memory);
    }

    bool has_spans() const { return is_chord_; }

    ViewError look(const Pose& pose, const Image& image, uint8_t mode)
    {
        return is_chord_ ? chord_.look(pose, image, mode) : surface_.look(pose, image, mode);
    }

    PixelRect bounds() const { return is_chord_ ? chord_.bounds() : surface_.bounds(); }

    ViewError turn(uint32_t part, uint32_t turns32)
    {
        return is_chord_ ? ViewError::other_renderer : surface_.turn(part, turns32);
    }

    ViewError slide(uint32_t part, int32_t offset_q20)
    {
        return is_chord_ ? ViewError::other_renderer : surface_.slide(part, offset_q20);
    }

    ViewError set_state(uint32_t state, const StateWeight& weight)
    {
        return is_chord_ ? ViewError::other_renderer : surface_.set_state(state, weight);
    }

    ChangedRects changed(uint32_t align_x, uint32_t align_y) const { return surface_.changed(align_x, align_y); }

    template <class Background>
    ViewError draw(const Stripe& stripe, const PixelSize& part, const Background& background, uint32_t*) const
    {
        return is_chord_ ? chord_.draw(stripe, part, background, nullptr)
                         : surface_.draw(stripe, part, background, nullptr);
    }

    ViewError draw_coverage(const Stripe& coverage, const PixelSize& part, uint32_t*) const
    {
        return is_chord_ ? chord_.draw_coverage(coverage, part, nullptr)
                         : surface_.draw_coverage(coverage, part, nullptr);
    }

private:
    Surface surface_{};
    Chord chord_{};
    bool is_chord_ = false;
};

using Pixel = LUMI_C_PIXEL;

#ifdef LUMI_C_SEE_THROUGH
inline constexpr SurfaceFeatures kSeeThrough = SurfaceFeatures::see_through;
#elif defined(LUMI_C_DRAWS_SURFACES)
inline constexpr SurfaceFeatures kSeeThrough = SurfaceFeatures::none;
#endif
#ifdef LUMI_C_PARTS
inline constexpr SurfaceFeatures kParts = SurfaceFeatures::parts;
#elif defined(LUMI_C_DRAWS_SURFACES)
inline constexpr SurfaceFeatures kParts = SurfaceFeatures::none;
#endif
#ifdef LUMI_C_STATES
inline constexpr SurfaceFeatures kStates = SurfaceFeatures::states;
#elif defined(LUMI_C_DRAWS_SURFACES)
inline constexpr SurfaceFeatures kStates = SurfaceFeatures::none;
#endif
#ifdef LUMI_C_GLOSS
inline constexpr SurfaceFeatures kGloss = SurfaceFeatures::gloss;
#elif defined(LUMI_C_DRAWS_SURFACES)
inline constexpr SurfaceFeatures kGloss = SurfaceFeatures::none;
#endif
#ifdef LUMI_C_DRAWS_SURFACES
using Surfaces = SurfaceDrawingInC<Pixel, SurfaceFeatures::view_tables | kSeeThrough | kParts | kStates | kGloss>;
#endif
#ifdef LUMI_C_TEXEL
using Chords = ChordDrawingInC<Pixel, LUMI_C_TEXEL>;
#endif

#if defined(LUMI_C_DRAWS_SURFACES) && defined(LUMI_C_TEXEL)
using Drawing = EitherDrawing<Surfaces, Chords>;
#elif defined(LUMI_C_TEXEL)
using Drawing = Chords;
#else
using Drawing = Surfaces;
#endif

// View's parameters, as SurfaceDrawing and Screen are others.
struct ViewDrawing {
    using Mode = uint8_t;
    static constexpr Mode kDefaultMode = 0;
    template <class>
    using Samples = SampleMemory<0>;  // they lie in the view's memory
    template <class>
    using Halves = SampleMemory<0>;

    template <class>
    struct State : Drawing {
        lumi_screen screen{};
    };
};

struct ViewScreen {
    using Pixel = c::Pixel;
    static constexpr uint32_t kStripeBytes = 0;
    static constexpr bool kHasSamples = true;

    static PixelSize size_of(const ViewDrawing::State<ViewScreen>& state)
    {
        return {state.screen.width_px, state.screen.height_px};
    }
};

}  // namespace lumi::detail::c

struct lumi_view : lumi::View<lumi::detail::c::ViewDrawing, lumi::detail::c::ViewScreen> {
    static void* operator new(size_t, void* memory) { return memory; }  // <new> is not everywhere

    // Takes a field that was opened. The memory that it needs besides lies behind the view.
    void begin(const uint8_t* bytes, size_t size, const lumi::detail::c::Drawing::Field& field,
               const lumi_screen& screen)
    {
        bytes_ = bytes;
        size_ = size;
        state_.screen = screen;
        state_.begin(field, screen, this + 1);
    }

    const lumi_screen& screen() const { return state_.screen; }
    bool has_spans() const { return state_.has_spans(); }
};

namespace lumi::detail::c
{

constexpr lumi_error code(ViewError error)
{
    return static_cast<lumi_error>(error);
}

template <class Background>
lumi_error drawn_over(const Background& background, lumi_view* view, const lumi_stripe& stripe)
{
    return code(view == nullptr ? ViewError::no_field : view->draw(in_cpp(stripe), background));
}

}  // namespace lumi::detail::c
