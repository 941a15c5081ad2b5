// SPDX-License-Identifier: MIT
// Surface fields with see-through parts, such as windows and bottles: SeeThroughField takes the place of SurfaceField,
// SeeThroughFrame that of SurfaceFrame. Functions have the same names and rules. Fields without such parts show the
// same pixels as without this header.
//
// Opaque triangles are drawn first. Then those see-through triangles that face the eye are blended over them, in the
// order of the file if it says so, else from far to near by the depth of their nearest corner; ties keep the order of
// the file. So every rectangle of the image shows the same pixels. They write no depth. Two see-through surfaces that
// cut each other are wrong along the cut. Outlines of see-through parts are antialiased over a colour, but not over
// nothing and not over a stripe's own content.
//
//     SeeThroughField field;  open_surface(bytes, size, field);
//     SeeThroughFrame frame;  prepare_surface<PixelRgb565>(field, camera, SurfaceMode::one_sample, memory, frame);
//     render_surface<PixelRgb565>(frame, OverBlack(), stripe, samples);
#pragma once
#pragma GCC system_header

#include "lumi/surface/render.h"
#include "lumi/surface/see_through_frame.h"
