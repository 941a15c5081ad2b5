// SPDX-License-Identifier: MIT
#include "commands/layout_trial.h"

#include "../quality/measured.h"
#include "files/output_file.h"

namespace lumi::tools
{
namespace
{

constexpr uint32_t kTrialPaths = 4;  // light paths a texel, where a pilot does not trace more: at the few dB that are
                                     // in doubt, noise does not decide

class TrialFolder
{
public:
    TrialFolder() : path_(new_temporary_folder("choose a layout: --layout surface or --layout chord")) {}
    ~TrialFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TrialFolder(const TrialFolder&) = delete;
    TrialFolder& operator=(const TrialFolder&) = delete;

    std::filesystem::path field() const { return path_ / "trial.lumi"; }

private:
    std::filesystem::path path_;
};

}  // namespace

LayoutTrial tried_layouts(const baker::Scene& scene, const baker::SurfacePlan& surface,
                          const baker::BakeSettings& chord, const baker::ProgressCallback& progress)
{
    const TrialFolder folder;
    const auto measured = [&] {
        const FieldFile field(folder.field().string(), FieldFile::Role::own_output);
        return quality::quick_psnr_db(scene, field, static_cast<double>(surface.settings.cap), chord.threads, progress);
    };
    LayoutTrial trial = {};
    baker::BakeSettings few = chord;
    few.samples = std::min(few.samples, kTrialPaths);
    baker::bake_field(scene, few, folder.field(), progress);
    trial.chord_db = measured();
    baker::SurfacePlan plan = surface;
    plan.settings.paths_per_texel = std::min(plan.settings.paths_per_texel, kTrialPaths);
    baker::bake_surface(scene, plan, folder.field(), progress);
    trial.surface_db = measured();
    return trial;
}

}  // namespace lumi::tools
