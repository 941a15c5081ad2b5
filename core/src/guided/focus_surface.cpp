// SPDX-License-Identifier: MIT
#include "lumi/guided/focus_surface.h"

#include "lumi/detail/stepping/hits.h"

namespace lumi
{
namespace
{

// Modulo 2^32, here and in steps: in range again where the pixel's ray meets the sphere.
int32_t wrapped_q28(int64_t v_q40)
{
    return static_cast<int32_t>(static_cast<uint32_t>(v_q40 >> 12));
}

int32_t stepped(int32_t value, int32_t step, int32_t count)
{
    return static_cast<int32_t>(static_cast<uint32_t>(value) +
                                static_cast<uint32_t>(step) * static_cast<uint32_t>(count));
}

}  // namespace

FocusSurface::FocusSurface(const GuidedField& field, const Camera& camera)
    : camera_(camera),
      focus_q14_{field.focus_q14[0], field.focus_q14[1], field.focus_q14[2]},
      radius_q14_(field.focus_radius_q14),
      eye_direction_q14_{camera.eye_direction().x >> 16, camera.eye_direction().y >> 16,
                         camera.eye_direction().z >> 16},
      inverse_distance_q15_(camera.inverse_distance_q30() >> 15),
      quantity_{}
{
    for (int k = 0; k < 4; ++k) quantity_[k].step_q28 = wrapped_q28(source(k).step_x);
}

void FocusSurface::begin_row(int32_t y)
{
    // From the row's middle the rounding of steps adds up least.
    for (int k = 0; k < 4; ++k) quantity_[k].row_q28 = wrapped_q28(source(k).at(camera_.width_px() / 2, y));
}

uint32_t FocusSurface::at(int32_t x, SurfacePoint (&out)[kSamples]) const
{
    const int32_t ahead = x - camera_.width_px() / 2;
    const auto q15 = [&](int k) { return stepped(quantity_[k].row_q28, quantity_[k].step_q28, ahead) >> 13; };
    const int32_t offset_q15[3] = {q15(0), q15(1), q15(2)};
    const int32_t facing_q15 = q15(3);

    const int32_t offset2_q30 =
        offset_q15[0] * offset_q15[0] + offset_q15[1] * offset_q15[1] + offset_q15[2] * offset_q15[2];
    const int32_t lift_q15 = (inverse_distance_q15_ * (offset2_q30 >> 15)) >> 15;  // |P|²/e
    const uint32_t length2_q30 = static_cast<uint32_t>(facing_q15 * facing_q15 + inverse_distance_q15_ * lift_q15);
    const CoarseReciprocal inverse = coarse_reciprocal(length2_q30 >> 14);

    int32_t direction_q15[3];  // D
    int32_t towards_q29 = 0;   // D·F
    for (int k = 0; k < 3; ++k) {
        direction_q15[k] =
            ((inverse_distance_q15_ * offset_q15[k]) >> 15) - ((facing_q15 * eye_direction_q14_[k]) >> 14);
        towards_q29 += direction_q15[k] * focus_q14_[k];
    }
    const int32_t towards_q14 = towards_q29 >> 15;
    int32_t place_q14[3];
    for (int k = 0; k < 3; ++k) {
        const int32_t over_q29 =
            eye_direction_q14_[k] * lift_q15 + offset_q15[k] * (facing_q15 >> 1) + direction_q15[k] * towards_q14;
        place_q14[k] = ((over_q29 >> 14) * inverse.mantissa) >> (inverse.exponent - 15);
    }
    if (radius_q14_ != 0) {
        int32_t rest_q28 = radius_q14_ * radius_q14_;
        for (int k = 0; k < 3; ++k) {
            const int32_t d_q14 = place_q14[k] - focus_q14_[k];
            rest_q28 -= d_q14 * d_q14;
        }
        if (rest_q28 > 0) {
            const int32_t half_chord_q15 = coarse_root_q15(static_cast<uint32_t>(rest_q28) << 2);
            // 1/√q = √q/q, up to 5.1.
            const int32_t inverse_length_q13 =
                (coarse_root_q15(length2_q30) * inverse.mantissa) >> (inverse.exponent - 14);
            const int32_t back_q14 = (half_chord_q15 * inverse_length_q13) >> 14;
            for (int k = 0; k < 3; ++k) place_q14[k] -= (direction_q15[k] * back_q14) >> 15;
        }
    }
    out[0] = {place_q14[0], place_q14[1], place_q14[2], 1};
    return 1;
}

}  // namespace lumi
