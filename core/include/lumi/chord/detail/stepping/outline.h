// SPDX-License-Identifier: MIT
// The sphere's outline in the image, followed from scanline to scanline.
//
// A pixel is covered where f = (1 - τ)·m² - b·|P|² >= 0, with τ the tangent rule's 2^-kTangentShift and
// b = 1 - 1/e² + τ/e²: the rule of ray_at as one quadratic polynomial of the pixel. Its borders differ from ray_at's by
// rounding alone (|s²/q - τ| < 1e-5).
#pragma once

#include "lumi/chord/camera.h"
#include "lumi/stripe.h"

namespace lumi::detail
{

// The outline in the image of a camera whose other members are set.
OutlineQuadratic make_outline(const Camera& camera);

// Yields the covered span of successive scanlines of a stripe. The first one is searched for, the following ones are
// found by walking from the last span's ends: a few additions a scanline.
class OutlineTracker
{
public:
    OutlineTracker(const Camera& camera, const Extent& limits);

    // The span of scanline y; call with scanlines in increasing order.
    Extent scanline(int32_t y);

    // Whether an end of a scanline's span is the sphere's and not the limits'.
    bool is_outline(int32_t x) const { return x != limits_.begin && x != limits_.end; }

    // The columns, at multiples of 2^step_log2 within the limits, that scanlines `top` and `bottom` of the image both
    // cover: the first and the last, but the ones next to them where the rim is nearer than the limits. The sphere
    // covers all between them. None: begin >= end. `between` is the span of a scanline between them.
    Extent columns(int32_t top, int32_t bottom, const Extent& between, int step_log2) const;

private:
    // f and m at a pixel, and how f changes to the pixels right of it and below.
    struct Walk {
        int64_t f, right, down, m;

        bool covered() const { return f >= 0 && m > 0; }
    };

    class Stride;

    Walk at(int32_t x, int32_t y) const;
    int32_t find_column(int32_t top, int32_t bottom, int32_t from, int32_t step, int32_t count) const;
    void move_right(Walk& walk) const;
    void move_left(Walk& walk) const;
    void move_down(Walk& walk) const;
    // Whether f has one highest place along a scanline, and none is covered where that one is not.
    bool is_concave() const { return camera_.outline().x2 < 0; }
    int32_t top_between(int32_t from, int32_t to, int32_t y) const;
    bool search(int32_t y);
    bool adjust();

    const Camera& camera_;
    Extent limits_;
    Extent span_;
    Walk first_, last_;  // at the first and the last pixel of the span
    int32_t last_y_;
};

}  // namespace lumi::detail
