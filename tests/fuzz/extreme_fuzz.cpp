// SPDX-License-Identifier: MIT
// Fuzz target: a valid field whose numbers lie at the ends of what they may be, before a camera and in a stripe of
// that kind. The input's bytes choose them (choices.h), so no input is wasted on a file that does not open.
#include <cstdlib>

#include "chord/extreme_chords.h"
#include "draw_field.h"
#include "lumi/orbit.h"
#include "surface/extreme_surfaces.h"

namespace
{

using namespace lumi;
using fuzz::Scene;
using test::Choices;

constexpr uint32_t kSmallSide = 12, kLargeSide = 48;  // a stripe's sides; most are small: more are drawn a second

Pose pose_of(Choices& choose)
{
    const int32_t eighth = 1 << 29;
    const uint32_t azimuth = choose.once_in(2) ? choose.below(8) << 29 : choose.below(UINT32_MAX);
    const int32_t elevation =
        choose.once_in(2) ? eighth * choose.between(-2, 2) : choose.between(-2 * eighth, 2 * eighth);
    const int32_t distances[] = {kOneQ20, kOneQ20 + 1, kMaxEyeDistanceQ20, choose.between(kOneQ20, 3 * kOneQ20 / 2),
                                 choose.between(kOneQ20, kMaxEyeDistanceQ20)};
    const Pose at_centre = detail::orbit(azimuth, elevation, choose.one_of(distances));
    const auto reversed = [](const Vec3q30& v) { return Vec3q30{-v.x, -v.y, -v.z}; };
    switch (choose.below(4)) {
        case 0:  // along the sphere
            return {at_centre.eye, reversed(at_centre.forward), at_centre.up, at_centre.right};
        case 1:  // upside down
            return {at_centre.eye, reversed(at_centre.right), reversed(at_centre.up), at_centre.forward};
        default:
            return at_centre;
    }
}

Image image_of(Choices& choose)
{
    const auto side = [&] {
        const int32_t sides[] = {1, 2, 3, kMaxImageSide - 1, kMaxImageSide, choose.between(1, 48)};
        return choose.one_of(sides);
    };
    const uint32_t fovs[] = {kMinFovTurns32, kMaxFovTurns32, degrees(45),
                             kMinFovTurns32 + choose.below(kMaxFovTurns32 - kMinFovTurns32)};
    Image image = {side(), side(), choose.one_of(fovs)};
    const auto shift_q8 = [&](int32_t of) {
        const int32_t shifts[] = {0, -256 * of, 256 * of, choose.between(-256 * of, 256 * of)};
        return choose.one_of(shifts);
    };
    image.shift_x_q8 = shift_q8(image.width_px);
    image.shift_y_q8 = shift_q8(image.height_px);
    return image;
}

Scene scene_of(Choices& choose)
{
    Scene s{};
    s.pose = pose_of(choose);
    s.image = image_of(choose);
    const auto side = [&] {
        return 1 + static_cast<int32_t>(choose.below(choose.once_in(16) ? kLargeSide : kSmallSide));
    };
    s.width = side();
    s.height = side();
    // At an end of the image, in it, or across its border.
    const auto place = [&](int32_t of, int32_t size) {
        const int32_t places[] = {0, of - size, choose.between(0, of), -choose.between(0, size)};
        return choose.one_of(places);
    };
    s.x = place(s.image.width_px, s.width);
    s.y = place(s.image.height_px, s.height);
    s.choice = choose.below(UINT32_MAX);
    return s;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Choices choose(data, size);
    const Scene scene = scene_of(choose);
    const bool is_chord = choose.once_in(4);
    const bool is_opaque = choose.once_in(2);
    test::ExtremeSurfaces surfaces(choose, test::kSmallSurface);
    const test::Bytes file = is_chord            ? test::ExtremeChords(choose, test::kSmallChord).next()
                             : is_opaque         ? surfaces.next()
                             : choose.once_in(2) ? surfaces.next_see_through()
                                                 : surfaces.next_with_gloss();
    if (verify_field(file.data(), file.size()) != FieldError::none) std::abort();
    const uint64_t before = fuzz::drawn.chords + fuzz::drawn.surfaces;
    fuzz::draw_field(file.data(), file.size(), scene);
    if (fuzz::drawn.chords + fuzz::drawn.surfaces != before + 1) std::abort();  // every field opens, and every camera
    return 0;
}
