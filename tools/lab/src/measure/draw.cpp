// SPDX-License-Identifier: MIT
// lumi-lab draw: how long this machine draws an RGB565 chord field by the paper's modes, in RGB888, and what of it is
// reading texels. Processor time of one core, so other programs count little.
#include <algorithm>
#include <cstdint>
#include <ctime>
#include <stdexcept>
#include <vector>

#include "files/field_file.h"
#include "lumi/chord/render_spans.h"
#include "lumi/host/camera.h"
#include "measure/commands.h"

namespace lumi::lab
{

namespace
{

constexpr int kViews = 3, kRepeats = 3;  // the quickest repeat counts: interruptions only slow down
constexpr double kDistance = 3, kEyeDistance = kDistance / 30;
constexpr int kStripeHeight = 16;

// A texel policy that computes where a texel lies and does not read it: its colour is made of the address.
struct Unread : TexelRgb565 {
    static detail::Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uintptr_t at = reinterpret_cast<uintptr_t>(row) + 2 * j;
        const auto level = [&](int shift) { return static_cast<uint8_t>(at >> shift); };
        return {level(1), level(4), level(7), 255};
    }
};

double processor_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

// Left and right eye, one after the other, around the upper half.
std::vector<Camera> eyes_of(int width_px, int height_px)
{
    std::vector<Camera> cameras;
    const Image image = host::make_image(width_px, height_px, host::framing_fov_deg(width_px, height_px, kDistance));
    for (int view = 0; view < kViews; ++view) {
        const Pose pose = host::make_pose({77.0 + 360.0 * view / kViews, 20.0 + 20.0 * view, kDistance});
        for (const double side : {-kEyeDistance / 2, kEyeDistance / 2}) {
            Camera camera;
            if (make_camera(moved_right(pose, host::q20_from_radii(side)), image, camera) != CameraError::none)
                throw std::runtime_error("no camera has a picture of that size");
            cameras.push_back(camera);
        }
    }
    return cameras;
}

template <class Reconstruction, class Texel>
inline constexpr bool kHasSpans = std::is_same_v<Texel, TexelRgb565>;
template <uint32_t kNeighbours, class Texel>
inline constexpr bool kHasSpans<Paper<kNeighbours>, Texel> = false;

template <class Reconstruction, class Texel>
void draw_frame(const Field& field, const Camera& camera, int span_px, std::vector<uint8_t>& pixels)
{
    const uint32_t stride = static_cast<uint32_t>(camera.width_px()) * PixelRgb888::kBytes;
    for (int y = 0; y < camera.height_px(); y += kStripeHeight) {
        const Stripe stripe = {pixels.data(), 0, y, camera.width_px(), std::min(kStripeHeight, camera.height_px() - y),
                               stride};
        RenderError error = RenderError::none;
        if (span_px == 0)
            error = render<Reconstruction, Texel, PixelRgb888>(field, camera, OverBlack(), stripe);
        else if constexpr (kHasSpans<Reconstruction, Texel>)
            error = render_spans<Reconstruction, Texel, PixelRgb888>(field, camera, OverBlack(), stripe, span_px);
        if (error != RenderError::none) throw std::runtime_error("the field is not drawn: give an RGB565 chord field");
    }
}

// The processor time of one eye's frame, the mean over views; the best of kRepeats.
template <class Reconstruction, class Texel>
double frame_seconds(const Field& field, const std::vector<Camera>& cameras, int span_px)
{
    std::vector<uint8_t> pixels(static_cast<size_t>(cameras[0].width_px()) * PixelRgb888::kBytes * kStripeHeight);
    double best = 1e30;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        const double begin = processor_seconds();
        for (const Camera& camera : cameras) draw_frame<Reconstruction, Texel>(field, camera, span_px, pixels);
        best = std::min(best, processor_seconds() - begin);
    }
    return best / static_cast<double>(cameras.size());
}

template <class Reconstruction>
void add_results(const char* mode, const Field& field, const std::vector<Camera>& cameras,
                 nlohmann::ordered_json& results)
{
    const double read = frame_seconds<Reconstruction, TexelRgb565>(field, cameras, 0);
    const double unread = frame_seconds<Reconstruction, Unread>(field, cameras, 0);
    results.push_back({{"mode", mode}, {"span", 0}, {"frame_ms", 1e3 * read}, {"unread_frame_ms", 1e3 * unread}});
    if (!kHasSpans<Reconstruction, TexelRgb565> || !fits_spans(field)) return;
    for (const int span : {8, 16})
        results.push_back({{"mode", mode},
                           {"span", span},
                           {"frame_ms", 1e3 * frame_seconds<Reconstruction, TexelRgb565>(field, cameras, span)}});
}

void print_drawing(const std::string& path, int width_px, int height_px)
{
    const tools::FieldFile file(path);
    file.require_intact();
    if (file.is_surface() || file.field().texel_format != TexelFormat::rgb565)
        throw std::runtime_error(path + ": is no chord field of RGB565 texels; bake it with --texel rgb565");
    const std::vector<Camera> cameras = eyes_of(width_px, height_px);
    nlohmann::ordered_json results;
    add_results<Nearest>("nearest", file.field(), cameras, results);
    add_results<Linear>("linear", file.field(), cameras, results);
    add_results<Paper<5>>("paper5", file.field(), cameras, results);
    add_results<Paper<9>>("paper9", file.field(), cameras, results);
    print(results);
}

}  // namespace

void add_draw(CLI::App& lab)
{
    struct Options {
        std::string field;
        int width_px = 0, height_px = 0;
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = lab.add_subcommand("draw", "Time the paper's modes on this machine");
    command->add_option("FIELD", options->field, "A chord field of RGB565 texels")->required();
    command->add_option("WIDTH", options->width_px, "Pixels")->required();
    command->add_option("HEIGHT", options->height_px, "Pixels")->required();
    command->callback([options] { print_drawing(options->field, options->width_px, options->height_px); });
}

}  // namespace lumi::lab
