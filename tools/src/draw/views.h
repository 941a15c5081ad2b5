// SPDX-License-Identifier: MIT
// Makes pictures on disk from camera options: one view, or a turntable.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "draw/draw.h"
#include "draw/pose_file.h"
#include "image/picture.h"
#include "lumi/host/camera.h"

namespace lumi::tools
{

inline constexpr int kMaxTurntable = 1000;

// An object lies before a colour, before the dark grey gradient of lumi/host/backdrop.h, or before nothing: alpha.
struct Background {
    enum class Kind : uint8_t { colour, gradient, none };
    Kind kind = Kind::colour;
    Rgb8 colour = {0, 0, 0};
};

// `lumi render` and `lumi reference` share these options, so that their views coincide.
struct ViewOptions {
    int width_px = 240, height_px = 240;
    host::Orbit orbit = {30, 20, 3};
    double fov_deg = 0;  // over the longer side; 0 = the sphere fills the frame
    int turntable = 0;   // views around the vertical axis; 0 = one view
    Background background;
    std::string pose;               // a file with a 4×4 matrix, in place of the orbit; may be empty
    std::optional<Matrix4> matrix;  // given in place of the file, which then only names it in messages
    std::string photo;              // a PNG to draw over, which decides the size; may be empty
};

// One camera: as people set it, and as core's chord renderer wants it.
struct Eye {
    Pose pose;
    Image image;
    Camera camera;
    double done = 0;  // how much of a turntable comes before this view, below 1
};

// Draws what one camera sees over that colour, width_px × height_px pixels.
using Drawer = std::function<Picture(const Eye&, const Rgb8& background)>;

// Draws and writes all views; returns the written files in order, without devices and pipes. One view goes to `output`;
// a turntable OUT.png writes OUT-000.png, OUT-001.png, … from orbit.azimuth_deg on, counted eastwards, then
// OUT-sheet.png with all of them. A turntable OUT.webp writes the same views as one picture that turns
// once in four seconds. Over the gradient, `display` shows it. All files take their places together, after the last
// view. Throws UsageError for a camera that core refuses, before anything is drawn; Failure where a file cannot be read
// or written.
std::vector<std::string> write_views(ViewOptions options, const std::string& output, const Drawer& draw,
                                     DisplayFormat display = DisplayFormat::rgb888);

// Does the same with no background and no contact sheet: bytes_of(eye) draws a view and makes its file.
std::vector<std::string> write_each_view(const ViewOptions& options, const std::string& output,
                                         const std::function<std::string(const Eye&)>& bytes_of);

// Draws over a photograph, as a see-through display does: the same view drawn over black and over white tells each
// channel's coverage; the photograph shows through the rest. It is right to one level of 255. Precondition: all have
// one size.
Picture over_photo(const Picture& over_black, const Picture& over_white, const Picture& photo);

// Likewise finds alpha: laid over black it gives `over_black`, over other colours what is drawn over these, right to a
// level. Glass that tints what is behind it has one alpha for three channels, and keeps its highlights.
Picture over_nothing(const Picture& over_black, const Picture& over_white);

}  // namespace lumi::tools
