// SPDX-License-Identifier: MIT
#include "comparison/sprites.h"

#include <algorithm>
#include <cmath>

#include "image/picture_file.h"
#include "lumi/baker/reference.h"
#include "lumi/detail/lattice.h"
#include "lumi/twin/geometry.h"
#include "terminal/failure.h"

namespace lumi::bench
{
namespace
{

using twin::decoded;
using twin::dot;
using twin::kPi;

constexpr double kTurn = 4294967296.0;

int32_t signed_turns32(double radians)
{
    return static_cast<int32_t>(std::lround(radians / (2 * kPi) * kTurn));
}

Pose sprite_pose(const SpriteSheet& sheet, uint32_t index)
{
    const double z = twin::from_q30(detail::Lattice(sheet.count).height_q30(index));
    return detail::orbit(detail::longitude_turns32(index), signed_turns32(std::asin(z)), kFarQ20);
}

// As the device holds it.
tools::Picture stored(const SpriteSheet& sheet, const tools::Picture& traced)
{
    if (sheet.jpeg_bytes != 0) return tools::through_jpeg(traced, sheet.jpeg_bytes);
    tools::Picture shown = traced;
    for (size_t i = 0; i < shown.rgb.size(); i += 3) {
        const Rgb8 colour =
            detail::unpack_rgb565(detail::pack_rgb565({traced.rgb[i], traced.rgb[i + 1], traced.rgb[i + 2]}));
        shown.rgb[i] = colour.r;
        shown.rgb[i + 1] = colour.g;
        shown.rgb[i + 2] = colour.b;
    }
    return shown;
}

// Pixels from the middle of the picture to the sphere's outline.
double disc_radius_px(uint32_t fov_turns32, int32_t distance_q20)
{
    const double distance = static_cast<double>(distance_q20) / kOneQ20;
    return kSidePx / 2.0 * std::tan(std::asin(1 / distance)) / std::tan(kPi * fov_turns32 / kTurn);
}

// The turn, about the optical axis, of the screen against the sprite.
struct Turn {
    double cosine, sine;

    Turn(const Pose& view, const Pose& sprite)
    {
        const double c = dot(decoded(view.right), decoded(sprite.right)) + dot(decoded(view.up), decoded(sprite.up));
        const double s = dot(decoded(view.right), decoded(sprite.up)) - dot(decoded(view.up), decoded(sprite.right));
        const double length = std::hypot(c, s);
        cosine = length > 0 ? c / length : 1;
        sine = length > 0 ? s / length : 0;
    }
};

// The path-traced reference of a view over kBackgroundColour.
tools::Picture traced_view(const baker::Scene& scene, const Pose& pose, const Image& image, uint32_t samples)
{
    Camera camera;
    if (const CameraError error = make_camera(pose, image, camera); error != CameraError::none)
        throw tools::Failure("bench view", describe(error), "report this");
    const baker::RgbaImage traced = baker::render_reference(scene, camera, {samples, 1, 0});
    tools::Picture picture(traced.width, traced.height);  // premultiplied, over black: the colours as they are
    for (size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = traced.rgba[i / 3 * 4 + i % 3];
    return picture;
}

// Which sprite, seen from kFarQ20, lies nearest to the view.
uint32_t nearest_sprite(const SpriteSheet& sheet, const View& view)
{
    const Vec3q20 eye = view_pose(view).eye;
    uint32_t best = 0;
    double best_cosine = -1e9;
    for (uint32_t i = 0; i < sheet.count; ++i) {
        const double cosine = dot(decoded(sprite_pose(sheet, i).eye), decoded(eye));
        if (cosine <= best_cosine) continue;
        best_cosine = cosine;
        best = i;
    }
    return best;
}

}  // namespace

tools::Picture sprite_picture(const baker::Scene& scene, const SpriteSheet& sheet, const View& view)
{
    const Pose pose = sprite_pose(sheet, nearest_sprite(sheet, view));
    const int32_t side_px = sheet.side_px;
    const tools::Picture sprite =
        stored(sheet, traced_view(scene, pose, {side_px, side_px, kFillingFov}, sheet.samples));
    const Turn turn(view_pose(view), pose);
    const double scale =
        disc_radius_px(kFillingFov, kFarQ20) / disc_radius_px(view.fov_turns32, view.distance_q20) * side_px / kSidePx;
    constexpr double kMiddle = (kSidePx - 1) / 2.0;
    const double sprite_middle = (side_px - 1) / 2.0;
    tools::Picture picture(kSidePx, kSidePx, kBackgroundColour);
    for (int y = 0; y < kSidePx; ++y) {
        for (int x = 0; x < kSidePx; ++x) {
            const double right = (x - kMiddle) * scale, up = (kMiddle - y) * scale;
            const long u = std::lround(sprite_middle + right * turn.cosine - up * turn.sine);
            const long v = std::lround(sprite_middle - right * turn.sine - up * turn.cosine);
            if (u < 0 || v < 0 || u >= side_px || v >= side_px) continue;
            std::copy_n(sprite.pixel(static_cast<int>(u), static_cast<int>(v)), 3, picture.pixel(x, y));
        }
    }
    return picture;
}

}  // namespace lumi::bench
