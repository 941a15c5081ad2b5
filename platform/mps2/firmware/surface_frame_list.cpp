// SPDX-License-Identifier: MIT
// The surface part of the frame list.
#include "listed_frame.h"
#include "lumi/detail/crc32.h"
#include "lumi/surface/render.h"

namespace lumi::firmware
{
namespace
{

// These views join kViews, where clipping, depth and near edges are hardest. Rounding takes an eye no farther
// than this inside the sphere or beyond the end.
constexpr int32_t kRounding = 64;
constexpr View kHardViews[] = {
    {"on-vertex", 0, 0, kOneQ20 + kRounding, kMaxFovTurns32, 0, 0},
    {"on-sphere", 13 * kTurnHundredth, 4 * kTurnHundredth, kOneQ20 + kRounding, kMaxFovTurns32, 0, 0},
    {"shifted", 55 * kTurnHundredth, -9 * static_cast<int32_t>(kTurnHundredth), radii_q20(130), 80 * kDegree, 20 * 256,
     -36 * 256},
    {"far", 71 * kTurnHundredth, 19 * kTurnHundredth, kMaxEyeDistanceQ20 - kRounding, kMinFovTurns32, 0, 0},
    {"tiny", 5 * kTurnHundredth, 2 * kTurnHundredth, radii_q20(1000), kMaxFovTurns32, 0, 0},
    {"narrow", 42 * kTurnHundredth, 15 * kTurnHundredth, radii_q20(105), kMinFovTurns32, 0, 0},
};

// Looks along the sphere instead of at its centre.
Pose aside(const Pose& pose)
{
    return {pose.eye, {-pose.forward.x, -pose.forward.y, -pose.forward.z}, pose.up, pose.right};
}

// Makes a view named "chance" from a number, from 1 to 4 radii.
View chance_view(uint32_t number)
{
    uint32_t state = number * 0x9E3779B9;
    const auto next = [&] { return (state = state * 1664525 + 1013904223) >> 8; };
    const uint32_t azimuth = next() << 8;
    const int32_t elevation = static_cast<int32_t>(next() << 7) - kQuarterTurn;
    const int32_t distance = kOneQ20 + kRounding + static_cast<int32_t>(next() % (3 * kOneQ20));
    return {"chance", azimuth, elevation, distance, (2 + next() % 118) * kDegree, 0, 0};
}

constexpr int32_t kWidth = 48, kHeight = 36;
constexpr uint32_t kBandLog2 = 3;
constexpr uint32_t kMaxVertices = 128, kMaxPatches = 128;  // the test's fields have no more
constexpr uint32_t kChanceViews = 8;
constexpr Rgb8 kBackground = {40, 96, 168};

struct NamedMode {
    const char* name;
    SurfaceMode mode;
};
constexpr NamedMode kModes[] = {{"one-sample", SurfaceMode::one_sample},
                                {"antialiased", SurfaceMode::antialiased},
                                {"2x2", SurfaceMode::two_by_two}};

SurfaceVertex vertices[kMaxVertices];
uint16_t links[surface_links(kMaxPatches)];
uint16_t bands[surface_bands(kHeight, kBandLog2)];
uint32_t samples[surface_stripe_bytes(kWidth, kHeight, SurfaceMode::two_by_two) / sizeof(uint32_t)];
uint8_t pixels[kWidth * kHeight * PixelRgb888::kBytes];

struct Part {
    const SurfaceField& field;
    const char* name;
    WriteText write;
};

// A frame cut into rectangles so wide and high; those at the right and lower end reach beyond the image.
struct Cut {
    int32_t width_px, height_px;
};
constexpr Cut kStripes = {kWidth, 10};
constexpr Cut kOtherCuts[] = {{kWidth, 1}, {kWidth, kHeight}, {17, 13}};

template <class Pixel>
uint32_t frame_crc(const SurfaceFrame& frame, const Cut& cut)
{
    constexpr uint32_t kStrideBytes = kWidth * Pixel::kBytes;
    for (int32_t y = 0; y < kHeight; y += cut.height_px) {
        for (int32_t x = 0; x < kWidth; x += cut.width_px) {
            const int32_t width = kWidth - x < cut.width_px ? kWidth - x : cut.width_px;
            const int32_t height = kHeight - y < cut.height_px ? kHeight - y : cut.height_px;
            uint8_t* const at =
                pixels + static_cast<uint32_t>(y) * kStrideBytes + static_cast<uint32_t>(x) * Pixel::kBytes;
            const Stripe stripe = {at, x, y, width, height, kStrideBytes};
            render_surface<Pixel>(frame, OverColour{kBackground}, stripe, samples);
        }
    }
    return detail::crc32(0, pixels, kHeight * kStrideBytes);
}

template <class Pixel>
bool write_line(const Part& part, const char* view, const SurfaceFrame& frame, const char* mode, const char* pixel)
{
    const uint32_t crc = frame_crc<Pixel>(frame, kStripes);
    for (const Cut& cut : kOtherCuts) {
        if (frame_crc<Pixel>(frame, cut) == crc) continue;
        part.write("error: a frame differs with its stripes\n");
        return false;
    }
    TextLine line;
    line.text(view).text(" ").text(part.name).text(" ").text(mode).text(" ").text(pixel).text(" ");
    part.write(line.hex32(crc).text("\n").c_str());
    return true;
}

template <class Pixel>
bool write_modes(const Part& part, const char* view, const SurfaceCamera& camera, const char* pixel)
{
    for (const NamedMode& mode : kModes) {
        SurfaceFrame frame;
        prepare_surface<Pixel>(part.field, camera, mode.mode, {vertices, links, bands, kBandLog2}, frame);
        if (!write_line<Pixel>(part, view, frame, mode.name, pixel)) return false;
    }
    return true;
}

bool write_view(const Part& part, const char* view, const Pose& pose, const Image& image)
{
    SurfaceCamera camera;
    const CameraError error = make_surface_camera(pose, image, camera);
    if (error == CameraError::none) return write_modes<PixelRgb565>(part, view, camera, "rgb565");
    part.write("error: ");
    part.write(describe(error));
    return false;
}

bool write_ordinary_view(const Part& part, const View& view)
{
    SurfaceCamera camera;
    return write_view(part, view.name, view.pose(), view.image(kWidth, kHeight)) &&
           make_surface_camera(view.pose(), view.image(kWidth, kHeight), camera) == CameraError::none &&
           write_modes<PixelRgb565Swapped>(part, view.name, camera, "rgb565-swapped") &&
           write_modes<PixelRgb888>(part, view.name, camera, "rgb888") &&
           write_modes<PixelGrey8>(part, view.name, camera, "grey8");
}

bool write_hard_views(const Part& part)
{
    for (const View& view : kHardViews) {
        const Image image = view.image(kWidth, kHeight);
        if (!write_view(part, view.name, view.pose(), image)) return false;
        const bool is_near = view.distance_q20 < kOneQ20 + 2 * kRounding;
        if (is_near && !write_view(part, view.name, aside(view.pose()), image)) return false;
    }
    for (uint32_t k = 0; k < kChanceViews; ++k) {
        const View view = chance_view(k);
        if (!write_view(part, view.name, view.pose(), view.image(kWidth, kHeight))) return false;
    }
    return true;
}

bool write_views(const Part& part)
{
    for (const View& view : kViews)
        if (!write_ordinary_view(part, view)) return false;
    return write_hard_views(part);
}

}  // namespace

bool write_surface_crcs(const FieldBytes& file, const char* name, WriteText write)
{
    SurfaceField field;
    const FieldError error = open_surface(file.bytes, file.size, field);
    if (error == FieldError::none && field.vertex_count <= kMaxVertices && field.patch_count <= kMaxPatches)
        return write_views({field, name, write});
    write("error: the surface field cannot be drawn: ");
    write(describe(error));
    write("\n");
    return false;
}

}  // namespace lumi::firmware
