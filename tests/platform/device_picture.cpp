// SPDX-License-Identifier: MIT
// lumi_device_picture FIELD FORMAT WIDTH HEIGHT ROWS AZIMUTH ELEVATION OUT [ZOOM]
// Draws what a device of platform/ shows on the host by the free functions in one piece: the pixels of its display, in
// FORMAT grey4 (two pixels a byte), rgb565, rgb565-swapped, or coverage (a byte a pixel). ROWS of the device's
// stripes decide the bands: where triangles touch, their order shows. Angles in 2^-32 turns, 3 radii away; ZOOM
// in 2^-16.
// tools/lab/devices.sh compares the emulated displays with it.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "file_bytes.h"
#include "lumi/orbit.h"
#include "lumi/pack.h"
#include "lumi/surface/render.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;

constexpr SurfaceMode kMode = SurfaceMode::antialiased;
constexpr SurfaceFeatures kFeatures = SurfaceFeatures::all;

[[noreturn]] void fail(const std::string& what)
{
    std::fprintf(stderr, "lumi_device_picture: %s\n", what.c_str());
    std::exit(1);
}

struct Display {
    int32_t width_px, height_px, stripe_rows;
};

template <class Pixel, class Background = OverBlack>
std::vector<uint8_t> drawn(const SurfaceField& field, const Display& display, const Orbit& orbit)
{
    SurfaceCamera camera;
    const auto [width, height, stripe_rows] = display;
    const uint32_t band_log2 = surface_band_log2(stripe_rows);
    if (make_surface_camera(pose_of(orbit), image_of(orbit, width, height), camera) != CameraError::none)
        fail("this camera cannot be");
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(height, band_log2));
    std::vector<uint32_t> features(feature_words(field));
    SurfaceFrame frame;
    prepare_surface<Pixel, kMode, kFeatures>(
        field, camera, kMode, {vertices.data(), links.data(), bands.data(), band_log2, features.data()}, frame);
    std::vector<uint32_t> samples(surface_stripe_bytes(width, height, kMode) / sizeof(uint32_t) + 1);
    const uint32_t stride = static_cast<uint32_t>(width) * Pixel::kBytes;
    std::vector<uint8_t> pixels(stride * static_cast<uint32_t>(height));
    render_surface<Pixel, kMode, kFeatures>(frame, Background{}, {pixels.data(), 0, 0, width, height, stride},
                                            samples.data());
    return pixels;
}

std::vector<uint8_t> packed(std::vector<uint8_t> greys, const Display& display)
{
    const auto [width, height, rows] = display;
    std::vector<uint8_t> out(grey4_bytes(width) * static_cast<uint32_t>(height));
    pack_grey4({greys.data(), 0, 0, width, height, static_cast<uint32_t>(width)}, out.data(), grey4_bytes(width));
    return out;
}

std::vector<uint8_t> picture(const std::string& format, const SurfaceField& field, const Display& display,
                             const Orbit& orbit)
{
    if (format == "grey4") return packed(drawn<PixelGrey8>(field, display, orbit), display);
    if (format == "rgb565") return drawn<PixelRgb565>(field, display, orbit);
    if (format == "coverage") return drawn<PixelA8, OverNothing>(field, display, orbit);
    if (format == "rgb565-swapped") return drawn<PixelRgb565Swapped>(field, display, orbit);
    fail("no format is called " + format);
}

}  // namespace

int main(int count, char** arguments)
{
    if (count != 9 && count != 10) fail("FIELD FORMAT WIDTH HEIGHT ROWS AZIMUTH ELEVATION OUT [ZOOM]");
    const auto number = [&](int k) { return static_cast<uint32_t>(std::strtoul(arguments[k], nullptr, 10)); };
    const std::vector<uint8_t> file = test::file_bytes(arguments[1]);
    SurfaceField field;
    if (open_surface<kFeatures>(file.data(), file.size(), field) != FieldError::none)
        fail("this is no surface field that can be drawn");
    const auto side = [&](int k) { return static_cast<int32_t>(number(k)); };
    Orbit orbit = {number(6), number(7)};
    if (count == 10) orbit.zoom_q16 = number(9);
    const auto pixels = picture(arguments[2], field, {side(3), side(4), side(5)}, orbit);
    std::ofstream out(arguments[8], std::ios::binary);
    out.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
    return out.flush() ? 0 : 1;
}
