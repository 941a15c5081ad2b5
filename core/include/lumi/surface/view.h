// SPDX-License-Identifier: MIT
// A view of a surface field (view.h) calls prepare_surface and render_surface with memory of its own.
#pragma once
#pragma GCC system_header

#include "lumi/surface/halves.h"
#include "lumi/surface/parts.h"
#include "lumi/surface/render.h"
#include "lumi/surface/states.h"
#include "lumi/view.h"

namespace lumi::detail
{

inline PixelRect bounds_of(const SurfaceFrame& frame)
{
    const Extent &x = frame.columns, &y = frame.scanlines;
    return {x.begin, y.begin, x.end - x.begin, y.end - y.begin};
}

// Tells whether a buffer holds the samples of a stripe.
template <class Pixel>
ViewError check_samples(const SurfaceFrame& frame, const PixelSize& part, uint32_t bytes)
{
    const bool fits = surface_stripe_bytes<Pixel>(part.width_px, part.height_px, frame.mode) <= bytes;
    return fits ? ViewError::none : ViewError::stripe_too_large;
}

}  // namespace lumi::detail

namespace lumi
{

// Memory for fields of up to so many vertices and patches, which `lumi inspect` tells, and for all modes up to kFinest:
// 2 × 2 takes four times as many samples as the others. Of the patches so many more may be see-through; for 0 open()
// refuses fields that have any, and nothing that draws them is linked. Of the vertices so many may have view tables;
// for 0 the same holds for these, unless there are see-through patches or two cores prepare. So many parts may move;
// for 0 the same holds for these. There may be so many light states; for 0 a field shows them at their full weight. It
// may have so many gloss maps; for 0 open() refuses fields that have any.
template <uint32_t kVertices, uint32_t kPatches, SurfaceMode kFinest = SurfaceMode::antialiased,
          uint32_t kSeeThrough = 0, uint32_t kViewed = kVertices, uint32_t kParts = 0, uint32_t kStates = 0,
          uint32_t kGloss = 0>
struct SurfaceDrawing {
    static_assert(kVertices <= detail::format::kMaxSurfaceVertices &&
                      kPatches + kSeeThrough <= detail::format::kMaxPatches && kParts <= detail::format::kMaxParts &&
                      kStates <= detail::format::kMaxStates && kGloss <= detail::format::kMaxGlossMaps,
                  "more than a field has");
    using Mode = SurfaceMode;
    static constexpr Mode kDefaultMode = kFinest;

    template <class ScreenOf>
    static constexpr uint32_t kSampleBytes = surface_stripe_bytes_up_to<typename ScreenOf::Pixel>(ScreenOf::kWidthPx,
                                                                                                  ScreenOf::kRowsPx,
                                                                                                  kFinest);
    template <class ScreenOf>
    using Samples = detail::SampleMemory<kSampleBytes<ScreenOf>>;

    static constexpr SurfaceFeatures kFeatures =
        (kSeeThrough + kViewed + kParts + kStates + kGloss != 0 ? SurfaceFeatures::view_tables
                                                                : SurfaceFeatures::none) |
        (kSeeThrough != 0 ? SurfaceFeatures::see_through : SurfaceFeatures::none) |
        (kParts != 0 ? SurfaceFeatures::parts : SurfaceFeatures::none) |
        (kStates != 0 ? SurfaceFeatures::states : SurfaceFeatures::none) |
        (kGloss != 0 ? SurfaceFeatures::gloss : SurfaceFeatures::none);
    static constexpr uint32_t kFeatureWords = see_through_words(kSeeThrough) + part_words(kParts) +
                                              state_words(kStates, kSeeThrough) + gloss_words(kGloss, kViewed);

    template <class ScreenOf>
    class Halves
    {
    public:
        void prepare(int32_t step, uint32_t half) { prepare_half<kFinest, kFeatures>(shared_, step, half); }

        operator SurfaceHalves&()
        {
            shared_.bands = bands_;  // of this one, also where it is a copy
            return shared_;
        }

    private:
        SurfaceHalves shared_{};
        uint16_t bands_[surface_bands(ScreenOf::kHeightPx, surface_band_log2(ScreenOf::kRowsPx))] = {};
    };

    template <class ScreenOf>
    // The memory of features is a base: an empty one takes no memory.
    class State : detail::SampleMemory<4 * kFeatureWords>
    {
    public:
        ViewError open(const uint8_t* bytes, size_t size)
        {
            SurfaceField field;
            if (const FieldError error = open_surface<kFeatures>(bytes, size, field); error != FieldError::none)
                return detail::view_error(error);
            if (field.vertex_count > kVertices || field.patch_count > kPatches || field.viewed_count > kViewed ||
                field.see_through_count > kSeeThrough || (kParts != 0 && field.part_count > kParts) ||
                (kStates != 0 && field.state_count > kStates) || gloss_count(field) > kGloss)
                return ViewError::field_too_large;
            frame_.field = field;
            if constexpr (kParts != 0) detail::rest_parts(field, memory());
            return ViewError::none;
        }

        // `both` is nothing, or Halves and what prepares both.
        template <class... Both>
        ViewError look(const Pose& pose, const Image& image, Mode mode, Both&... both)
        {
            if (mode > kFinest) return ViewError::mode_too_fine;
            SurfaceCamera camera;
            const CameraError error = make_surface_camera(pose, image, camera);
            if (error != CameraError::none) return detail::view_error(error);
            prepare_surface<typename ScreenOf::Pixel, kFinest, kFeatures>(frame_.field, camera, mode, memory(), frame_,
                                                                          both...);
            return ViewError::none;
        }

        PixelRect bounds() const { return detail::bounds_of(frame_); }

        ViewError turn(uint32_t part, uint32_t turns32)
        {
            static_assert(kParts != 0, "the view is of a field without moving parts: `lumi embed` names their number");
            return turn_part(frame_.field, memory(), part, turns32) ? ViewError::none : ViewError::bad_argument;
        }
        ViewError slide(uint32_t part, int32_t offset_q20)
        {
            static_assert(kParts != 0, "the view is of a field without moving parts: `lumi embed` names their number");
            return slide_part(frame_.field, memory(), part, offset_q20) ? ViewError::none : ViewError::bad_argument;
        }
        ViewError set_state(uint32_t state, const StateWeight& weight)
        {
            static_assert(kStates != 0, "the view is of a field without light states: `lumi embed` names their number");
            const bool is_there = lumi::set_state(frame_.field, memory(), state, weight);
            return is_there ? ViewError::none : ViewError::bad_argument;
        }
        ChangedRects changed(uint32_t align_x, uint32_t align_y) const
        {
            return changed_rects(frame_, align_x, align_y);
        }

        int32_t rows_at(int32_t width_px) const
        {
            using Pixel = typename ScreenOf::Pixel;
            const auto most =
                static_cast<int32_t>(ScreenOf::kStripeBytes / (static_cast<uint32_t>(width_px) * Pixel::kBytes));
            int32_t rows = most < ScreenOf::kHeightPx ? most : ScreenOf::kHeightPx;
            while (surface_stripe_bytes<Pixel>(width_px, rows, frame_.mode) > kSampleBytes<ScreenOf>) --rows;
            return rows;
        }

        template <class Background>
        ViewError draw(const Stripe& stripe, const detail::PixelSize& part, const Background& background,
                       uint32_t* samples) const
        {
            const ViewError error =
                detail::check_samples<typename ScreenOf::Pixel>(frame_, part, kSampleBytes<ScreenOf>);
            if (error == ViewError::none)
                render_surface<typename ScreenOf::Pixel, kFinest, kFeatures>(frame_, background, stripe, samples);
            return error;
        }

        ViewError draw_coverage(const Stripe& coverage, const detail::PixelSize& part, uint32_t* samples) const
        {
            const ViewError error =
                detail::check_samples<typename ScreenOf::Pixel>(frame_, part, kSampleBytes<ScreenOf>);
            if (error == ViewError::none) render_coverage<kFeatures>(frame_, coverage, samples);
            return error;
        }

    private:
        SurfaceMemory memory() { return {vertices_, links_, bands_, kBandLog2, this->data()}; }

        static constexpr uint32_t kBandLog2 = surface_band_log2(ScreenOf::kRowsPx);

        SurfaceFrame frame_{};  // its field is that of the view
        SurfaceVertex vertices_[kVertices] = {};
        uint16_t links_[surface_links(kPatches)] = {};
        uint16_t bands_[surface_bands(ScreenOf::kHeightPx, kBandLog2)] = {};
    };
};

}  // namespace lumi
