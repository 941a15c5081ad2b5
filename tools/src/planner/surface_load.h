// SPDX-License-Identifier: MIT
// What of a surface field a view shows: the quantities that drawing it costs instructions for.
#pragma once

#include "draw/views.h"
#include "lumi/surface/see_through_frame.h"

namespace lumi::planner
{

// Of triangles that face the eye.
struct TriangleLoad {
    double seen = 0;       // how many they are
    double set_ups = 0;    // the same, and parts of large ones, counted in each stripe that they reach
    double halvings = 0;   // what is looked at to make these parts, in each stripe
    double samples = 0;    // samples that they fill, hidden ones too; twice where two stripes draw them
    double magnified = 0;  // those of textures that are read bilinearly
};

// Triangles and patches are opaque ones, those of `see_through` left out.
struct SurfaceLoad : TriangleLoad {
    double vertices = 0, patches = 0;
    double lit = 0;         // vertices of triangles that face the eye, with a view table
    double view_bytes = 0;  // of a table
    double outline = 0;     // pixels along the edges between seen and unseen triangles
    double image = 0;       // pixels of the image
    TriangleLoad see_through;
    double see_through_patches = 0;
};

// In stripes of so many scanlines. Triangles in front of the eye are taken as planes seen in perspective; what the
// image cuts is not known.
SurfaceLoad load_of(const SeeThroughField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows);

}  // namespace lumi::planner
