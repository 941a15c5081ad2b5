// SPDX-License-Identifier: MIT
// Measures plans: bakes each with few light paths at its full size, draws it with the renderer of firmware, and
// compares with path-traced truths.
#pragma once

#include <filesystem>
#include <map>

#include "planner/fit.h"
#include "planner/speed.h"
#include "quality/truths.h"

namespace lumi::planner
{

struct MeasureSettings {
    uint32_t views = 6;           // not the ones that `lumi report` judges by
    uint32_t truth_samples = 32;  // light paths a pixel
    uint32_t samples = 8;         // light paths a texel; trials that are compared must agree in it
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

private:
    Measurement fresh(const Fit& fit, const baker::ProgressCallback& progress);
    void bake_and_judge(Measurement& result, const baker::ProgressCallback& progress);
    void judge(Measurement& result, const Field& field);

    const baker::Scene& scene_;
    const MeasureSettings settings_;
    std::vector<quality::HeldOutView> views_;
    std::vector<quality::Truth> truths_;
    std::map<std::string, Measurement> known_;  // by the sized plan's text
};

// A number of light paths a texel with which trials of all budgets take about the same time.
uint32_t trial_samples(uint64_t budget_bytes);

}  // namespace lumi::planner
