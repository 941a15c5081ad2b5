// SPDX-License-Identifier: MIT
#include "lumi/guided/focus_surface.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "guided/guided_drawing.h"
#include "lumi/reference/guided_picture.h"
#include "report.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kRandomViews = 2;
#else
constexpr uint32_t kRandomViews = 60;
#endif

// Through the centre of pixel (x, y).
Vec3 viewing_vector(const View& view, int32_t x, int32_t y)
{
    const Image& image = view.image;
    const double per_px =
        2 * std::tan(reference::kPi * image.fov_turns32 / 4294967296.0) / std::max(image.width_px, image.height_px);
    const double right = (x + 0.5 - image.width_px / 2.0 - image.shift_x_q8 / 256.0) * per_px;
    const double up = -(y + 0.5 - image.height_px / 2.0 - image.shift_y_q8 / 256.0) * per_px;
    return reference::decoded(view.pose.forward) + right * reference::decoded(view.pose.right) +
           up * reference::decoded(view.pose.up);
}

// The share of channels that differ by more than `levels`, and the mean difference, against double precision.
struct Agreement {
    double mean = 0, beyond = 0;
};

Agreement against_reference(const GuidedField& field, const View& view, const std::vector<uint8_t>& pixels,
                            double levels)
{
    const reference::GuidedPicture exact = reference::draw_guided(field, view.pose, view.image, {}, kBehind);
    Agreement result;
    for (size_t k = 0; k < exact.colours.size(); ++k) {
        const double c[3] = {exact.colours[k].r, exact.colours[k].g, exact.colours[k].b};
        for (size_t m = 0; m < 3; ++m) {
            const double d = std::fabs(c[m] - pixels[3 * k + m]);
            result.mean += d / static_cast<double>(pixels.size());
            if (d > levels) result.beyond += 1 / static_cast<double>(pixels.size());
        }
    }
    return result;
}

}  // namespace

TEST_CASE("the focus surface is where double precision puts it", "[guided]")
{
    const int32_t radius_q14 = GENERATE(0, 6000);
    const OpenedGuided opened(focus_field(64, 64, radius_q14));
    Worst worst, far;
    for (const View& view : extreme_views(kSide)) {
        if (!view.visible) continue;
        const Camera camera = camera_of(view);
        FocusSurface surface(opened.field, camera);
        const double distance = reference::length(reference::decoded(view.pose.eye));
        for (int32_t y = 0; y < camera.height_px(); y += 3) {
            const RowSpan covered = covered_span(camera, y, 0, camera.width_px());
            surface.begin_row(y);
            for (int32_t x = covered.begin; x < covered.end; x += 2) {
                SurfacePoint seen[1];
                REQUIRE(surface.at(x, seen) == 1);
                const Vec3 eye = reference::decoded(view.pose.eye);
                const Vec3 d = reference::normalised(viewing_vector(view, x, y));
                const auto focus = [&](int k) { return opened.field.focus_q14[k] / 16384.0; };
                const Vec3 f = {focus(0), focus(1), focus(2)};
                Vec3 nearest = eye + reference::dot(f - eye, d) * d;
                const double rest = std::pow(radius_q14 / 16384.0, 2) - reference::dot(nearest - f, nearest - f);
                if (std::fabs(rest) < 0.002) continue;  // where the ray touches the focus sphere the root has no slope
                if (rest > 0) nearest = nearest + (-std::sqrt(rest)) * d;
                const Vec3 got = {seen[0].x_q14 / 16384.0, seen[0].y_q14 / 16384.0, seen[0].z_q14 / 16384.0};
                (distance < 10 ? worst : far)
                    .see(reference::length(got - nearest), static_cast<uint64_t>(y * 10000 + x));
            }
        }
    }
    worst.report("focus surface");
    far.report("focus surface from far away");
    CHECK(worst.error < 1.0 / 512);
    CHECK(far.error < 1.0 / 128);
}

TEST_CASE("pictures of focus fields are those of double precision at every extreme", "[guided]")
{
#ifdef LUMI_TEST_LIGHT
    const uint32_t origins = GENERATE(64u, 300u);  // 4096 would not fit into a board's memory
#else
    const uint32_t origins = GENERATE(64u, 300u, 4096u);
#endif
    const OpenedGuided opened(focus_field(origins, origins, 0));
    for (const View& view : extreme_views(kSide)) {
        INFO(view.name << ", " << origins << " origins");
        const Camera camera = camera_of(view);
        FocusSurface surface(opened.field, camera);
        const Agreement a = against_reference(opened.field, view, draw<Linear3>(opened.field, camera, surface), 12);
        std::printf("%-36s mean %.3f levels, beyond 12: %.4f\n", view.name.c_str(), a.mean, a.beyond);
        CHECK(a.mean < 1.2);
        CHECK(a.beyond < 0.02);
    }
}

TEST_CASE("pictures of focus fields are those of double precision from anywhere", "[guided]")
{
    const OpenedGuided opened(focus_field(128, 100, 5000));
    std::minstd_rand random(11);
    Worst mean, beyond;
    for (uint32_t n = 0; n < kRandomViews; ++n) {
        const View view = random_view(random, kSide);
        const Camera camera = camera_of(view);
        FocusSurface surface(opened.field, camera);
        const Agreement a = against_reference(opened.field, view, draw<Linear3>(opened.field, camera, surface), 12);
        mean.see(a.mean, n);
        beyond.see(a.beyond, n);
    }
    mean.report("mean difference of random views, levels");
    beyond.report("share beyond 12 levels");
    // Spans of 16 pixels in pictures of 80: at their real size the error of stepping is a ninth.
    CHECK(mean.error < 1.4);
    CHECK(beyond.error < 0.03);
}
