// SPDX-License-Identifier: MIT
#include "draw/draw_guided.h"

#include <vector>

#include "draw/guided_stripes.h"
#include "lumi/guided/focus_surface.h"
#include "lumi/proxy/proxy_surface.h"
#include "terminal/failure.h"

namespace lumi::tools
{

extern template Picture draw_stripes(const GuidedField&, const Camera&, ProxySurface<1>&, GuidedMode, const Rgb8&);
extern template Picture draw_stripes(const GuidedField&, const Camera&, ProxySurface<4>&, GuidedMode, const Rgb8&);
extern template Picture draw_stripes(const GuidedField&, const Camera&, FocusSurface&, GuidedMode, const Rgb8&);

namespace
{

constexpr uint32_t kBandLog2 = 4;  // rows of a stripe

template <uint32_t kSamples>
Picture draw_proxy(const GuidedField& field, const GuidedCamera& camera, const GuidedDrawSettings& settings)
{
    const Camera& rays = camera.camera;
    std::vector<ProxyVertex> vertices(field.proxy.vertex_count);
    std::vector<uint16_t> links(field.proxy.triangle_count), bands(proxy_bands(rays.height_px(), kBandLog2));
    std::vector<uint16_t> depths(proxy_stripe_bytes(rays.width_px(), kGuidedStripeRows, kSamples) / sizeof(uint16_t));
    ProxyFrame frame;
    prepare_proxy(field.proxy, camera, kSamples, {vertices.data(), links.data(), bands.data(), kBandLog2}, frame);
    ProxySurface<kSamples> surface(frame, depths.data());
    return draw_stripes(field, rays, surface, settings.mode, settings.background);
}

// What a display of another format makes of the picture.
template <class Pixel>
void show_as(Picture& picture)
{
    for (size_t i = 0; i < picture.rgb.size(); i += 3) {
        uint8_t bytes[Pixel::kBytes];
        Pixel::store(bytes, {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
        const Rgb8 shown = Pixel::load(bytes);
        picture.rgb[i] = shown.r;
        picture.rgb[i + 1] = shown.g;
        picture.rgb[i + 2] = shown.b;
    }
}

Picture drawn(const GuidedField& field, const Eye& eye, const GuidedDrawSettings& settings)
{
    if (field.surface == format::GuidedSurface::focus) {
        FocusSurface surface(field, eye.camera);
        return draw_stripes(field, eye.camera, surface, settings.mode, settings.background);
    }
    GuidedCamera camera;
    if (const CameraError error = make_guided_camera(eye.pose, eye.image, camera); error != CameraError::none)
        throw UsageError(std::string("the camera cannot be used: ") + describe(error));
    return settings.antialiased ? draw_proxy<4>(field, camera, settings) : draw_proxy<1>(field, camera, settings);
}

}  // namespace

Picture draw_guided(const GuidedField& field, const Eye& eye, const GuidedDrawSettings& settings)
{
    Picture picture = drawn(field, eye, settings);
    if (settings.display == DisplayFormat::rgb565) show_as<PixelRgb565>(picture);
    if (settings.display == DisplayFormat::grey8) show_as<PixelGrey8>(picture);
    return picture;
}

}  // namespace lumi::tools
