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

FrameShare share_of(const std::vector<quality::Truth>& truths)
{
    constexpr double kFullDisc = 0.735;  // the sphere fills the frame but for its corners and a margin: 42,300 pixels
    FrameShare share;
    for (const quality::Truth& truth : truths) {
        const auto& mask = truth.mask.values;
        share.object_px +=
            static_cast<double>(std::count_if(mask.begin(), mask.end(), [](uint8_t v) { return v > 0; }));
        share.sphere_px += kFullDisc * static_cast<double>(mask.size());
    }
    share.object_px /= static_cast<double>(truths.size());
    share.sphere_px /= static_cast<double>(truths.size());
    return share;
}

// Light paths a texel of a trial.
uint32_t texel_samples(Layout layout, uint32_t samples)
{
    return layout == Layout::chord ? 2 * samples : samples;  // a chord field's texels are larger, so they are fewer
}

}  // namespace

double noise_gain_db(double few_psnr_db, double twice_psnr_db, double share)
{
    constexpr double kLeast = 0.1;  // of the error is no noise, whatever two measurements seem to say
    const auto error = [](double psnr_db) { return std::pow(10, -psnr_db / 10); };
    const double few = error(few_psnr_db), noise = 2 * std::max(0.0, few - error(twice_psnr_db));
    return -10 * std::log10(std::max(kLeast, 1 - noise / few * (1 - 1 / share)));
}

uint32_t trial_samples(uint64_t budget_bytes)
{
    constexpr uint64_t kBytesAtTwo = 1'000'000;
    constexpr uint64_t kFewest = 2, kMost = 8;
    return static_cast<uint32_t>(
        std::clamp(kFewest * kBytesAtTwo / std::max<uint64_t>(1, budget_bytes), kFewest, kMost));
}

Measurer::Measurer(const baker::Scene& scene, const Task& task, const MeasureSettings& settings,
                   const baker::ProgressCallback& progress)
    : scene_(scene),
      settings_(settings),
      views_(quality::held_out_views(task.views, static_cast<int>(settings.views))),
      truths_(quality::truths_of(scene, views_, {settings.truth_samples, 1, task.threads, false}, settings.cache,
                                 progress)),
      share_(share_of(truths_))
{
}

// Estimates will do between the smallest chart and the budget; what is refused, or taken as it is, must be exact.
BytesOf Measurer::size_of(const Task& task, const baker::ProgressCallback& progress)
{
    constexpr uint32_t kSampledOrigins = 16;
    return [this, &task, &progress](const Plan& plan) {
        if (plan.layout == Layout::chord) return baker::field_file_bytes(plan.chord);
        const bool exact = task.by_hand.chart_size || plan.guided.chart_size == format::kMinChart;
        return baker::guided_file_bytes(scene_, plan.guided, *proxies_, exact ? 0 : kSampledOrigins, progress);
    };
}

Measurement Measurer::measure(const Task& task, const Plan& plan, const baker::ProgressCallback& progress)
{
    constexpr double kSlack = 0.015;
    const Fit fit = fit_plan(task, plan, size_of(task, progress), kSlack);
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
    return known_[key] = fresh(fit, settings_.samples, progress);
}

double Measurer::noise_db(const Task& task, const Plan& plan, const baker::ProgressCallback& progress)
{
    const Measurement few = measure(task, plan, progress);
    if (!few.works) return 0;
    const Measurement twice = fresh({true, few.plan, few.bytes, ""}, 2 * settings_.samples, progress);
    const uint32_t trial = texel_samples(few.plan.layout, settings_.samples);
    return noise_gain_db(few.psnr_db, twice.psnr_db, std::max(1.0, 1.0 * task.samples / trial));
}

Measurement Measurer::fresh(const Fit& fit, uint32_t samples, const baker::ProgressCallback& progress)
{
    Measurement result;
    result.plan = fit.plan;
    result.bytes = fit.bytes;
    if (affordable_modes(settings_.pace, fit.plan, share_).empty()) {
        result.note = "too slow in every mode";
        return result;
    }
    try {
        if (fit.plan.layout == Layout::chord)
            measure_chord(result, samples, progress);
        else
            measure_guided(result, samples, progress);
    } catch (const baker::BakeError& error) {
        result.note = error.what();
    }
    return result;
}

void Measurer::measure_chord(Measurement& result, uint32_t samples, const baker::ProgressCallback& progress)
{
    baker::BakeSettings cheap = result.plan.chord;
    cheap.samples = texel_samples(Layout::chord, samples);
    cheap.max_error_levels = 0;
    const ScratchFolder folder;
    baker::bake_field(scene_, cheap, folder / "trial.lumi", progress, baker::Earlier::discard);
    const tools::FieldFile file((folder / "trial.lumi").string());
    judge(result, [&](const DrawMode& mode, const tools::Eye& eye) {
        tools::DrawSettings drawing;
        drawing.mode = mode.chord;
        return tools::draw(file.field(), eye.camera, drawing);
    });
}

void Measurer::measure_guided(Measurement& result, uint32_t samples, const baker::ProgressCallback& progress)
{
    baker::GuidedSettings cheap = result.plan.guided;
    cheap.samples = texel_samples(Layout::guided, samples);
    const baker::GuidedBake bake = baker::guided_field(scene_, cheap, progress, proxies_.get());
    result.bytes = bake.file.size();
    GuidedField field;
    if (const FieldError error = open_guided(bake.file.data(), bake.file.size(), field); error != FieldError::none)
        throw baker::BakeError(std::string("the baked field cannot be opened: ") + describe(error));
    judge(result, [&](const DrawMode& mode, const tools::Eye& eye) {
        return tools::draw_guided(field, eye, {mode.guided, mode.antialiased, {}, {0, 0, 0}});
    });
}

void Measurer::judge(Measurement& result, const std::function<tools::Picture(const DrawMode&, const tools::Eye&)>& draw)
{
    for (const DrawMode& mode : affordable_modes(settings_.pace, result.plan, share_)) {
        std::vector<quality::Figures> figures;
        for (size_t v = 0; v < views_.size(); ++v) {
            tools::leave_if_interrupted();
            figures.push_back(quality::quick_figures_of(draw(mode, views_[v].eye), truths_[v]));
        }
        const quality::Figures mean = quality::mean_of(figures);
        if (result.works && mean.psnr_db <= result.psnr_db) continue;
        result.works = true;
        result.psnr_db = mean.psnr_db;
        result.ssim = mean.ssim;
        result.mode = mode.name;
        if (settings_.pace) result.rate = modelled_rate(*settings_.pace->chip, result.plan, mode, share_);
    }
}

}  // namespace lumi::planner
