// SPDX-License-Identifier: MIT
// A mode is a SurfaceMode.
#include "drawing.h"
#include "lumi/surface/parts.h"
#include "lumi/surface/render.h"
#include "lumi/surface/states.h"

namespace lumi::wasm
{
namespace
{

constexpr uint32_t kModes = 3;
constexpr uint32_t kBandLog2 = surface_band_log2(kStripeRows);

// <lumi-view> is small: it weighs no light states.
#ifdef LUMI_VIEW_ELEMENT
constexpr SurfaceFeatures kFeatures =
    SurfaceFeatures::view_tables | SurfaceFeatures::see_through | SurfaceFeatures::parts | SurfaceFeatures::gloss;
#else
constexpr SurfaceFeatures kFeatures = SurfaceFeatures::all;
#endif

LUMI_CONSTANT SurfaceField field = {};
LUMI_CONSTANT SurfaceFrame frame = {};
void* samples = nullptr;
uint32_t part_values[detail::format::kMaxParts] = {};
StateWeight weights[detail::format::kMaxStates] = {};

}  // namespace

ViewError open_drawing(const uint8_t* bytes, size_t size)
{
    for (uint32_t& value : part_values) value = 0;
    const ViewError error = detail::view_error(open_surface<kFeatures>(bytes, size, field));
    if constexpr (has(kFeatures, SurfaceFeatures::states))
        for (uint32_t k = 0; k < field.state_count; ++k) weights[k] = default_weight(field, k);
    return error;
}

void set_part(uint32_t part, uint32_t value)
{
    if (part < detail::format::kMaxParts) part_values[part] = value;
}

void set_state_weight(uint32_t state, const StateWeight& weight)
{
    if (state < detail::format::kMaxStates) weights[state] = weight;
}

PartSigns part_signs(uint32_t part)
{
    if (part >= mover_count(field)) return {};
    const PartName name = part_name(field, part);
    return {name.text, name.bytes, part_motion(field, part).slides};
}

uint32_t drawing_modes()
{
    return kModes;
}

namespace
{

// Without padding: vertices and the memory of features are words, links and bands half words, samples words again.
struct Layout {
    uint32_t features, links, bands, samples;

    explicit Layout(int32_t height_px)
    {
        constexpr uint32_t kHalf = sizeof(uint16_t), kWord = sizeof(uint32_t);
        features = field.vertex_count * static_cast<uint32_t>(sizeof(SurfaceVertex));
        links = features + feature_words(field) * kWord;
        bands = links + surface_links(field.patch_count) * kHalf;
        const uint32_t end = bands + surface_bands(height_px, kBandLog2) * kHalf;
        samples = (end + kWord - 1) / kWord * kWord;
    }
};

}  // namespace

uint32_t drawing_bytes(int32_t width_px, int32_t height_px)
{
    return Layout(height_px).samples + surface_stripe_bytes_up_to(width_px, kStripeRows, SurfaceMode::two_by_two);
}

uint32_t device_bytes(const host::ScreenSize& screen, uint32_t mode, DisplayFormat format)
{
    const host::SurfaceCounts counts = host::counts_of(field, static_cast<SurfaceMode>(mode));
    return with_pixel(format, [&](auto pixel) { return host::surface_view_bytes<decltype(pixel)>(counts, screen); });
}

ViewError look(const Pose& pose, const Image& image, const Style& style, uint8_t* memory)
{
    SurfaceCamera camera;
    if (const CameraError error = make_surface_camera(pose, image, camera); error != CameraError::none)
        return detail::view_error(error);
    const Layout layout(image.height_px);
    const SurfaceMemory borrowed = {reinterpret_cast<SurfaceVertex*>(memory),
                                    reinterpret_cast<uint16_t*>(memory + layout.links),
                                    reinterpret_cast<uint16_t*>(memory + layout.bands), kBandLog2,
                                    reinterpret_cast<uint32_t*>(memory + layout.features)};
    detail::rest_parts(field, borrowed);  // the body is prepared anew: styles may have other pixels
    for (uint32_t k = 0; k < mover_count(field); ++k)
        if (!turn_part(field, borrowed, k, part_values[k]))
            slide_part(field, borrowed, k, static_cast<int32_t>(part_values[k]));
    SurfaceField lit = field;
    if constexpr (has(kFeatures, SurfaceFeatures::states))
        for (uint32_t k = 0; k < field.state_count; ++k) set_state(lit, borrowed, k, weights[k]);
    samples = memory + layout.samples;
    with_pixel(style.format, [&](auto pixel) {
        prepare_surface<decltype(pixel), SurfaceMode::two_by_two, kFeatures>(
            lit, camera, static_cast<SurfaceMode>(style.mode), borrowed, frame);
    });
    return ViewError::none;
}

ViewError draw(const Style& style, const Stripe& stripe)
{
    with_pixel(style.format, [&](auto pixel) {
        render_surface<decltype(pixel), SurfaceMode::two_by_two, kFeatures>(frame, style.behind(), stripe, samples);
    });
    return ViewError::none;
}

}  // namespace lumi::wasm
