// SPDX-License-Identifier: MIT
// Measures plans: bakes each with few light paths at its full size, draws it with the renderer of firmware, and
// compares with path-traced truths.
#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "planner/fit.h"
#include "planner/speed.h"
#include "quality/truths.h"

namespace lumi::planner
{

struct MeasureSettings {
    uint32_t views = 6;           // not the ones that `lumi report` judges by
    uint32_t truth_samples = 32;  // light paths a pixel
    uint32_t samples = 4;         // light paths a texel; trials that are compared must agree in it
    std::filesystem::path cache;  // of truths; empty: they are not kept
    std::optional<Pace> pace;
};

// What is known of a plan once it was baked and drawn.
struct Measurement {
    bool works = false;
    Plan plan;  // with its size
    uint64_t bytes = 0;
    double psnr_db = 0, ssim = 0;  // means over the views
    const char* mode = "";         // that it was drawn in: the best that the pace allows
    std::optional<double> rate;    // modelled frames per second in that mode, with a pace
    std::string note;              // why it does not work
};

class Measurer
{
public:
    // Keeps references. Traces the truths. Throws Cancelled.
    Measurer(const baker::Scene& scene, const Task& task, const MeasureSettings& settings,
             const baker::ProgressCallback& progress);

    // Bakes `plan` in the size that fills the budget and judges it; a plan that differs in nothing that counts from an
    // earlier one is not baked again. Throws Cancelled.
    Measurement measure(const Task& task, const Plan& plan, const baker::ProgressCallback& progress);

    // What the noise of a trial's few light paths costs this plan against task.samples of them, in dB; 0 where the plan
    // does not work. Measured by baking it with twice as many paths: the noise's share of the squared error halves.
    double noise_db(const Task& task, const Plan& plan, const baker::ProgressCallback& progress);

    // Of all plans that were measured.
    std::shared_ptr<baker::ProxyCache> proxies() const { return proxies_; }

private:
    Measurement fresh(const Fit& fit, uint32_t samples, const baker::ProgressCallback& progress);
    void measure_chord(Measurement& result, uint32_t samples, const baker::ProgressCallback& progress);
    void measure_guided(Measurement& result, uint32_t samples, const baker::ProgressCallback& progress);
    void judge(Measurement& result, const std::function<tools::Picture(const DrawMode&, const tools::Eye&)>& draw);
    BytesOf size_of(const Task& task, const baker::ProgressCallback& progress);

    const baker::Scene& scene_;
    const MeasureSettings settings_;
    std::vector<quality::HeldOutView> views_;
    std::vector<quality::Truth> truths_;
    FrameShare share_;
    const std::shared_ptr<baker::ProxyCache> proxies_ = std::make_shared<baker::ProxyCache>();
    std::map<std::string, Measurement> known_;  // by the sized plan's text
};

// Squared errors of the same plan with few light paths a texel and with twice as many give what it has with `share`
// times the few: how many dB better that is. At least 0: noise only harms.
double noise_gain_db(double few_psnr_db, double twice_psnr_db, double share);

// A number of light paths a texel with which trials of all budgets take about the same time.
uint32_t trial_samples(uint64_t budget_bytes);

}  // namespace lumi::planner
