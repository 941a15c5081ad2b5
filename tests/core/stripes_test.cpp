// SPDX-License-Identifier: MIT
// A stripe may be any rectangle, also beside the image: its pixels are written, nothing else.
#include <catch2/catch.hpp>
#include <climits>
#include <vector>

#include "chord/drawing.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 40;
constexpr uint8_t kGuard = 0xA5;
constexpr uint8_t kBackground = 3;
constexpr uint8_t kTexel = 200;
#ifdef LUMI_TEST_LIGHT
constexpr size_t kGuardBytes = 512;
#else
constexpr size_t kGuardBytes = 4096;
#endif

struct Place {
    int32_t x, y, width, height;
};

// Around the image, over its borders and as far away as numbers go.
std::vector<Place> places()
{
    std::vector<Place> all;
    const int32_t offsets[] = {INT_MIN, -40000, -32769, -41,        -17,   -1,    0,           13,
                               39,      40,     41,     16384 + 40, 32767, 40000, INT_MAX - 8, INT_MAX};
    for (const int32_t x : offsets)
        for (const int32_t y : offsets) all.push_back({x, y, 9, 5});
    for (const int32_t x : {-60, -20, 0, 20}) all.push_back({x, x, 100, 100});
    all.push_back({0, 0, 0, 0});
    all.push_back({5, 5, 1, 1});
    return all;
}

bool is_guard(const std::vector<uint8_t>& bytes, size_t begin, size_t end)
{
    for (size_t k = begin; k < end; ++k)
        if (bytes[k] != kGuard) return false;
    return true;
}

// Draws a stripe between guards and checks every byte of both, and of the stripe's pixels beside the image.
template <class Draw>
void check_stripe(const Place& place, Draw draw)
{
    const uint32_t stride = static_cast<uint32_t>(place.width) + 3;
    const size_t size = stride * static_cast<size_t>(place.height);
    std::vector<uint8_t> bytes(kGuardBytes + size + kGuardBytes, kGuard);
    uint8_t* const pixels = bytes.data() + kGuardBytes;
    REQUIRE(draw(Stripe{pixels, place.x, place.y, place.width, place.height, stride}) == RenderError::none);
    INFO("stripe at " << place.x << ", " << place.y << ", " << place.width << " x " << place.height);
    REQUIRE(is_guard(bytes, 0, kGuardBytes));
    REQUIRE(is_guard(bytes, kGuardBytes + size, bytes.size()));
    size_t wrong = 0;
    for (int32_t row = 0; row < place.height; ++row) {
        const uint8_t* const at = pixels + static_cast<uint32_t>(row) * stride;
        for (uint32_t k = static_cast<uint32_t>(place.width); k < stride; ++k) wrong += at[k] == kGuard ? 0 : 1;
        for (int32_t k = 0; k < place.width; ++k) {
            const int64_t x = static_cast<int64_t>(place.x) + k;
            const int64_t y = static_cast<int64_t>(place.y) + row;
            if (y > INT_MAX - 1 || x > INT_MAX - 1) continue;  // beyond the last row or column that there is
            const bool is_inside = x >= 0 && x < kSide && y >= 0 && y < kSide;
            wrong += at[k] == kBackground || (is_inside && at[k] != kGuard) ? 0 : 1;
        }
    }
    REQUIRE(wrong == 0);
}

template <class Reconstruction>
void check_everywhere(const Field& field, const Camera& camera)
{
    const OverColour background{{kBackground, kBackground, kBackground}};
    for (const Place& place : places()) {
        for (const int32_t span_px : {0, 2, 8, 16})
            check_stripe(
                place,
                [&](const Stripe& stripe) {
                    return draw_chord<Reconstruction, TexelLuma8, PixelGrey8>(field, camera, background, stripe,
                                                                              span_px);
                });
    }
}

}  // namespace

TEST_CASE("no renderer writes beside its stripe, wherever the stripe lies", "[render][span]")
{
    const OpenField open(layout_of(100, 120, TexelFormat::luma8), [](uint32_t, uint32_t) { return kTexel; });
    for (const double distance : {1.0, 1.2, 3.0}) {
        const Camera camera = camera_of(look_at({distance, 0.2, 0.1}, {0, 0, 0}, 15), {kSide, kSide, degrees(40)});
        check_everywhere<Nearest>(open.field, camera);
        check_everywhere<Linear>(open.field, camera);
    }
}

TEST_CASE("a pose moved further than numbers go is refused, not wrapped", "[camera]")
{
    const Pose pose = look_at({2, 0, 0}, {0, 0, 0}, 0);
    for (const int32_t offset : {INT_MAX, INT_MIN}) {
        Camera camera;
        CHECK(make_camera(moved_right(pose, offset), {8, 8, degrees(40)}, camera) == CameraError::eye_too_far);
    }
    Pose far = pose;
    far.eye = {INT_MAX, INT_MAX, INT_MAX};
    Camera camera;
    CHECK(make_camera(moved_right(far, INT_MAX), {8, 8, degrees(40)}, camera) == CameraError::eye_too_far);
}
