// SPDX-License-Identifier: MIT
// Turns the structs of lumi.h into those of C++, and back.
#pragma once

#include "lumi/lumi.h"
#include "lumi/orbit.h"
#include "lumi/stripe.h"

namespace lumi::detail
{

inline Orbit in_cpp(const lumi_orbit& o)
{
    return {o.azimuth_turns32, o.elevation_turns32, o.distance_q20, o.fov_turns32, o.zoom_q16};
}

inline Stripe in_cpp(const lumi_stripe& s)
{
    return {s.pixels, s.x_px, s.y_px, s.width_px, s.height_px, s.stride_bytes};
}

template <class Vector>
Vector in_cpp(const lumi_vector& v)
{
    return {v.x, v.y, v.z};
}

inline Pose in_cpp(const lumi_pose& p)
{
    return {in_cpp<Vec3q20>(p.eye_q20), in_cpp<Vec3q30>(p.right_q30), in_cpp<Vec3q30>(p.up_q30),
            in_cpp<Vec3q30>(p.forward_q30)};
}

template <class Vector>
lumi_vector vector_in_c(const Vector& v)
{
    return {v.x, v.y, v.z};
}

inline lumi_pose in_c(const Pose& p)
{
    return {vector_in_c(p.eye), vector_in_c(p.right), vector_in_c(p.up), vector_in_c(p.forward)};
}

}  // namespace lumi::detail
