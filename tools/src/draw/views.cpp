// SPDX-License-Identifier: MIT
#include "draw/views.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "files/output_file.h"
#include "image/png.h"
#include "image/sheet.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

struct View {
    std::string path;
    std::vector<Eye> eyes;  // one, or left and right
};

// "OUT.png" becomes "OUT-TAG.png".
std::string tagged(const std::string& output, const std::string& tag)
{
    std::filesystem::path path(output);
    path.replace_filename(path.stem().string() + "-" + tag + path.extension().string());
    return path.string();
}

std::string numbered(const std::string& output, int number)
{
    char text[16];
    std::snprintf(text, sizeof text, "%03d", number);
    return tagged(output, text);
}

Eye eye_at(const Pose& pose, const Image& image)
{
    Eye eye = {pose, image, {}};
    if (const CameraError error = make_camera(pose, image, eye.camera); error != CameraError::none)
        throw UsageError(std::string("the camera cannot be used: ") + describe(error) +
                         "; change --orbit, --fov, --size or --stereo");
    return eye;
}

std::vector<Eye> eyes_of(const Pose& pose, const Image& image, double eye_distance)
{
    if (eye_distance <= 0) return {eye_at(pose, image)};
    const int32_t half_q20 = host::q20_from_radii(eye_distance / 2);
    return {eye_at(moved_right(pose, -half_q20), image), eye_at(moved_right(pose, half_q20), image)};
}

std::vector<View> all_views(const ViewOptions& options, const std::string& output)
{
    if (!(options.orbit.distance > 1)) throw UsageError("--orbit: the distance must be above 1, outside the sphere");
    const double fov_deg = options.fov_deg > 0
                               ? options.fov_deg
                               : host::framing_fov_deg(options.width_px, options.height_px, options.orbit.distance);
    const Image image = host::make_image(options.width_px, options.height_px, fov_deg);
    const int count = std::max(1, options.turntable);
    std::vector<View> views;
    for (int i = 0; i < count; ++i) {
        host::Orbit orbit = options.orbit;
        orbit.azimuth_deg += 360.0 * i / count;
        views.push_back({options.turntable > 0 ? numbered(output, i) : output,
                         eyes_of(host::make_pose(orbit), image, options.eye_distance)});
    }
    return views;
}

std::vector<std::string> paths_of(const std::vector<View>& views, const std::string& sheet)
{
    std::vector<std::string> paths = {sheet};
    for (const View& view : views) paths.push_back(view.path);
    return paths;
}

Picture drawn(const View& view, const Drawer& draw)
{
    Picture first = draw(view.eyes.front());
    return view.eyes.size() == 1 ? first : side_by_side(first, draw(view.eyes.back()));
}

}  // namespace

std::vector<std::string> write_views(const ViewOptions& options, const std::string& output, const Drawer& draw)
{
    const std::vector<View> views = all_views(options, output);
    const std::string sheet_path = tagged(output, "sheet");
    announce_outputs(paths_of(views, options.turntable > 0 ? sheet_path : ""));
    const int eyes = static_cast<int>(views.front().eyes.size());
    ContactSheet sheet(static_cast<int>(views.size()), eyes * options.width_px, options.height_px, options.background);
    std::vector<std::string> written;
    for (const View& view : views) {
        const Picture picture = drawn(view, draw);
        write_png(view.path, picture);
        written.push_back(view.path);
        sheet.add(picture);
    }
    if (options.turntable > 0) {
        write_png(sheet_path, sheet.picture());
        written.push_back(sheet_path);
    }
    return written;
}

}  // namespace lumi::tools
