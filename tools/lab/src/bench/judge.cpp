// SPDX-License-Identifier: MIT
#include "bench/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lumi/chord/detail/sphere.h"
#include "metrics/metrics.h"

namespace lumi::bench
{
namespace
{

using twin::Vec3;
using twin::Weights;
using Points = std::vector<Vec3>;

constexpr uint32_t kPaperNeighbours = 5;

// One side's taps of a hit, and whether they were a close call.
struct SideTaps {
    Weights weights;
    bool uncertain;
};

SideTaps taps_of_side(const std::string& mode, const Points& all, const Vec3& hit)
{
    if (mode == "nearest") {
        const twin::CellPoint point = twin::nearest_point(all, hit, kBorderShare);
        return {{{point.index, 1.0}}, point.uncertain};
    }
    if (mode == "paper") return {twin::paper_weights(all, hit, kPaperNeighbours), false};
    return {twin::linear_weights(all, hit), false};
}

uint8_t rounded(double level)
{
    return static_cast<uint8_t>(std::lround(std::clamp(level, 0.0, 255.0)));
}

// The pixels that count, side by side in a picture one pixel high, so that the usual metric judges them alone.
tools::Picture packed(const tools::Picture& picture, const ViewTaps& taps, bool with_uncertain)
{
    tools::Picture result;
    for (const ViewTaps::Pixel& pixel : taps.pixels) {
        if (pixel.uncertain && !with_uncertain) continue;
        const uint8_t* at = picture.pixel(pixel.x, pixel.y);
        result.rgb.insert(result.rgb.end(), at, at + 3);
    }
    result.width_px = static_cast<int>(result.rgb.size() / 3);
    result.height_px = 1;
    return result;
}

uint32_t worst_difference(const tools::Picture& a, const tools::Picture& b)
{
    int worst = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) worst = std::max(worst, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    return static_cast<uint32_t>(worst);
}

}  // namespace

Judge::Judge(const Field& field)
    : origins_(twin::points(field.origins.size())), directions_(twin::points(field.directions.size()))
{
}

const ViewTaps& Judge::taps_of(const std::string& mode, const View& view)
{
    const auto [at, is_new] = taps_.try_emplace({mode, view.name});
    if (!is_new) return at->second;
    Camera camera;
    if (make_view_camera(view, camera) != CameraError::none) return at->second;
    const Pose pose = detail::orbit(view.azimuth_turns32, view.elevation_turns32, view.distance_q20);
    const Image image = {kSidePx, kSidePx, view.fov_turns32};
    for (int y = 0; y < kSidePx; ++y) {
        const detail::Extent span = detail::covered_extent(camera, y, 0, kSidePx);
        for (int x = span.begin; x < span.end; ++x) {
            const twin::Hits hit = twin::hits_of_pixel(pose, image, x, y);
            SideTaps front = taps_of_side(mode, origins_, hit.front);
            SideTaps back = taps_of_side(mode, directions_, hit.back);
            at->second.pixels.push_back(
                {x, y, std::move(front.weights), std::move(back.weights), front.uncertain || back.uncertain});
        }
    }
    return at->second;
}

tools::Picture Judge::exact_picture(const std::string& mode, const Field& field, const View& view)
{
    tools::Picture picture(kSidePx, kSidePx, kBackgroundColour);
    for (const ViewTaps::Pixel& pixel : taps_of(mode, view).pixels) {
        const twin::Colour c = twin::blended(field, pixel.origins, pixel.directions, kBackgroundColour);
        uint8_t* at = picture.pixel(pixel.x, pixel.y);
        at[0] = rounded(c.r);
        at[1] = rounded(c.g);
        at[2] = rounded(c.b);
    }
    return picture;
}

Accuracy Judge::judge(const std::string& mode, const Field& field, const View& view, const tools::Picture& drawn)
{
    const ViewTaps& taps = taps_of(mode, view);
    const tools::Picture exact = exact_picture(mode, field, view);
    const tools::Picture a = packed(exact, taps, false);
    const tools::Picture b = packed(drawn, taps, false);
    return {tools::psnr_db(a, b), tools::psnr_db(packed(exact, taps, true), packed(drawn, taps, true)),
            worst_difference(a, b)};
}

}  // namespace lumi::bench
