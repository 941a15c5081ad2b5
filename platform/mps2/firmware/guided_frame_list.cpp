// SPDX-License-Identifier: MIT
// The guided part of the frame list: every view, from the best picture to the cheapest, of a proxy and of a focus
// surface.
#include "frame_list.h"
#include "lumi/crc32.h"
#include "lumi/guided/focus_surface.h"
#include "lumi/guided/guided_render.h"
#include "lumi/proxy/proxy_surface.h"
#include "text_line.h"
#include "views.h"

namespace lumi::firmware
{
namespace
{

constexpr int32_t kWidth = 48;
constexpr int32_t kHeight = 36;
constexpr int32_t kStripeRows = 10;  // does not divide the height: the last stripe is shorter
constexpr uint32_t kBandLog2 = 3;
constexpr uint32_t kStrideBytes = kWidth * PixelRgb888::kBytes;
constexpr uint32_t kMaxVertices = 64, kMaxTriangles = 64;  // of the test's field
constexpr Rgb8 kBackground = {40, 96, 168};

using Best = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanRgb565, OcclusionUse::read>;
using Nearest3 = GuidedPolicy<ThreeOrigins, NearestTap, GuidedIndex4, MeanRgb565, OcclusionUse::ignored>;
using Least = GuidedPolicy<OneOrigin, NearestTap, GuidedIndex4, MeanRgb565, OcclusionUse::read>;
using MeanAlone = GuidedPolicy<OneOrigin, NearestTap, NoChart, MeanRgb565, OcclusionUse::ignored>;

uint8_t stripe_pixels[kStripeRows * kStrideBytes];
ProxyVertex vertices[kMaxVertices];
uint16_t links[kMaxTriangles];
uint16_t bands[proxy_bands(kHeight, kBandLog2)];
alignas(4) uint16_t depths[proxy_stripe_bytes(kWidth, kStripeRows, 4) / sizeof(uint16_t)];

struct Frame {
    const View& view;
    const GuidedField& field;
    const GuidedCamera& camera;
    WriteText write;
};

template <class Policy, class Surface>
bool write_line(const Frame& frame, Surface& surface, const char* name)
{
    uint32_t crc = 0;
    for (int32_t y = 0; y < kHeight; y += kStripeRows) {
        const int32_t rows = kHeight - y < kStripeRows ? kHeight - y : kStripeRows;
        const Stripe stripe = {stripe_pixels, 0, y, kWidth, rows, kStrideBytes};
        if (render_guided<Policy, PixelRgb888>(frame.field, frame.camera.camera, surface, OverColour{kBackground},
                                               stripe) != GuidedError::none) {
            return false;
        }
        crc = crc32(crc, stripe_pixels, static_cast<uint32_t>(rows) * kStrideBytes);
    }
    TextLine line;
    line.text(frame.view.name).text(" guided ").text(name).text(" rgb888 ");
    frame.write(line.hex32(crc).text("\n").c_str());
    return true;
}

template <class Surface>
bool write_steps(const Frame& frame, Surface& surface, const char* const (&names)[4])
{
    return write_line<Best>(frame, surface, names[0]) && write_line<Nearest3>(frame, surface, names[1]) &&
           write_line<Least>(frame, surface, names[2]) && write_line<MeanAlone>(frame, surface, names[3]);
}

template <uint32_t kSamples>
bool write_proxy(const Frame& frame, const char* const (&names)[4])
{
    ProxyFrame proxy;
    prepare_proxy(frame.field.proxy, frame.camera, kSamples, {vertices, links, bands, kBandLog2}, proxy);
    ProxySurface<kSamples> surface(proxy, depths);
    return write_steps(frame, surface, names);
}

bool write_focus(const Frame& frame)
{
    GuidedField focused = frame.field;
    focused.surface = format::GuidedSurface::focus;
    focused.focus_q14[1] = 2000;
    focused.focus_radius_q14 = 7000;
    FocusSurface surface(focused, frame.camera.camera);
    return write_steps({frame.view, focused, frame.camera, frame.write}, surface,
                       {"focus", "focus-nearest", "focus-one-origin", "focus-mean"});
}

bool write_view(const View& view, const GuidedField& field, WriteText write)
{
    GuidedCamera camera;
    if (make_guided_camera(view.pose(), view.image(kWidth, kHeight), camera) != CameraError::none) return false;
    const Frame frame = {view, field, camera, write};
    return write_proxy<1>(frame, {"proxy", "proxy-nearest", "proxy-one-origin", "proxy-mean"}) &&
           write_proxy<4>(frame, {"proxy-aa", "proxy-aa-nearest", "proxy-aa-one-origin", "proxy-aa-mean"}) &&
           write_focus(frame);
}

bool write_views(const FieldBytes& file, WriteText write)
{
    GuidedField field;
    if (open_guided(file.bytes, file.size, field) != FieldError::none) return false;
    if (field.proxy.vertex_count > kMaxVertices || field.proxy.triangle_count > kMaxTriangles) return false;
    for (const View& view : kViews)
        if (!write_view(view, field, write)) return false;
    return true;
}

}  // namespace

bool write_guided_crcs(const FieldBytes& file, WriteText write)
{
    const bool written = write_views(file, write);
    if (!written) write("error: the guided field cannot be drawn\n");
    return written;
}

}  // namespace lumi::firmware
