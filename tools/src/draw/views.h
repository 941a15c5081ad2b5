// SPDX-License-Identifier: MIT
// From camera options to pictures on disk: one view, a stereo pair, or a turntable of either.
#pragma once

#include <functional>
#include <string>

#include "image/picture.h"
#include "lumi/host/camera.h"

namespace lumi::tools
{

inline constexpr int kMaxTurntable = 1000;

// What `lumi render` and `lumi reference` share, so that their views coincide.
struct ViewOptions {
    int width_px = 240, height_px = 240;
    host::Orbit orbit = {30, 20, 3};
    double fov_deg = 0;       // over the longer side; 0 = the sphere fills the frame
    double eye_distance = 0;  // in radii; above 0 = a stereo pair, left eye left
    int turntable = 0;        // views around the vertical axis; 0 = one view
    Rgb8 background = {0, 0, 0};
};

// One camera: as people set it, and as core's chord renderer wants it.
struct Eye {
    Pose pose;
    Image image;
    Camera camera;
};

// Draws what one camera sees, width_px × height_px pixels.
using Drawer = std::function<Picture(const Eye&)>;

// Draws and writes all views; returns the written paths in order. One view goes to `output`; a turntable OUT.png writes
// OUT-000.png, OUT-001.png, … from orbit.azimuth_deg on, counted eastwards, then OUT-sheet.png with all of them. Throws
// UsageError for a camera that core refuses, before anything is drawn; Failure where writing fails.
std::vector<std::string> write_views(const ViewOptions& options, const std::string& output, const Drawer& draw);

}  // namespace lumi::tools
