// SPDX-License-Identifier: MIT
// The exact ends of a span: where a row's ray meets the sphere, in 32-bit arithmetic.
//
// All products are 32×32→32, so that a Cortex-M0+ needs no library call. Viewing vectors are Q15 (rounded to 2^-16),
// hits are within 2^-14 where the half chord is above 1/8, growing towards the rim as the chord gets short; longitudes
// are within 2^-17 turn plus the hit's error over its distance from the axis. That is 1/50 of a cell for a lattice of
// 2^16 points, the largest that spans are drawn from.
#pragma once

#include "lumi/camera.h"

namespace lumi
{

// Where a ray meets the sphere, as the lattice sees it.
struct SpanHit {
    uint32_t longitude_turns32;
    int32_t x_q15, y_q15, z_q30;
};

struct SpanNode {
    SpanHit front, back;
};

// Evaluates the nodes of one row. Rays advance by 32-bit additions from an exact first one.
class RowNodes
{
public:
    // `x` is the row's first covered pixel.
    RowNodes(const Camera& camera, int32_t x, int32_t y);

    // The node at pixel x0 + ahead; that pixel is covered.
    SpanNode at(int32_t ahead) const;

private:
    Vec3q30 eye_direction_q15_;  // components Q15
    int32_t inverse_distance_q15_;
    int32_t perpendicular_q15_;
    int32_t facing_q28_, facing_step_q28_;
    int32_t offset_q28_[3], offset_step_q28_[3];
};

// The parts of a node, for tests. Vectors of 16-bit components; error below 2^-17 turn.
uint32_t coarse_angle_turns32(int32_t y_q15, int32_t x_q15);
// sqrt of a Q30 value in [0, 2), Q15, within one unit.
int32_t coarse_root_q15(uint32_t v_q30);
// 1/v = mantissa·2^-exponent for v > 0, mantissa in (2^14, 2^15]; relative error below 2^-14.
struct CoarseReciprocal {
    int32_t mantissa;
    int exponent;
};
CoarseReciprocal coarse_reciprocal(uint32_t v);

}  // namespace lumi
