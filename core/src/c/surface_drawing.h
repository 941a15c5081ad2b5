// SPDX-License-Identifier: MIT
// How lumi.h draws surface fields: as SurfaceDrawing (surface/view.h) does, in memory whose size is known when a field
// is opened.
#pragma once

#include "lumi/lumi.h"
#include "lumi/surface/view.h"

namespace lumi::detail
{

template <class Pixel, SurfaceFeatures kFeatures>
class SurfaceDrawingInC
{
public:
    using Field = SurfaceField;

    static ViewError open(const uint8_t* bytes, size_t size, const lumi_screen& screen, Field& out)
    {
        const ViewError error = view_error(open_surface<kFeatures>(bytes, size, out));
        return error == ViewError::none && !is_mode(screen.mode) ? ViewError::bad_argument : error;
    }

    static constexpr bool has_spans() { return false; }
    static size_t bytes_of(const Field& field, const lumi_screen& screen) { return places_of(field, screen).end; }

    void begin(const Field& field, const lumi_screen& screen, void* memory)
    {
        const Places p = places_of(field, screen);
        const auto at = [&](size_t place) { return static_cast<void*>(static_cast<uint8_t*>(memory) + place); };
        frame_.field = field;
        memory_ = {static_cast<SurfaceVertex*>(at(0)), static_cast<uint16_t*>(at(p.links)),
                   static_cast<uint16_t*>(at(p.bands)), surface_band_log2(screen.rows_px),
                   static_cast<uint32_t*>(at(p.features))};
        if constexpr (kMoves) rest_parts(field, memory_);
        samples_ = static_cast<uint32_t*>(at(p.samples));
        samples_bytes_ = samples_bytes(screen);
        finest_ = static_cast<SurfaceMode>(screen.mode);
    }

    ViewError look(const Pose& pose, const Image& image, uint8_t number)
    {
        const SurfaceMode mode = static_cast<SurfaceMode>(number);
        if (mode > finest_) return ViewError::mode_too_fine;
        SurfaceCamera camera;
        const CameraError error = make_surface_camera(pose, image, camera);
        if (error != CameraError::none) return view_error(error);
        prepare_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(frame_.field, camera, mode, memory_, frame_);
        return ViewError::none;
    }

    PixelRect bounds() const { return bounds_of(frame_); }

    ViewError turn(uint32_t part, uint32_t turns32)
    {
        if constexpr (!kMoves) return ViewError::other_renderer;
        return turn_part(frame_.field, memory_, part, turns32) ? ViewError::none : ViewError::bad_argument;
    }

    ViewError slide(uint32_t part, int32_t offset_q20)
    {
        if constexpr (!kMoves) return ViewError::other_renderer;
        return slide_part(frame_.field, memory_, part, offset_q20) ? ViewError::none : ViewError::bad_argument;
    }

    ViewError set_state(uint32_t state, const StateWeight& weight)
    {
        if constexpr (!kWeighs) return ViewError::other_renderer;
        return lumi::set_state(frame_.field, memory_, state, weight) ? ViewError::none : ViewError::bad_argument;
    }

    ChangedRects changed(uint32_t align_x, uint32_t align_y) const { return changed_rects(frame_, align_x, align_y); }

    template <class Background>
    ViewError draw(const Stripe& stripe, const PixelSize& part, const Background& background, uint32_t*) const
    {
        const ViewError error = check_samples<Pixel>(frame_, part, samples_bytes_);
        if (error == ViewError::none)
            render_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(frame_, background, stripe, samples_);
        return error;
    }

    ViewError draw_coverage(const Stripe& coverage, const PixelSize& part, uint32_t*) const
    {
        const ViewError error = check_samples<Pixel>(frame_, part, samples_bytes_);
        if (error == ViewError::none) render_coverage<kFeatures>(frame_, coverage, samples_);
        return error;
    }

private:
    static constexpr bool kMoves = has(kFeatures, SurfaceFeatures::parts);
    static constexpr bool kWeighs = has(kFeatures, SurfaceFeatures::states);

    // All lies in this order, vertices first.
    struct Places {
        size_t samples, features, links, bands, end;
    };

    static constexpr bool is_mode(uint8_t number) { return number <= LUMI_TWO_BY_TWO; }

    // One sample takes the least, as surface_stripe_bytes_up_to has it.
    static uint32_t samples_bytes(const lumi_screen& s)
    {
        const auto bytes = [&](SurfaceMode mode) { return surface_stripe_bytes<Pixel>(s.width_px, s.rows_px, mode); };
        const uint32_t most = bytes(static_cast<SurfaceMode>(s.mode));
        const uint32_t antialiased = s.mode == LUMI_TWO_BY_TWO ? bytes(SurfaceMode::antialiased) : 0;
        return ((most > antialiased ? most : antialiased) + 3) / 4 * 4;
    }

    __attribute__((noinline)) static Places places_of(const Field& field, const lumi_screen& s)
    {
        Places p{};
        p.samples = field.vertex_count * sizeof(SurfaceVertex);
        p.features = p.samples + samples_bytes(s);
        p.links = p.features + feature_words(field) * sizeof(uint32_t);
        p.bands = p.links + surface_links(field.patch_count) * sizeof(uint16_t);
        p.end = p.bands + surface_bands(s.height_px, surface_band_log2(s.rows_px)) * sizeof(uint16_t);
        return p;
    }

    SurfaceFrame frame_{};  // its field is that of the view
    SurfaceMemory memory_{};
    uint32_t* samples_ = nullptr;
    uint32_t samples_bytes_ = 0;
    SurfaceMode finest_{};
};

}  // namespace lumi::detail
