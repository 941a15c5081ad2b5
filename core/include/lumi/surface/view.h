// SPDX-License-Identifier: MIT
// A view of a surface field (view.h): prepare_surface and render_surface with their memory.
#pragma once
#pragma GCC system_header

#include "lumi/surface/render.h"
#include "lumi/view.h"

namespace lumi::detail
{

template <class Pixel, SurfaceMode kFinest>
ViewError look_at_surface(const SurfaceField& field, const Pose& pose, const Image& image, SurfaceMode mode,
                          const SurfaceMemory& memory, SurfaceFrame& out)
{
    SurfaceCamera camera;
    if (const CameraError error = make_surface_camera(pose, image, camera); error != CameraError::none)
        return view_error(error);
    prepare_surface<Pixel, kFinest>(field, camera, mode, memory, out);
    return ViewError::none;
}

// Whether a buffer holds the samples of a stripe.
template <class Pixel>
ViewError check_samples(const SurfaceFrame& frame, const StripePart& part, uint32_t bytes)
{
    const bool fits = surface_stripe_bytes<Pixel>(part.width_px, part.rows_px, frame.mode) <= bytes;
    return fits ? ViewError::none : ViewError::stripe_too_large;
}

}  // namespace lumi::detail

namespace lumi
{

// Memory for fields of up to so many vertices and patches, which `lumi inspect` tells, and for all modes up to kFinest:
// 2 × 2 takes four times as many samples as the others.
template <uint32_t kVertices, uint32_t kPatches, SurfaceMode kFinest = SurfaceMode::antialiased>
struct SurfaceDrawing {
    static_assert(kVertices <= detail::format::kMaxSurfaceVertices && kPatches <= detail::format::kMaxPatches,
                  "more than a field has");
    using Mode = SurfaceMode;
    static constexpr Mode kDefaultMode = kFinest;

    template <class ScreenOf>
    struct Samples {
        static constexpr uint32_t kBytes =
            surface_stripe_bytes_up_to<typename ScreenOf::Pixel>(ScreenOf::kWidthPx, ScreenOf::kRowsPx, kFinest);
        uint32_t words[(kBytes + 3) / 4] = {};
    };

    template <class ScreenOf>
    class State
    {
    public:
        ViewError open(const uint8_t* bytes, size_t size)
        {
            SurfaceField field;
            if (const FieldError error = open_surface(bytes, size, field); error != FieldError::none)
                return detail::view_error(error);
            if (field.vertex_count > kVertices || field.patch_count > kPatches) return ViewError::field_too_large;
            field_ = field;
            return ViewError::none;
        }

        ViewError look(const Pose& pose, const Image& image, Mode mode)
        {
            if (mode > kFinest) return ViewError::mode_too_fine;
            return detail::look_at_surface<typename ScreenOf::Pixel, kFinest>(
                field_, pose, image, mode, {vertices_, links_, bands_, kBandLog2}, frame_);
        }

        template <class Background>
        ViewError draw(const Stripe& stripe, const detail::StripePart& part, const Background& background,
                       Samples<ScreenOf>& samples) const
        {
            const ViewError error =
                detail::check_samples<typename ScreenOf::Pixel>(frame_, part, Samples<ScreenOf>::kBytes);
            if (error == ViewError::none)
                render_surface<typename ScreenOf::Pixel, kFinest>(frame_, background, stripe, samples.words);
            return error;
        }

        ViewError draw_coverage(const Stripe& coverage, const detail::StripePart& part,
                                Samples<ScreenOf>& samples) const
        {
            const ViewError error =
                detail::check_samples<typename ScreenOf::Pixel>(frame_, part, Samples<ScreenOf>::kBytes);
            if (error == ViewError::none) render_coverage(frame_, coverage, samples.words);
            return error;
        }

    private:
        static constexpr uint32_t kBandLog2 = surface_band_log2(ScreenOf::kRowsPx);

        SurfaceField field_{};
        SurfaceFrame frame_{};
        SurfaceVertex vertices_[kVertices] = {};
        uint16_t links_[surface_links(kPatches)] = {};
        uint16_t bands_[surface_bands(ScreenOf::kHeightPx, kBandLog2)] = {};
    };
};

}  // namespace lumi
