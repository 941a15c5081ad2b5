// SPDX-License-Identifier: MIT
// Draws a guided field into stripes of pixels.
//
//     GuidedField field; open_guided(bytes, size, field);
//     FocusSurface surface(field, camera);                 // or a ProxySurface
//     using Best = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanRgb565, OcclusionUse::read>;
//     render_guided<Best, PixelRgb565Swapped>(field, camera, surface, OverBlack{}, stripe);
//
// The same contract as render(): any rectangle, any order, re-entrant (a surface is one renderer's), the same bits
// however the image is cut. The file's address is divisible by 4.
//
// A surface policy has `kSamples` (1 or 4 a pixel), begin_stripe(stripe), columns(), the columns outside which all of
// the stripe is background, begin_row(y), next(x, end), the first column from x on that may have a surface, and
// at(x, points), which tells the distinct surfaces that a pixel's samples see: it writes at most kSamples points and
// returns how many, 0 for the background. Rows come from the top, pixels from left to right; only those whose rays meet
// the sphere are asked for, others are background.
#pragma once

#include "lumi/detail/stepping/outline.h"
#include "lumi/guided/guided_shade.h"
#include "lumi/guided/guided_walker.h"
#include "lumi/linear_light.h"
#include "lumi/pixel.h"
#include "lumi/render.h"

namespace lumi
{

// Draws one row after another from one stripe's constants.
template <class Policy, class Surface, class Pixel, class Background>
class GuidedRenderer
{
public:
    GuidedRenderer(const GuidedField& field, const Camera& camera, Surface& surface, const Background& background)
        : surface_(surface), background_(background), shader_(field), charts_(field), walker_(camera, field.origins)
    {
    }

    // Draws the pixels `span` of row y, of which the sphere covers `covered` in the whole image.
    void row(const RowSpan& span, const RowSpan& covered, int32_t y, uint8_t* pixel)
    {
        if (span.begin >= span.end) return;
        walker_.begin_row(covered, y);
        surface_.begin_row(y);
        for (int32_t x = span.begin; x < span.end; ++x, pixel += Pixel::kBytes) {
            SurfacePoint seen[Surface::kSamples];
            const uint32_t surfaces = surface_.at(x, seen);
            if (surfaces == 0) {
                const int32_t next = surface_.next(x + 1, span.end);
                if (Background::kFills) fill_pixels<Pixel>(background_, pixel, next - x);
                pixel += static_cast<uint32_t>(next - x - 1) * Pixel::kBytes;
                x = next - 1;
                continue;
            }
            if constexpr (Policy::kChart) {
                const bool moved = walker_.move_to(x);
                Policy::Origins::hold(charts_, walker_.taps(), moved);
            }
            if (surfaces == 1) {
                store_one(pixel, seen[0]);
            } else if constexpr (Surface::kSamples > 1) {
                store_mixture(pixel, seen, surfaces);
            }
        }
    }

private:
    static_assert(Surface::kSamples == 1 || Surface::kSamples == 4, "one sample a pixel, or four");

    LUMI_ALWAYS_INLINE void store_one(uint8_t* pixel, const SurfacePoint& seen) const
    {
        const GuidedSum sum = shader_.sum_at(seen, charts_, walker_.taps());
        if constexpr (!Policy::Mean::kHasMean && kPacks565<Pixel>) {
            if (shader_.is_whole(sum) && seen.samples == Surface::kSamples)
                return Pixel::store_packed(pixel, shader_.packed565(sum));
        }
        const Shade shade = shader_.shade_of(seen, sum);
        store(pixel, shade.colour, shade.coverage_q8 * seen.samples / Surface::kSamples);
    }

    // Colours of a pixel's surfaces are mixed as light; what is not covered shows the background, in encoded values.
    __attribute__((noinline)) void store_mixture(uint8_t* pixel, const SurfacePoint* seen, uint32_t surfaces) const
    {
        LightMixture mixture;
        for (uint32_t k = 0; k < surfaces; ++k) {
            const Shade shade = shader_.shade(seen[k], charts_, walker_.taps());
            if (shade.coverage_q8 != 0) mixture.add(shade.colour, seen[k].samples);
        }
        if (mixture.weight() == 0) return store(pixel, {0, 0, 0}, 0);
        store(pixel, mixture.colour(), 256 * mixture.weight() / Surface::kSamples);
    }

    void store(uint8_t* pixel, const Rgb8& colour, uint32_t coverage_q8) const
    {
        if (coverage_q8 == 256) return Pixel::store(pixel, colour);
        if (coverage_q8 == 0 && !Background::kFills) return;
        const Rgb8 under = background_.template under<Pixel>(pixel);
        const auto over = [&](uint32_t c, uint32_t u) {
            return static_cast<uint8_t>((coverage_q8 * c + (256 - coverage_q8) * u + 128) >> 8);
        };
        Pixel::store(pixel, {over(colour.r, under.r), over(colour.g, under.g), over(colour.b, under.b)});
    }

    Surface& surface_;
    const Background& background_;
    GuidedShader<Policy> shader_;
    OriginCharts charts_;
    OriginWalker walker_;
};

enum class [[nodiscard]] GuidedError : uint8_t{
    none = 0,
    wrong_policy,  // the field does not hold what the policy reads
    unaligned,     // the file's address is not divisible by 4
};

// One short English phrase per error, for logs. Linked only if called.
const char* describe(GuidedError error);

constexpr int32_t smaller(int32_t a, int32_t b)
{
    return a < b ? a : b;
}
constexpr int32_t larger(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

// Whether sections lie where they can be read in aligned accesses.
bool is_aligned(const GuidedField& field);

// The rows of a stripe that the surface has begun. Not inlined: the memory of what draws them would lie on the stack
// below begin_stripe's deepest chain of calls.
template <class Policy, class Pixel, class Surface, class Background>
__attribute__((noinline)) void draw_guided_rows(const GuidedField& field, const Camera& camera, Surface& surface,
                                                const Background& background, const Stripe& stripe)
{
    GuidedRenderer<Policy, Surface, Pixel, Background> renderer(field, camera, surface, background);
    OutlineTracker outline(camera, {0, camera.width_px()});
    const RowSpan columns = surface.columns();
    const RowSpan limits = {larger(stripe.x_px, columns.begin), smaller(stripe.right_px(), columns.end)};
    for (int32_t y = stripe.y_px; y < stripe.bottom_px(); ++y) {
        const RowSpan covered = outline.row(y);
        RowSpan span = {larger(covered.begin, limits.begin), smaller(covered.end, limits.end)};
        if (span.begin >= span.end) span = {stripe.x_px, stripe.x_px};
        fill_beside<Pixel>(background, stripe, span, y);
        renderer.row(span, covered, y, pixel_of<Pixel>(stripe, span.begin, y));
    }
}

template <class Policy, class Pixel, class Surface, class Background>
GuidedError render_guided(const GuidedField& field, const Camera& camera, Surface& surface,
                          const Background& background, const Stripe& stripe)
{
    if (!Policy::fits(field)) return GuidedError::wrong_policy;
    if (!is_aligned(field)) return GuidedError::unaligned;
    surface.begin_stripe(stripe);
    draw_guided_rows<Policy, Pixel>(field, camera, surface, background, stripe);
    return GuidedError::none;
}

}  // namespace lumi
