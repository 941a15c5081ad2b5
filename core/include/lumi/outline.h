// SPDX-License-Identifier: MIT
// The sphere's outline in the image, followed from row to row.
//
// A pixel is covered where f = (1 - τ)·m² - b·|P|² >= 0, with τ the tangent rule's 2^-kTangentShift and
// b = 1 - 1/e² + τ/e²: the rule of ray_at as one quadratic polynomial of the pixel. Its borders differ from ray_at's by
// rounding alone (|s²/q - τ| < 1e-5).
#pragma once

#include "lumi/sphere.h"

namespace lumi
{

// f = constant + x·(x1 + x·x2 + y·xy) + y·(y1 + y·y2), scaled to the image so that 64 bits hold it at every pixel.
struct OutlineQuadratic {
    int64_t constant, x1, y1, x2, xy, y2;

    int64_t at(int32_t x, int32_t y) const { return constant + x * (x1 + x * x2 + y * xy) + y * (y1 + y * y2); }
};

OutlineQuadratic make_outline(const Camera& camera);

// Yields the covered span of successive rows of a stripe. The first row is searched for, the following ones are found
// by walking from the last span's ends: a few additions a row.
class OutlineTracker
{
public:
    OutlineTracker(const Camera& camera, const RowSpan& limits);

    // The span of row y; call with rows in increasing order.
    RowSpan row(int32_t y);

private:
    // f and m along a row, advanced by additions.
    struct Walk {
        int64_t f, df, ddf;  // f(x), f(x+1) - f(x), and twice x2
        int64_t m, dm;

        bool covered() const { return f >= 0 && m > 0; }
        void right();
        void left();
    };

    Walk walk_at(int32_t x, int32_t y) const;
    bool follow(int32_t y);

    const Camera& camera_;
    OutlineQuadratic outline_;
    RowSpan limits_;
    RowSpan span_;
    int32_t last_y_;
};

}  // namespace lumi
