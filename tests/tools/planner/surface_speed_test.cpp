// SPDX-License-Identifier: MIT
// These tests count what a frame of a surface field takes, and what that costs.
#include "planner/speed.h"

#include <catch2/catch.hpp>

#include "lumi/host/camera.h"
#include "support/small_surface.h"

namespace lumi::planner
{

namespace
{

constexpr SurfaceMode kModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};

SurfaceField opened()
{
    SurfaceField field;
    const auto& file = tools::test::small_surface().file;
    REQUIRE(open_surface(file.data(), file.size(), field) == FieldError::none);
    return field;
}

tools::Eye eye_at(double azimuth, double elevation, double distance)
{
    tools::Eye eye = {host::make_pose({azimuth, elevation, distance}), host::make_image(240, 240, 42), {}};
    REQUIRE(make_camera(eye.pose, eye.image, eye.camera) == CameraError::none);
    return eye;
}

// Returns how many samples of opaque triangles a frame takes.
double samples_of(const FrameWork& work)
{
    return static_cast<double>(work[Work::sample] + work[Work::two_taps_sample] + work[Work::packed_sample] +
                               work[Work::bilinear_sample]);
}

double shown_of(const FrameWork& work)
{
    return static_cast<double>(work[Work::shown] + work[Work::two_taps_shown] + work[Work::packed_shown] +
                               work[Work::bilinear_shown]);
}

double begun(const FrameWork& work)
{
    return static_cast<double>(work[Work::begun]);
}

}  // namespace

TEST_CASE("a frame of a cube takes what its faces show")
{
    const SurfaceField field = opened();
    const FrameWork front = work_of(field, eye_at(0, 0, 3), SurfaceMode::one_sample, 16).frame;
    // The sphere's radius is √3 of the half edge: the front face lies 3 - 1/√3 away and is 2/√3 wide.
    const double focal = 120 / std::tan(21 * 3.14159265 / 180), side = focal * 1.1547 / (3 - 0.57735);
    CHECK(samples_of(front) == Approx(side * side).epsilon(0.05));
    const auto listed = [](const FrameWork& work) { return static_cast<double>(work[Work::listed]); };
    CHECK(listed(front) == Approx(tools::test::small_surface().triangles / 6.0).epsilon(0.1));
    const FrameWork corner = work_of(field, eye_at(45, 35, 3), SurfaceMode::one_sample, 16).frame;
    CHECK(listed(corner) > 2.7 * listed(front));
    const FrameWork fine = work_of(field, eye_at(45, 35, 3), SurfaceMode::two_by_two, 16).frame;
    CHECK(samples_of(fine) == Approx(4 * samples_of(corner)).epsilon(0.01));
    CHECK(begun(fine) >= begun(corner));
}

TEST_CASE("nothing hides behind a convex body, and what is drawn has rows and samples")
{
    for (const SurfaceMode mode : kModes) {
        const FrameWork work = work_of(opened(), eye_at(30, 20, 3), mode, 16).frame;
        CHECK(shown_of(work) == samples_of(work));
        CHECK(work[Work::filled] <= work[Work::row]);
        CHECK(work[Work::begun] <= work[Work::boxed] + work[Work::split_part]);
        CHECK(work[Work::boxed] <= work[Work::offered]);
        CHECK(work[Work::offered] <= work[Work::link]);
        CHECK((work[Work::marked] > 0) == (mode == SurfaceMode::antialiased));
        CHECK((work[Work::four_whole] > 0) == (mode == SurfaceMode::two_by_two));
        CHECK(work[Work::frame] == 1);
        CHECK(work[Work::stripe] <= 15);  // those that show something
    }
}

TEST_CASE("modes of surface fields cost more from one sample to four, and nearer eyes more than far ones")
{
    const SurfaceField field = opened();
    for (const char* core : {"m4", "m0plus"}) {
        double before = 0;
        for (const SurfaceMode mode : kModes) {
            const double cost = instructions_of(core, work_of(field, eye_at(45, 35, 3), mode, 16).frame);
            CHECK(cost > before);
            CHECK(cost > instructions_of(core, work_of(field, eye_at(45, 35, 6), mode, 16).frame));
            before = cost;
        }
    }
}

TEST_CASE("lower stripes set up more triangles, and more scanlines twice where outlines are blended")
{
    const SurfaceField field = opened();
    const tools::Eye eye = eye_at(45, 35, 3);
    for (const SurfaceMode mode : kModes) {
        const FrameWork low = work_of(field, eye, mode, 4).frame, usual = work_of(field, eye, mode, 16).frame,
                        whole = work_of(field, eye, mode, 240).frame;
        CHECK(begun(low) > 1.2 * begun(usual));
        CHECK(begun(usual) > begun(whole));
        const double twice = mode == SurfaceMode::antialiased ? (1 + 2.0 / 4) / (1 + 2.0 / 16) : 1;
        CHECK(samples_of(low) == Approx(twice * samples_of(usual)).epsilon(0.02));
        CHECK((low[Work::line] > usual[Work::line]) == (mode == SurfaceMode::antialiased));
        for (const char* core : {"m4", "m0plus"}) CHECK(instructions_of(core, low) > instructions_of(core, usual));
    }
}

TEST_CASE("the display limits rates by its pixels")
{
    for (const PartRate& rate : surface_rates(opened(), SurfaceMode::one_sample, {466, 466, 16}))
        CHECK(rate.mean <= display_frames_per_second(466 * 466) + 1e-9);
    CHECK(display_frames_per_second(466 * 466) == Approx(18.0).epsilon(0.01));
}

TEST_CASE("rates of parts are means and worst cases, at most what the display takes")
{
    for (const PartRate& rate : surface_rates(opened(), SurfaceMode::antialiased)) {
        CHECK(rate.worst > 0);
        CHECK(rate.worst <= rate.mean + 1e-9);
        CHECK(rate.mean < 67.9);
    }
}

TEST_CASE("see-through triangles cost more than the same ones opaque, and slow every part down")
{
    SurfaceField opaque = opened();
    opaque.neighbours = nullptr;  // they name patches that become glass
    SurfaceField half = opaque;
    half.patch_count = opaque.patch_count / 2;
    std::vector<uint8_t> section(detail::format::kSeeThroughBytes, 100);
    section[detail::format::see_through::kOrderAt] = 0;  // by depth
    SurfaceField glass = half;
    glass.see_through = section.data();
    glass.see_through_count = static_cast<uint16_t>(opaque.patch_count - half.patch_count);
    const tools::Eye eye = eye_at(45, 35, 3);
    for (const SurfaceMode mode : kModes) {
        const FrameWork whole = work_of(opaque, eye, mode, 16).frame, with_glass = work_of(glass, eye, mode, 16).frame;
        const auto of_glass = static_cast<double>(with_glass[Work::see_sample] + with_glass[Work::see_two_taps_sample] +
                                                  with_glass[Work::see_bilinear_sample]);
        CHECK(of_glass > 0);
        CHECK(samples_of(with_glass) + of_glass == Approx(samples_of(whole)));
        CHECK(with_glass[Work::listed] + with_glass[Work::ordered] == whole[Work::listed]);
        for (const char* core : {"m4", "m0plus"})
            CHECK(instructions_of(core, with_glass) > instructions_of(core, whole));
    }
    const std::vector<PartRate> slow = surface_rates(glass, SurfaceMode::antialiased),
                                fast = surface_rates(half, SurfaceMode::antialiased);
    for (size_t k = 0; k < slow.size(); ++k) CHECK(slow[k].mean < fast[k].mean);
}

}  // namespace lumi::planner
