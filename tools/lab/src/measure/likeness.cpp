// SPDX-License-Identifier: MIT
// lumi-lab likeness: how much a chord field's pictures, and those of as many sprites as fit into its flash, look like
// the path-traced reference.
#include <functional>
#include <memory>

#include "bench/host_renderer.h"
#include "comparison/sprites.h"
#include "files/field_file.h"
#include "measure/commands.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"
#include "terminal/failure.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;
using DrawView = std::function<tools::Picture(const bench::View&)>;

constexpr uint32_t kReferenceSamples = 64;
constexpr int kSpan = 16;

std::vector<tools::Picture> references_of(const baker::Scene& scene)
{
    std::vector<tools::Picture> references;
    for (const bench::View& view : bench::kViews)
        references.push_back(
            bench::traced_view(scene, bench::view_pose(view), bench::view_image(view), kReferenceSamples));
    return references;
}

Json likeness(const std::string& method, uint64_t flash_bytes, const std::vector<tools::Picture>& references,
              const DrawView& draw)
{
    Json row = {{"method", method}, {"flash_bytes", flash_bytes}};
    for (size_t v = 0; v < references.size(); ++v) {
        const bench::View& view = bench::kViews[v];
        const tools::Picture drawn = draw(view);
        row[view.name] = {{"psnr_db", tools::psnr_db(references[v], drawn)},
                          {"ssim", tools::ssim(references[v], drawn)}};
    }
    return row;
}

tools::Picture field_picture(const tools::FieldFile& file, const std::string& mode, const bench::View& view)
{
    Camera camera;
    if (make_view_camera(view, camera) != CameraError::none) return {};
    return bench::draw_on_host(mode, kSpan, file.field(), file.bytes(), camera).picture;
}

void run(const std::string& scene_file, const std::string& field_file)
{
    const tools::FieldFile file(field_file);
    file.require_intact();
    if (file.is_surface()) throw tools::Failure(field_file, "holds a surface field", "give a chord field");
    std::vector<std::string> warnings;
    const baker::Scene scene = baker::load_scene(scene_file, {}, warnings);
    const std::vector<tools::Picture> references = references_of(scene);
    Json rows = Json::array();
    for (const std::string mode : {"nearest", "voronoi", "dither", "linear", "paper"})
        rows.push_back(likeness(mode + ", span 16", file.size(), references,
                                [&](const bench::View& view) { return field_picture(file, mode, view); }));
    constexpr uint64_t kSpriteBytes = uint64_t{bench::kSidePx} * bench::kSidePx * 2;
    if (const auto count = static_cast<uint32_t>(file.size() / kSpriteBytes); count > 0)
        rows.push_back(likeness(std::to_string(count) + " sprites, nearest", count * kSpriteBytes, references,
                                [&](const bench::View& view) {
                                    return bench::sprite_picture(scene, {count, kReferenceSamples}, view);
                                }));
    print(rows);
}

}  // namespace

void add_likeness(CLI::App& lab)
{
    auto words = std::make_shared<std::array<std::string, 2>>();
    CLI::App* command = lab.add_subcommand("likeness", "Compare a chord field and sprites of its size with references");
    command->add_option("SCENE", (*words)[0], "The scene")->required();
    command->add_option("FIELD", (*words)[1], "Its chord field")->required();
    command->callback([words] { run((*words)[0], (*words)[1]); });
}

}  // namespace lumi::lab
