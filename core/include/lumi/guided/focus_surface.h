// SPDX-License-Identifier: MIT
// The surface of scenes without one (hair, glass, glow): the point of each ray nearest to a focus point F, or where the
// ray enters a sphere around it. A Surface policy of guided_render.h with one sample a pixel; every pixel has a point.
//
// With the camera's m, P and D = P/e - m·ê, |D|² = q = m² + |P|²/e², the point of the ray nearest to F is
//     X = (ê·|P|²/e + P·m + D·(D·F)) / q,
// and D/√q leads away from the eye. 32-bit products; within 2^-11 of the real numbers for eyes within 10 R, 2^-9 for
// the farthest.
#pragma once

#include "lumi/camera.h"
#include "lumi/guided/guided_field.h"
#include "lumi/guided/surface_point.h"
#include "lumi/render.h"

namespace lumi
{

class FocusSurface
{
public:
    static constexpr uint32_t kSamples = 1;

    FocusSurface(const GuidedField& field, const Camera& camera);

    void begin_stripe(const Stripe&) {}
    int32_t next(int32_t x, int32_t) const { return x; }
    RowSpan columns() const { return {0, camera_.width_px()}; }
    void begin_row(int32_t y);
    // Pixel x of the row, whose ray meets the unit sphere. About 90 instructions, 60 more with a focus sphere.
    uint32_t at(int32_t x, SurfacePoint (&out)[kSamples]) const;

private:
    struct Quantity {
        int32_t row_q28, step_q28;  // at column 0 of the row
    };

    const AffineQ40& source(int k) const { return k < 3 ? camera_.offset()[k] : camera_.facing(); }

    const Camera& camera_;
    int32_t focus_q14_[3];
    int32_t radius_q14_;
    int32_t eye_direction_q14_[3];
    int32_t inverse_distance_q15_;
    Quantity quantity_[4];  // P, m
};

}  // namespace lumi
