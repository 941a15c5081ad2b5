// SPDX-License-Identifier: MIT
#include "lumi/chord/camera.h"

#include <catch2/catch.hpp>

#include "report.h"
#include "twin.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;
using twin::decoded;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kPoses = 600;
#else
constexpr uint32_t kPoses = 20000;
#endif

constexpr double kQ40 = 1099511627776.0;

double value(const AffineQ40& a, int32_t x, int32_t y)
{
    return static_cast<double>(a.at(x, y)) / kQ40;
}

// The viewing vector of a pixel straight from pose and image, of any length.
Vec3 viewing_vector(const Pose& pose, const Image& image, double x, double y)
{
    const double longer = std::max(image.width_px, image.height_px);
    const double pixel = 2 * std::tan(image.fov_turns32 / 4294967296.0 * twin::kPi) / longer;
    const double right = (x + 0.5 - image.width_px / 2.0 - image.shift_x_q8 / 256.0) * pixel;
    const double down = (y + 0.5 - image.height_px / 2.0 - image.shift_y_q8 / 256.0) * pixel;
    return decoded(pose.forward) + right * decoded(pose.right) + (-down) * decoded(pose.up);
}

// D as the camera describes it: P/e - m·ê.
Vec3 camera_vector(const Camera& camera, int32_t x, int32_t y)
{
    const Vec3 p = {value(camera.offset()[0], x, y), value(camera.offset()[1], x, y), value(camera.offset()[2], x, y)};
    return twin::from_q30(camera.inverse_distance_q30()) * p +
           (-value(camera.facing(), x, y)) * decoded(camera.eye_direction());
}

CameraError error_of(const Pose& pose, const Image& image)
{
    Camera camera;
    return make_camera(pose, image, camera);
}

const Image kImage = {64, 48, degrees(40)};

}  // namespace

TEST_CASE("a camera's rays are those of its pose and image", "[camera]")
{
    Worst angle;
    Worst length;
    uint64_t where = 0;
    for (const View& view : extreme_views(64)) {
        Camera camera;
        INFO(view.name);
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        CHECK(twin::from_q30(camera.inverse_distance_q30()) ==
              Approx(1 / twin::length(decoded(view.pose.eye))).epsilon(1e-5));
        const double pixel = 2 * std::tan(view.image.fov_turns32 / 4294967296.0 * twin::kPi) /
                             std::max(view.image.width_px, view.image.height_px);
        for (int32_t y = 0; y < view.image.height_px; y += 7) {
            for (int32_t x = 0; x < view.image.width_px; x += 5) {
                const Vec3 d = camera_vector(camera, x, y);
                const Vec3 truth = twin::normalised(viewing_vector(view.pose, view.image, x, y));
                length.see(twin::length(d), where);
                angle.see(twin::length(twin::normalised(d) - truth) / pixel, where++);
            }
        }
    }
    angle.report("camera, error of a ray in pixels");
    length.report("camera, length of a viewing vector");
    CHECK(angle.error < 0.01);
    CHECK(length.error <= 1.0);
}

TEST_CASE("orbit looks at the centre from where its angles say", "[camera]")
{
    const Pose front = orbit(0, 0, 3 * kOneQ20);
    CHECK(front.eye.x == 3 * kOneQ20);
    CHECK(front.forward.x == -kOneQ30);
    CHECK(front.right.y == kOneQ30);
    CHECK(front.up.z == kOneQ30);
    const Pose above = orbit(0, 0x40000000, 2 * kOneQ20);
    CHECK(above.eye.z == 2 * kOneQ20);
    CHECK(above.forward.z == -kOneQ30);
    CHECK(error_of(above, kImage) == CameraError::none);
    const Pose quarter = orbit(0x40000000, 0, 2 * kOneQ20);
    CHECK(quarter.eye.y == 2 * kOneQ20);
    Worst worst;
    for (uint32_t k = 0; k < 4096; ++k) {
        const Pose p = orbit(k * 0x9E3779B9u, static_cast<int32_t>(k * 0x3C6EF372u) / 2, 5 * kOneQ20 / 2);
        const Vec3 eye = decoded(p.eye);
        worst.see(twin::length(twin::normalised(eye) + decoded(p.forward)), k);
        worst.see(std::fabs(twin::length(eye) - 2.5), k);
        REQUIRE(error_of(p, kImage) == CameraError::none);
    }
    worst.report("orbit, error of the eye");
    CHECK(worst.error < 4e-6);
}

TEST_CASE("no rounding of a pose leaves the range of distances, from 1 to 2047 radii", "[camera]")
{
    uint32_t refused = 0;
    for (uint32_t k = 0; k < kPoses; ++k) {
        // Every direction, the axes among them; by core's own angles, by doubles and by floats.
        const uint32_t azimuth = k % 8 == 0 ? k << 27 : k * 0x9E3779B9u;
        const int32_t elevation = k % 16 == 0 ? static_cast<int32_t>((k >> 4) % 3) * 0x3FFFFFFF - 0x3FFFFFFF
                                              : static_cast<int32_t>(k * 0x3C6EF372u) / 2;
        for (const int32_t distance : {kOneQ20, kMaxEyeDistanceQ20}) {
            const Pose pose = orbit(azimuth, elevation, distance);
            const Vec3 direction = twin::normalised(decoded(pose.eye));
            const double radius = distance / double{kOneQ20};
            const auto single = [&](double c) { return static_cast<double>(static_cast<float>(c * radius)); };
            const Vec3 rounded = {single(direction.x), single(direction.y), single(direction.z)};
            refused += error_of(pose, kImage) != CameraError::none ? 1u : 0u;
            refused += error_of(look_at(radius * direction, {0, 0, 0}), kImage) != CameraError::none ? 1u : 0u;
            refused += error_of(look_at(rounded, {0, 0, 0}), kImage) != CameraError::none ? 1u : 0u;
        }
    }
    CHECK(refused == 0);
}

TEST_CASE("an eye further beyond either end of the distances than its tolerance is refused", "[camera]")
{
    constexpr int32_t kNear = kOneQ20 >> kEyeToleranceShift, kFar = kMaxEyeDistanceQ20 >> kEyeToleranceShift;
    const auto error_at = [](int32_t distance) { return error_of(orbit(0, 0, distance), kImage); };
    CHECK(error_at(kOneQ20 - kNear) == CameraError::none);
    CHECK(error_at(kOneQ20 - kNear - 1) == CameraError::eye_inside_sphere);
    CHECK(error_at(kMaxEyeDistanceQ20 + kFar) == CameraError::none);
    CHECK(error_at(kMaxEyeDistanceQ20 + kFar + 1) == CameraError::eye_too_far);
}

TEST_CASE("a stereo pair moves along the camera's right axis", "[camera]")
{
    const Pose middle = orbit(0x12345678, 0x05000000, 3 * kOneQ20);
    const Pose left = moved_right(middle, -kOneQ20 / 20);
    const Pose right = moved_right(middle, kOneQ20 / 20);
    const Vec3 between = decoded(right.eye) - decoded(left.eye);
    CHECK(twin::length(between) == Approx(0.1).epsilon(1e-4));
    CHECK(twin::dot(twin::normalised(between), decoded(middle.right)) == Approx(1).epsilon(1e-6));
    CHECK(left.forward.x == middle.forward.x);
}

TEST_CASE("a roll turns the picture clockwise: none changes no bit, quarter turns are exact, all are right", "[camera]")
{
    const auto same = [](const Vec3q30& a, const Vec3q30& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    const auto back = [](const Vec3q30& v) { return Vec3q30{-v.x, -v.y, -v.z}; };
    Worst worst;
    for (uint32_t k = 0; k < 4096; ++k) {
        const int32_t elevation =
            k < 3 ? static_cast<int32_t>(k - 1) * 0x40000000 : static_cast<int32_t>(k * 0x3C6EF372u) / 2;
        const Pose p = orbit(k * 0x9E3779B9u, elevation, k % 2 == 0 ? kOneQ20 : kMaxEyeDistanceQ20);
        const Pose none = rolled(p, 0), quarter = rolled(p, degrees(90)), half = rolled(p, degrees(180));
        REQUIRE((same(none.right, p.right) && same(none.up, p.up)));
        REQUIRE((same(quarter.right, p.up) && same(quarter.up, back(p.right))));
        REQUIRE((same(half.right, back(p.right)) && same(half.up, back(p.up))));
        const uint32_t turns = k * 0x85EBCA6Bu;
        const Pose turned = rolled(p, turns);
        const double angle = turns * (2 * 3.14159265358979323846 / 4294967296.0);
        const Vec3 right = std::cos(angle) * decoded(p.right) + std::sin(angle) * decoded(p.up);
        const Vec3 up = std::cos(angle) * decoded(p.up) - std::sin(angle) * decoded(p.right);
        worst.see(twin::length(decoded(turned.right) - right), k);
        worst.see(twin::length(decoded(turned.up) - up), k);
        REQUIRE((same(turned.forward, p.forward) && turned.eye.x == p.eye.x && turned.eye.z == p.eye.z));
        REQUIRE(error_of(turned, kImage) == CameraError::none);
    }
    worst.report("rolled, error of an axis");
    CHECK(worst.error < 8e-9);  // sine and cosine are right to 2^-28, each of two products to that
}

TEST_CASE("poses and images out of range are refused by name and leave the camera untouched", "[camera]")
{
    const Pose good = orbit(0, 0, 3 * kOneQ20);
    CHECK(error_of(good, kImage) == CameraError::none);
    CHECK(error_of(orbit(5, 6, kOneQ20 * 99 / 100), kImage) == CameraError::eye_inside_sphere);
    CHECK(error_of(look_at({0, 0, 0.001}, {0, 0, 0}), kImage) == CameraError::eye_inside_sphere);
    CHECK(error_of(orbit(0, 0, INT32_MAX), kImage) == CameraError::eye_too_far);
    Pose corner = good;
    corner.eye = {INT32_MIN, INT32_MIN, INT32_MIN};
    CHECK(error_of(corner, kImage) == CameraError::eye_too_far);
    CHECK(error_of(good, {64, 64, degrees(0.9)}) == CameraError::field_of_view_range);
    CHECK(error_of(good, {64, 64, degrees(121)}) == CameraError::field_of_view_range);
    CHECK(error_of(good, {0, 64, degrees(40)}) == CameraError::image_size_range);
    CHECK(error_of(good, {64, 8193, degrees(40)}) == CameraError::image_size_range);
    CHECK(error_of(good, {64, 64, degrees(40), 65 * 256, 0}) == CameraError::image_size_range);
    Pose skewed = good;
    skewed.up = skewed.right;
    CHECK(error_of(skewed, kImage) == CameraError::axes_not_orthonormal);
    skewed = good;
    skewed.right.x = INT32_MIN;
    CHECK(error_of(skewed, kImage) == CameraError::axes_not_orthonormal);

    Camera camera;
    REQUIRE(make_camera(good, {77, 64, degrees(40)}, camera) == CameraError::none);
    CHECK(make_camera(skewed, kImage, camera) != CameraError::none);
    CHECK(camera.width_px() == 77);
}

TEST_CASE("every component of an axis is in range, every length 1 and every angle right, up to 2^-12", "[camera]")
{
    constexpr int32_t kWithin = (kOneQ30 >> 12) - 1024, kBeyond = (kOneQ30 >> 12) + 1024;
    const Pose good = orbit(0, 0, 3 * kOneQ20);
    Vec3q30 Pose::*const axes[] = {&Pose::right, &Pose::up, &Pose::forward};
    int32_t Vec3q30::*const components[] = {&Vec3q30::x, &Vec3q30::y, &Vec3q30::z};
    for (Vec3q30 Pose::*axis : axes) {
        const auto error_if = [&](auto change) {
            Pose pose = good;
            change(pose.*axis);
            return error_of(pose, kImage);
        };
        for (int32_t Vec3q30::*component : components)
            for (const int32_t far : {INT32_MIN, -kOneQ30 - kBeyond, kOneQ30 + kBeyond, INT32_MAX})
                CHECK(error_if([&](Vec3q30& v) { v.*component = far; }) == CameraError::axes_not_orthonormal);
        // Its square is so much from 1.
        for (const int32_t sign : {-1, 1}) {
            const auto longer = [&](int32_t by) {
                return error_if([&](Vec3q30& v) {
                    for (int32_t Vec3q30::*component : components)
                        v.*component += v.*component == 0 ? 0 : v.*component > 0 ? sign * by / 2 : -sign * by / 2;
                });
            };
            CHECK(longer(kWithin) == CameraError::none);
            CHECK(longer(kBeyond) == CameraError::axes_not_orthonormal);
        }
        for (Vec3q30 Pose::*other : axes) {
            if (other == axis) continue;
            const auto leaning = [&](int32_t by) {
                return error_if([&](Vec3q30& v) {
                    for (int32_t Vec3q30::*component : components)
                        v.*component += mul_q30((good.*other).*component, by);
                });
            };
            for (const int32_t sign : {-1, 1}) {
                CHECK(leaning(sign * kWithin) == CameraError::none);
                CHECK(leaning(sign * kBeyond) == CameraError::axes_not_orthonormal);
            }
        }
    }
}

TEST_CASE("an image's sides and shifts are taken up to their limits and not beyond", "[camera]")
{
    const Pose good = orbit(0, 0, 3 * kOneQ20);
    const auto error = [&](const Image& image) { return error_of(good, image); };
    for (const int32_t side : std::initializer_list<int32_t>{1, 2, kMaxImageSide}) {
        CHECK(error({side, 48, degrees(40)}) == CameraError::none);
        CHECK(error({64, side, degrees(40)}) == CameraError::none);
    }
    for (const int32_t side : std::initializer_list<int32_t>{INT32_MIN, -1, 0, kMaxImageSide + 1, INT32_MAX}) {
        CHECK(error({side, 48, degrees(40)}) == CameraError::image_size_range);
        CHECK(error({64, side, degrees(40)}) == CameraError::image_size_range);
    }
    for (const int32_t sign : {-1, 1}) {
        CHECK(error({64, 48, degrees(40), sign * 64 * 256, sign * 48 * 256}) == CameraError::none);
        CHECK(error({64, 48, degrees(40), sign * (64 * 256 + 1), 0}) == CameraError::image_size_range);
        CHECK(error({64, 48, degrees(40), 0, sign * (48 * 256 + 1)}) == CameraError::image_size_range);
    }
    CHECK(error({64, 48, kMinFovTurns32}) == CameraError::none);
    CHECK(error({64, 48, kMaxFovTurns32}) == CameraError::none);
    CHECK(error({64, 48, kMinFovTurns32 - 1}) == CameraError::field_of_view_range);
    CHECK(error({64, 48, kMaxFovTurns32 + 1}) == CameraError::field_of_view_range);
}
