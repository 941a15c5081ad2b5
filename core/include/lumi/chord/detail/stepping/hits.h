// SPDX-License-Identifier: MIT
// Where a pixel's ray meets the sphere, in 32-bit arithmetic: the exact ends of what is stepped in between.
//
// All products are 32×32→32, so that a Cortex-M0+ needs no library call. Viewing vectors are Q15; where the half chord
// is above 1/8, hits are within 2^-10 of the exact ones for every camera (the worst is an eye at 2047 R), 1/18 of a
// cell of a lattice of 2^16 points, the largest that spans are drawn from. Towards the rim the error grows as the chord
// gets short.
#pragma once

#include "lumi/chord/camera.h"

namespace lumi::detail
{

// Where a ray meets the sphere, as the lattice sees it. x and y still carry the factor q = |D|², which does not change
// an angle.
struct Hit {
    uint32_t longitude_turns32;
    int32_t x_q15, y_q15;  // times q
    int32_t z_q30;
};

// Where it enters and where it leaves.
struct HitPair {
    Hit front, back;
    int32_t inverse_mantissa;  // 1/q = mantissa·2^-shift
    int shift;
};

// A scanline's rays, from one of its pixels on: P and m there, Q28 modulo 16: in range where a pixel is covered.
struct ScanlineRays {
    int32_t value_q28[4];
};

// Evaluates the hits of scanlines. Along one, rays advance by additions. Where a pixel is covered, P, m, s, ê and 1/e
// are at most 1.25 in Q15; q, s² and |P|² at most 1.6 in Q30, and so are |P|²/e, s·m, s/e and each component of q·h.
class HitEvaluator
{
public:
    explicit HitEvaluator(const Camera& camera);

    // Returns the rays of scanline y from pixel x of the image on.
    ScanlineRays rays_from(int32_t x, int32_t y) const;

    // Returns the rays from so many pixels to the right and below on: within 2^-19 of rays_from's, and cheaper.
    ScanlineRays moved(const ScanlineRays& rays, int32_t right_px, int32_t down_px) const;

    // Sets `out` to the hits `ahead` pixels on; that pixel is covered.
    void evaluate(const ScanlineRays& rays, int32_t ahead, HitPair& out) const;

private:
    // Returns the ray of a pixel, without what cancels.
    struct Ray {
        int32_t px_q15, py_q15, pz_q15, m_q15;
        int32_t offset2_q30;
        uint32_t half_chord2_q30;
    };

    Ray ray(const ScanlineRays& rays, int32_t ahead) const;
    const AffineQ40& source(int k) const { return k < 3 ? camera_.offset()[k] : camera_.facing(); }

    const Camera& camera_;
    Vec3q30 eye_direction_q15_;  // components Q15
    int32_t inverse_distance_q15_;
    int32_t perpendicular_q15_;
    int32_t step_q28_[4];
};

}  // namespace lumi::detail
