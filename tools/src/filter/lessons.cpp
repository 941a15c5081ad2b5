// SPDX-License-Identifier: MIT
#include "filter/lessons.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "math/pi.h"

namespace lumi::filter
{

namespace
{

using quality::HeldOutView;
using quality::Reference;

constexpr int kPaperTraining = 2220, kPaperValidation = 204, kPaperTest = 195;
constexpr int kPaperAll = kPaperTraining + kPaperValidation + kPaperTest;

int share_of(int views, int part)
{
    return std::max(1, (views * part + kPaperAll / 2) / kPaperAll);
}

// [0, 1), the same on every machine.
double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

void deal_out(std::vector<HeldOutView>& views, std::mt19937_64& random)
{
    for (size_t i = views.size(); i > 1; --i) std::swap(views[i - 1], views[random() % i]);
}

// Draws and traces, view by view.
class Maker
{
public:
    Maker(const tools::FieldFile& field, const baker::Scene& scene, const LessonSettings& settings, uint64_t rays,
          const baker::ProgressCallback& progress)
        : field_(field), scene_(scene), settings_(settings), course_(progress, rays)
    {
    }

    Reference reference(const HeldOutView& view, uint32_t samples)
    {
        const baker::ReferenceSettings settings = {samples, settings_.seed, settings_.threads};
        const uint64_t rays = quality::rays_of({view}, settings);
        return std::move(quality::references_of(scene_, {view}, settings, settings_.cache, course_.next(rays)).front());
    }

    std::vector<Pair> pairs(const std::vector<HeldOutView>& views, uint32_t samples)
    {
        std::vector<Pair> pairs;
        for (const HeldOutView& view : views)
            pairs.push_back({drawn_planes(field_, view.eye), reference_planes(reference(view, samples))});
        return pairs;
    }

    Trial trial(const std::vector<HeldOutView>& views, uint32_t samples)
    {
        Trial trial;
        for (const HeldOutView& view : views) {
            trial.drawn.push_back(drawn_planes(field_, view.eye));
            trial.references.push_back(reference(view, samples));
        }
        return trial;
    }

private:
    const tools::FieldFile& field_;
    const baker::Scene& scene_;
    const LessonSettings& settings_;
    baker::JobSeries course_;
};

}  // namespace

Views lesson_views(const LessonSettings& settings, double cap)
{
    constexpr double kNearest = 2.5, kFarthest = 4, kDegrees = 360;
    constexpr double kGolden = 1.61803398874989484820;
    std::mt19937_64 random(settings.seed);
    std::vector<HeldOutView> all;
    for (int k = 0; k < settings.views; ++k) {
        const double z = 1 - 2 * cap * (k + 0.5) / settings.views;
        const double elevation = std::asin(z) * kDegrees / (2 * tools::kPi);
        const double azimuth = kDegrees * (k / kGolden - std::floor(k / kGolden));
        const double distance = kNearest + (kFarthest - kNearest) * uniform(random);
        all.push_back(quality::view_at(azimuth, elevation, distance, settings.side_px));
    }
    deal_out(all, random);
    const auto validation = all.begin() + share_of(settings.views, kPaperValidation);
    const auto test = validation + share_of(settings.views, kPaperTest);
    return {{test, all.end()}, {all.begin(), validation}, {validation, test}};
}

double cap_of(const tools::FieldFile& field)
{
    if (field.is_surface()) return 1;
    return static_cast<double>(field.field().used_origins) / field.field().origins.size();
}

Lessons lessons_of(const tools::FieldFile& field, const baker::Scene& scene, const LessonSettings& settings,
                   const baker::ProgressCallback& progress)
{
    const Views views = lesson_views(settings, cap_of(field));
    const uint32_t judging = settings.samples * kJudgesSamples;
    const uint64_t pixels = static_cast<uint64_t>(settings.side_px) * static_cast<uint64_t>(settings.side_px);
    const uint64_t paths =
        views.training.size() * settings.samples + (views.validation.size() + views.test.size()) * judging;
    Maker maker(field, scene, settings, pixels * paths, progress);
    Lessons lessons;
    lessons.training = maker.pairs(views.training, settings.samples);
    lessons.validation = maker.pairs(views.validation, judging);
    lessons.test = maker.trial(views.test, judging);
    return lessons;
}

namespace
{

Planes filtered(Network& network, const Planes& inputs, double& fastest_ms)
{
    const std::clock_t begin = std::clock();
    Planes planes = network.filtered(inputs);
    fastest_ms = std::min(fastest_ms, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    return planes;
}

void count_worse(const quality::Figures& drawn, const quality::Figures& filtered, Verdict& verdict)
{
    verdict.worse_psnr += filtered.psnr_db < drawn.psnr_db;
    verdict.worse_ssim += filtered.ssim < drawn.ssim;
    verdict.worse_cw_ssim += filtered.cw_ssim < drawn.cw_ssim;
    verdict.worse_flip += filtered.flip > drawn.flip;
}

std::string row(const char* name, const quality::Figures& f)
{
    char text[160];
    std::snprintf(text, sizeof text, "%-9s %8.2f %8.2f %8.4f %8.4f %8.4f\n", name, f.psnr_db, f.mask_psnr_db, f.ssim,
                  f.cw_ssim, f.flip);
    return text;
}

nlohmann::ordered_json json_of(const quality::Figures& f)
{
    return {{"psnr_db", f.psnr_db},
            {"mask_psnr_db", f.mask_psnr_db},
            {"ssim", f.ssim},
            {"cw_ssim", f.cw_ssim},
            {"flip", f.flip}};
}

}  // namespace

Verdict verdict_on(Network* network, const Trial& trial)
{
    Verdict verdict;
    verdict.views = static_cast<int>(trial.drawn.size());
    double fastest_ms = std::numeric_limits<double>::infinity();
    std::vector<quality::Figures> drawn, after;
    for (size_t k = 0; k < trial.drawn.size(); ++k) {
        const Planes& inputs = trial.drawn[k];
        drawn.push_back(quality::figures_of(over(inputs), trial.references[k]));
        after.push_back(drawn.back());
        if (network != nullptr)
            after.back() = quality::figures_of(over(filtered(*network, inputs, fastest_ms)), trial.references[k]);
        count_worse(drawn.back(), after.back(), verdict);
    }
    verdict.drawn = quality::mean_of(drawn);
    verdict.filtered = quality::mean_of(after);
    if (network != nullptr) verdict.milliseconds = fastest_ms;
    return verdict;
}

std::string text_of(const Verdict& verdict)
{
    char worse[200];
    std::snprintf(worse, sizeof worse,
                  "of %d views, worse when filtered: PSNR %d, SSIM %d, CW-SSIM %d, FLIP %d; %.0f ms of CPU a view\n",
                  verdict.views, verdict.worse_psnr, verdict.worse_ssim, verdict.worse_cw_ssim, verdict.worse_flip,
                  verdict.milliseconds);
    return "          PSNR dB  covered     SSIM  CW-SSIM     FLIP\n" + row("drawn", verdict.drawn) +
           row("filtered", verdict.filtered) + worse;
}

std::string json_of(const Verdict& verdict)
{
    const nlohmann::ordered_json json = {{"views", verdict.views},
                                         {"drawn", json_of(verdict.drawn)},
                                         {"filtered", json_of(verdict.filtered)},
                                         {"worse",
                                          {{"psnr", verdict.worse_psnr},
                                           {"ssim", verdict.worse_ssim},
                                           {"cw_ssim", verdict.worse_cw_ssim},
                                           {"flip", verdict.worse_flip}}},
                                         {"milliseconds", verdict.milliseconds}};
    return json.dump(2) + "\n";
}

}  // namespace lumi::filter
