// SPDX-License-Identifier: MIT
// Whole frames of proxy surfaces, pixel by pixel, in stripes of any shape.
#pragma once

#include <vector>

#include "lumi/proxy/proxy_surface.h"
#include "proxy/proxy_meshes.h"
#include "views.h"

namespace lumi::test
{

struct DrawingOptions {
    bool stores_vertices = true;
    uint32_t band_log2 = 4;
    int32_t stripe_width_px = 8192, stripe_rows = 16;
    bool upwards = false;
};

// The surfaces of every pixel; none where the ray misses the sphere.
struct SurfacePicture {
    int32_t width_px = 0, height_px = 0;
    std::vector<std::vector<SurfacePoint>> pixels;

    const std::vector<SurfacePoint>& at(int32_t x, int32_t y) const
    {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width_px) + static_cast<size_t>(x)];
    }
};

template <uint32_t Samples>
SurfacePicture draw_surface(const ProxyMesh& mesh, const Pose& pose, const Image& image,
                            const DrawingOptions& options = {})
{
    GuidedCamera camera;
    SurfacePicture picture = {image.width_px, image.height_px, {}};
    if (make_guided_camera(pose, image, camera) != CameraError::none) return picture;
    // Each memory as large as stated and not a byte more, so that a sanitizer sees what lies beside it.
    std::vector<ProxyVertex> vertices(options.stores_vertices ? mesh.vertex_count : 0);
    std::vector<uint16_t> links(mesh.triangle_count), bands(proxy_bands(image.height_px, options.band_log2));
    const ProxyMemory memory = {options.stores_vertices ? vertices.data() : nullptr, links.data(), bands.data(),
                                options.band_log2};
    ProxyFrame frame;
    prepare_proxy(mesh, camera, Samples, memory, frame);
    picture.pixels.resize(static_cast<size_t>(image.width_px) * static_cast<size_t>(image.height_px));
    const auto draw = [&](const Stripe& stripe) {
        std::vector<uint16_t> depths(proxy_stripe_bytes(stripe.width_px, stripe.height_px, Samples) / 2);
        ProxySurface<Samples> surface(frame, depths.data());
        surface.begin_stripe(stripe);
        const RowSpan columns = surface.columns();
        for (int32_t y = stripe.y_px; y < stripe.y_px + stripe.height_px; ++y) {
            const RowSpan span = covered_span(camera.camera, y, stripe.x_px, stripe.x_px + stripe.width_px);
            for (int32_t x = span.begin; x < span.end; ++x) {
                SurfacePoint points[Samples];
                const uint32_t count = surface.at(x, y, points);
                if (x < columns.begin || x >= columns.end) {
                    if (count != 0) picture.height_px = 0;  // columns() lied: no picture
                    continue;
                }
                picture.pixels[static_cast<size_t>(y) * static_cast<size_t>(image.width_px) + static_cast<size_t>(x)]
                    .assign(points, points + count);
            }
        }
    };
    const int32_t rows = std::min(options.stripe_rows, image.height_px);
    const int32_t width = std::min(options.stripe_width_px, image.width_px);
    const int32_t stripes = (image.height_px + rows - 1) / rows;
    for (int32_t k = 0; k < stripes; ++k) {
        const int32_t y = (options.upwards ? stripes - 1 - k : k) * rows;
        for (int32_t x = 0; x < image.width_px; x += width) {
            draw({nullptr, x, y, std::min(width, image.width_px - x), std::min(rows, image.height_px - y), 0});
        }
    }
    return picture;
}

}  // namespace lumi::test
