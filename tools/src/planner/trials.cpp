// SPDX-License-Identifier: MIT
#include "planner/trials.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "files/field_file.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"

namespace lumi::planner
{

namespace
{

// A folder for chord fields, which are baked into files; gone afterwards.
class ScratchFolder
{
public:
    ScratchFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "lumi-plan-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw tools::Failure(name, "cannot be made for trial bakes", "set TMPDIR to a folder with room");
        path_ = name;
    }
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

}  // namespace

uint32_t trial_samples(uint64_t budget_bytes)
{
    constexpr uint64_t kBytesAtFour = 1'000'000;
    constexpr uint64_t kFewest = 4, kMost = 16;
    return static_cast<uint32_t>(
        std::clamp(kFewest * kBytesAtFour / std::max<uint64_t>(1, budget_bytes), kFewest, kMost));
}

Measurer::Measurer(const baker::Scene& scene, const Task& task, const MeasureSettings& settings,
                   const baker::ProgressCallback& progress)
    : scene_(scene),
      settings_(settings),
      views_(quality::held_out_views(task.views, static_cast<int>(settings.views))),
      truths_(
          quality::truths_of(scene, views_, {settings.truth_samples, 1, task.threads, false}, settings.cache, progress))
{
}

Measurement Measurer::measure(const Task& task, const Plan& plan, const baker::ProgressCallback& progress)
{
    constexpr double kSlack = 0.015;
    const BytesOf bytes_of = [](const Plan& sized) { return baker::field_file_bytes(sized.chord); };
    const Fit fit = fit_plan(task, plan, bytes_of, kSlack);
    if (!fit.fits) {
        Measurement failed;
        failed.plan = fit.plan;
        failed.bytes = fit.bytes;
        failed.note = fit.note;
        return failed;
    }
    const std::string key = text_of(fit.plan);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    return known_[key] = fresh(fit, progress);
}

Measurement Measurer::fresh(const Fit& fit, const baker::ProgressCallback& progress)
{
    Measurement result;
    result.plan = fit.plan;
    result.bytes = fit.bytes;
    if (affordable_modes(settings_.pace).empty()) {
        result.note = "too slow in every mode";
        return result;
    }
    try {
        bake_and_judge(result, progress);
    } catch (const baker::BakeError& error) {
        result.note = error.what();
    }
    return result;
}

void Measurer::bake_and_judge(Measurement& result, const baker::ProgressCallback& progress)
{
    baker::BakeSettings cheap = result.plan.chord;
    cheap.samples = settings_.samples;
    cheap.max_error_levels = 0;
    const ScratchFolder folder;
    baker::bake_field(scene_, cheap, folder / "trial.lumi", progress, baker::Earlier::discard);
    const tools::FieldFile file((folder / "trial.lumi").string());
    judge(result, file.field());
}

void Measurer::judge(Measurement& result, const Field& field)
{
    for (const DrawMode& mode : affordable_modes(settings_.pace)) {
        tools::DrawSettings drawing;
        drawing.mode = mode.mode;
        std::vector<quality::Figures> figures;
        for (size_t v = 0; v < views_.size(); ++v) {
            tools::leave_if_interrupted();
            figures.push_back(quality::quick_figures_of(tools::draw(field, views_[v].eye.camera, drawing), truths_[v]));
        }
        const quality::Figures mean = quality::mean_of(figures);
        if (result.works && mean.psnr_db <= result.psnr_db) continue;
        result.works = true;
        result.psnr_db = mean.psnr_db;
        result.ssim = mean.ssim;
        result.mode = mode.name;
        if (settings_.pace) result.rate = modelled_rate(*settings_.pace->chip, mode);
    }
}

}  // namespace lumi::planner
