// SPDX-License-Identifier: MIT
// What of a surface field a view shows: the quantities that drawing it costs instructions for.
#pragma once

#include "draw/views.h"
#include "lumi/surface/frame.h"

namespace lumi::planner
{

struct SurfaceLoad {
    double vertices = 0, patches = 0;
    double seen = 0;       // triangles that face the eye
    double lit = 0;        // vertices of these that have a view table
    double scanlines = 0;  // lines of samples that these triangles span, counted for each triangle
    double samples = 0;    // samples that they fill, hidden ones too
    double magnified = 0;  // samples of textures that are read bilinearly
    double outline = 0;    // pixels along the edges between seen and unseen triangles
    double image = 0;      // pixels of the image
};

// Triangles in front of the eye are taken as planes seen in perspective; what a stripe or the image cuts is not known.
SurfaceLoad load_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode);

}  // namespace lumi::planner
