// SPDX-License-Identifier: MIT
#include "draw/views.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "draw/display.h"
#include "files/output_file.h"
#include "image/animation.h"
#include "image/picture.h"
#include "image/picture_file.h"
#include "lumi/host/backdrop.h"
#include "lumi/pack.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

constexpr Rgb8 kBlack = {0, 0, 0}, kWhite = {kOpaque, kOpaque, kOpaque};

struct View {
    std::string path;
    Eye eye;
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
                         "; change --orbit, --pose, --fov or --size");
    return eye;
}

Image image_of(const ViewOptions& options, double distance)
{
    const double fov_deg =
        options.fov_deg > 0 ? options.fov_deg : host::framing_fov_deg(options.width_px, options.height_px, distance);
    return host::make_image(options.width_px, options.height_px, fov_deg);
}

std::vector<View> posed_view(const ViewOptions& options, const std::string& output)
{
    const Matrix4 matrix = options.matrix ? *options.matrix : read_matrix(options.pose);
    const double distance = std::hypot(matrix[3], matrix[7], matrix[11]);
    const Pose pose = pose_of(matrix, options.pose);
    if (!(distance > 1))
        throw Failure(options.pose, "the eye lies in the sphere", "give its place in radii of the sphere, above 1");
    return {{output, eye_at(pose, image_of(options, distance))}};
}

std::vector<View> all_views(const ViewOptions& options, const std::string& output)
{
    if (!options.pose.empty()) return posed_view(options, output);
    if (!(options.orbit.distance > 1)) throw UsageError("--orbit: the distance must be above 1, outside the sphere");
    const Image image = image_of(options, options.orbit.distance);
    const int count = std::max(1, options.turntable);
    std::vector<View> views;
    for (int i = 0; i < count; ++i) {
        host::Orbit orbit = options.orbit;
        orbit.azimuth_deg += 360.0 * i / count;
        views.push_back({options.turntable > 0 ? numbered(output, i) : output, eye_at(host::make_pose(orbit), image)});
        views.back().eye.done = static_cast<double>(i) / count;
    }
    return views;
}

std::vector<std::string> paths_of(const std::vector<View>& views, const std::string& sheet)
{
    std::vector<std::string> paths = {sheet};
    for (const View& view : views) paths.push_back(view.path);
    return paths;
}

template <class Pixel>
Picture over_gradient(const Picture& over_corner, const Picture& over_middle)
{
    Picture result = over_corner;
    const int width = result.width_px, height = result.height_px;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto colour = [&](const Picture& picture) {
                const uint8_t* const rgb = picture.pixel(x, y);
                return Rgb8{rgb[0], rgb[1], rgb[2]};
            };
            const Rgb8 shown = host::over_backdrop<Pixel>(colour(over_corner), colour(over_middle),
                                                          host::backdrop_share(x, y, width, height), x, y);
            uint8_t* const to = result.pixel(x, y);
            to[0] = shown.r;
            to[1] = shown.g;
            to[2] = shown.b;
        }
    return result;
}

// Returns what a display shows of a picture in 24 bits that is dithered for it.
Picture dithered(const Picture& picture)
{
    const uint32_t stride = 2 * static_cast<uint32_t>(picture.width_px);
    std::vector<uint8_t> rgb = picture.rgb, pixels(size_t{stride} * static_cast<size_t>(picture.height_px));
    dither_rgb565({rgb.data(), 0, 0, picture.width_px, picture.height_px, stride / 2 * PixelRgb888::kBytes},
                  pixels.data(), stride);
    Picture result = picture;
    copy_stripe<PixelRgb565>({pixels.data(), 0, 0, picture.width_px, picture.height_px, stride}, result);
    return result;
}

Picture shown(const Eye& eye, const Drawer& draw, const Background& background, DisplayFormat display)
{
    if (display == DisplayFormat::rgb565_dithered) return dithered(shown(eye, draw, background, DisplayFormat::rgb888));
    if (background.kind == Background::Kind::none) return over_nothing(draw(eye, kBlack), draw(eye, kWhite));
    if (background.kind == Background::Kind::colour) return draw(eye, background.colour);
    const Picture over_corner = draw(eye, host::kBackdropCorner), over_middle = draw(eye, host::kBackdropMiddle);
    return with_pixel(display, [&](auto pixel) { return over_gradient<decltype(pixel)>(over_corner, over_middle); });
}

Rgb8 gap_colour(const Background& background)
{
    return background.kind == Background::Kind::gradient ? host::kBackdropCorner : background.colour;
}

// The photograph, whose size the views take.
std::optional<Picture> photo_of(ViewOptions& options)
{
    if (options.photo.empty()) return std::nullopt;
    Picture photo = read_png(options.photo);
    if (std::max(photo.width_px, photo.height_px) > kMaxImageSide)
        throw Failure(options.photo, "has a side of more than " + std::to_string(kMaxImageSide) + " pixels",
                      "make it smaller");
    options.width_px = photo.width_px;
    options.height_px = photo.height_px;
    return photo;
}

// A device or a pipe is no file that anybody looks for; where it is standard output, its name would follow the picture.
std::vector<std::string> files_among(std::vector<std::string> paths)
{
    const auto is_file = [](const std::string& path) { return std::filesystem::is_regular_file(path); };
    paths.erase(std::stable_partition(paths.begin(), paths.end(), is_file), paths.end());
    return paths;
}

// The bytes of a file at `path`. Throws Failure where no PNG can hold the picture.
std::string png_bytes_for(const std::string& path, const Picture& picture)
{
    try {
        return png_bytes(picture);
    } catch (const std::length_error& error) {
        throw Failure(path, error.what(), "choose a smaller --size");
    }
}

constexpr int kTurnMs = 4000;  // a turning picture takes so long

std::vector<std::string> write_turning(const ViewOptions& options, const std::string& output, const Drawer& draw,
                                       DisplayFormat display)
{
    if (options.turntable == 0)
        throw UsageError("a " + std::filesystem::path(output).extension().string() +
                         " is a turning picture: add --turntable 36, or name a picture in PNG");
    const std::vector<View> views = all_views(options, output);
    announce_outputs({output});
    const int frame_ms = std::max(1, kTurnMs / static_cast<int>(views.size()));
    Animation animation(options.width_px, options.height_px, frame_ms);
    for (const View& view : views) animation.add(shown(view.eye, draw, options.background, display));
    write_output(output, animation.bytes());
    return files_among({output});
}

}  // namespace

std::vector<std::string> write_views(ViewOptions options, const std::string& output, const Drawer& draw,
                                     DisplayFormat display)
{
    if (is_animation_name(output)) return write_turning(options, output, draw, display);
    const std::optional<Picture> photo = photo_of(options);
    const std::vector<View> views = all_views(options, output);
    const std::string sheet_path = tagged(output, "sheet");
    announce_outputs(paths_of(views, options.turntable > 0 ? sheet_path : ""));
    ContactSheet sheet(static_cast<int>(views.size()), options.width_px, options.height_px,
                       gap_colour(options.background), options.background.kind != Background::Kind::none);
    OutputSet pictures;
    std::vector<std::string> written;
    for (const View& view : views) {
        const Picture picture = photo ? over_photo(draw(view.eye, kBlack), draw(view.eye, kWhite), *photo)
                                      : shown(view.eye, draw, options.background, display);
        pictures.add(view.path, png_bytes_for(view.path, picture));
        written.push_back(view.path);
        sheet.add(picture);
    }
    if (options.turntable > 0) {
        pictures.add(sheet_path, png_bytes_for(sheet_path, sheet.picture()));
        written.push_back(sheet_path);
    }
    pictures.take_places();
    return files_among(written);
}

std::vector<std::string> write_each_view(const ViewOptions& options, const std::string& output,
                                         const std::function<std::string(const Eye&)>& bytes_of)
{
    const std::vector<View> views = all_views(options, output);
    announce_outputs(paths_of(views, ""));
    OutputSet pictures;
    std::vector<std::string> written;
    for (const View& view : views) {
        pictures.add(view.path, bytes_of(view.eye));
        written.push_back(view.path);
    }
    pictures.take_places();
    return written;
}

Picture over_photo(const Picture& over_black, const Picture& over_white, const Picture& photo)
{
    Picture result = over_black;
    for (size_t i = 0; i < result.rgb.size(); ++i) {
        const int seen_through = std::max(0, over_white.rgb[i] - over_black.rgb[i]);
        const int value = over_black.rgb[i] + (seen_through * photo.rgb[i] + kOpaque / 2) / kOpaque;
        result.rgb[i] = static_cast<uint8_t>(std::min(value, kOpaque));
    }
    return result;
}

Picture over_nothing(const Picture& over_black, const Picture& over_white)
{
    Picture result = over_black;
    for (size_t i = 0; i < result.rgb.size(); i += 3) {
        uint8_t* const rgb = &result.rgb[i];
        const uint8_t* const white = &over_white.rgb[i];
        const int seen_through = (white[0] - rgb[0] + white[1] - rgb[1] + white[2] - rgb[2] + 1) / 3;
        // A highlight adds more light than what it lies on hides.
        const int alpha = std::clamp<int>(kOpaque - seen_through, std::max({rgb[0], rgb[1], rgb[2]}), kOpaque);
        for (int k = 0; k < 3 && alpha != 0; ++k) rgb[k] = static_cast<uint8_t>((rgb[k] * kOpaque + alpha / 2) / alpha);
        result.alpha.push_back(static_cast<uint8_t>(alpha));
    }
    return result;
}

}  // namespace lumi::tools
