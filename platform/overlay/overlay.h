// SPDX-License-Identifier: MIT
// Live lines over a baked object: points of the scene projected by the camera that draws it, and strokes in the stripe
// that was just drawn. They lie on a plane that is seen from its front alone; nothing of the object hides them.
#pragma once

#include <lumi/stripe.h>
#include <lumi/surface/frame.h>

namespace overlay
{

// A plane of the field's frame (the sphere's centre is the origin, its radius 1): points are centre + x·right + y·up.
struct Plane {
    lumi::Vec3q20 centre;
    lumi::Vec3q30 right, up, normal;
};

// On a plane, in radii of the sphere, Q20.
struct Place {
    int32_t x_q20, y_q20;
};

struct Pixel {
    int32_t x_q8, y_q8;
};

class Sheet
{
public:
    Sheet(const Plane& plane, const lumi::SurfaceCamera& camera);

    // Seen from its front, and all of it before the eye.
    bool is_seen() const { return is_seen_; }
    // Precondition: is_seen(), and a place within a radius of the sphere's centre.
    Pixel pixel_of(const Place& place) const;

private:
    Plane plane_;
    lumi::SurfaceCamera camera_;
    bool is_seen_;
};

// A stroke of about `width_px` pixels, 1 to 8, in PixelRgb565Swapped.
void draw_stroke(const lumi::Stripe& stripe, const Pixel& a, const Pixel& b, int32_t width_px, uint16_t rgb565);

// Digits, ':' and '-' of strokes, `height` high and half as wide, from their lower left corner on.
void draw_text(const lumi::Stripe& stripe, const Sheet& sheet, const char* text, const Place& at, int32_t height_q20,
               uint16_t rgb565);

}  // namespace overlay
