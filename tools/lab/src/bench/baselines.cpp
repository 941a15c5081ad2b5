// SPDX-License-Identifier: MIT
#include "bench/baselines.h"

#include <algorithm>

#include "bench/boards.h"
#include "bench/host_renderer.h"
#include "bench/sprites.h"
#include "files/field_file.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"

namespace lumi::bench
{
namespace
{

constexpr const char* kTexel = "rgb565";
constexpr uint32_t kReferenceSamples = 64;
constexpr int kSpan = 16;

struct Baseline {
    const char* title;
    const char* renderer;
    std::vector<std::string> cores;
};

// The floating-point unit where there is one, software where there is none.
const std::vector<Baseline> kBaselines = {
    {"paper 5×5 in float, no FPU", "baseline_float", {"m0plus", "m3"}},
    {"paper 5×5 in float, FPU", "baseline_float_fpu", {"m4", "m7"}},
    {"sprite, copied", "baseline_copy", kCores},
    {"sprite, turned and scaled", "baseline_affine", kCores},
};

void measure_costs(const Settings& settings, const std::string& core, const std::string& field, Baselines& out)
{
    const Board board(core, settings.source, settings.work);
    for (const Baseline& baseline : kBaselines) {
        if (std::find(baseline.cores.begin(), baseline.cores.end(), core) == baseline.cores.end()) continue;
        board.build({baseline.renderer});
        for (const Count& count : board.count(baseline.renderer, field, {kViewNames[0]}, {0}))
            out.costs.push_back({baseline.title, core, count, board.code_bytes(baseline.renderer)});
    }
}

using DrawView = std::function<tools::Picture(const View&)>;

Likeness likeness(const std::string& title, uint64_t flash_bytes, const std::vector<tools::Picture>& references,
                  const DrawView& draw)
{
    Likeness result = {title, flash_bytes, {}, {}};
    for (size_t v = 0; v < references.size(); ++v) {
        const tools::Picture drawn = draw(kViews[v]);
        result.psnr_db[v] = tools::psnr_db(references[v], drawn);
        result.ssim[v] = tools::ssim(references[v], drawn);
    }
    return result;
}

tools::Picture field_picture(const tools::FieldFile& file, const std::string& mode, int span, const View& view)
{
    Camera camera;
    if (make_view_camera(view, camera) != CameraError::none) return {};
    return draw_on_host(mode, span, file.field(), file.bytes(), camera).picture;
}

void compare_pictures(const Settings& settings, const tools::FieldFile& file, Baselines& out)
{
    std::vector<std::string> warnings;
    const baker::Scene scene = baker::load_scene(settings.field.scene, {}, warnings);
    std::vector<tools::Picture> references;
    for (const View& view : kViews) {
        const Pose pose = orbit(view.azimuth_turns32, view.elevation_turns32, view.distance_q20);
        references.push_back(traced_view(scene, pose, {kSidePx, kSidePx, view.fov_turns32}, kReferenceSamples));
    }
    constexpr uint64_t kSpriteBytes = uint64_t{kSidePx} * kSidePx * 2;
    const auto count = static_cast<uint32_t>(file.size() / kSpriteBytes);
    for (const std::string& mode : kModes)
        out.pictures.push_back(likeness(mode + ", span 16", file.size(), references,
                                        [&](const View& view) { return field_picture(file, mode, kSpan, view); }));
    if (count == 0) return;  // the field is smaller than a single sprite
    out.pictures.push_back(
        likeness(std::to_string(count) + " sprites, nearest", count * kSpriteBytes, references, [&](const View& view) {
            return sprite_picture(scene, {count, kReferenceSamples}, view);
        }));
}

}  // namespace

Baselines measure_baselines(const Settings& settings, const Announce& announce)
{
    Baselines result;
    const tools::FieldFile file(require_field(settings.field, kTexel, settings.work).string());
    for (const std::string& core : settings.matrix.cores) {
        announce(core + ": baselines");
        measure_costs(settings, core, file.path(), result);
    }
    announce("pictures of fields and sprites");
    compare_pictures(settings, file, result);
    return result;
}

}  // namespace lumi::bench
