// SPDX-License-Identifier: MIT
#include "commands/pace_plan.h"

#include <algorithm>
#include <cmath>

#include "../quality/measured.h"
#include "commands/device_figures.h"
#include "draw/draw_surface.h"

namespace lumi::tools
{
namespace
{

constexpr uint32_t kTrialPaths = 4;  // light paths a texel: the pilot's are enough
constexpr int kTrialPoses = 40;      // that are drawn to rate a mesh
constexpr uint32_t kFewestTriangles = 200;
constexpr int kMostRefined = 3;       // meshes between those of ever fewer triangles
constexpr float kLongestEdge = 0.4f;  // core draws longer ones in steps, so that fewer triangles take more time

// A way of drawing a mesh.
struct PacedWay {
    SurfaceMode mode;
    bool view_tables;
};
constexpr PacedWay kWays[] = {{SurfaceMode::two_by_two, true},   {SurfaceMode::antialiased, true},
                              {SurfaceMode::one_sample, true},   {SurfaceMode::two_by_two, false},
                              {SurfaceMode::antialiased, false}, {SurfaceMode::one_sample, false}};
constexpr size_t kWayCount = sizeof kWays / sizeof *kWays;

class PacePlanner
{
public:
    PacePlanner(const baker::Scene& scene, const baker::SurfacePlan& largest, const baker::SurfaceLimits& limits,
                const std::vector<planner::Pace>& paces, const host::ScreenSize& screen,
                const baker::ProgressCallback& progress)
        : scene_(scene),
          largest_(largest),
          limits_(limits),
          paces_(paces),
          screen_(screen),
          progress_(progress),
          measure_(scene, std::min(screen.width_px, screen.height_px), static_cast<double>(largest.settings.cap),
                   largest.settings.threads, progress)
    {
    }

    PacePlan plan()
    {
        uint32_t triangles = largest_.settings.triangles;
        while (try_mesh(triangles) && fewer_may_gain() && triangles > kFewestTriangles)
            triangles = std::max(triangles / 4, kFewestTriangles);
        if (trials_.empty()) throw baker::BakeError("no mesh could be tried");
        refine();
        return chosen();
    }

private:
    // A mesh shows this so fast, by each way; a share of 0 where it does not fit the part.
    struct Trial {
        baker::SurfacePlan plan;
        double psnr_db[kWayCount], share[kWayCount], rate[kWayCount];
    };

    // False where the mesh does not do the scene justice.
    bool try_mesh(uint32_t triangles)
    {
        baker::SurfaceLimits limits = limits_;
        baker::SurfaceSettings settings = largest_.settings;
        const double times = 1.0 * largest_.settings.triangles / triangles;
        settings.triangles = triangles;
        if (times != 1)
            settings.longest_edge =
                std::min(kLongestEdge, settings.longest_edge * static_cast<float>(std::sqrt(times)));
        limits.chooses_triangles = limits.chooses_edge = false;
        Trial trial = {baker::plan_surface(scene_, settings, limits, progress_), {}, {}, {}};
        if (!trial.plan.mesh || (!trial.plan.against.empty() && largest_.against.empty())) return false;
        baker::SurfacePlan few = trial.plan;
        few.settings.paths_per_texel = std::min(few.settings.paths_per_texel, kTrialPaths);
        const baker::SurfaceBake bake = baker::surface_field(scene_, few, progress_);
        SurfaceField field, plain;
        if (!opens(bake, field)) return false;
        plain = field;
        plain.lit_count = 0;
        baker::SurfaceBake without;
        if (gloss_count(field) != 0) {  // texels beside maps lack what these add
            few.settings.view_tables = false;
            without = baker::surface_field(scene_, few, progress_);
            if (!opens(without, plain)) return false;
        }
        for (size_t k = 0; k < kWayCount; ++k)
            if (kWays[k].view_tables)
                rate(trial, field, k);
            else if (field.viewed_count != 0)  // else the way with tables is the same
                rate(trial, plain, k);
        trials_.push_back(std::move(trial));
        return true;
    }

    static bool opens(const baker::SurfaceBake& bake, SurfaceField& field)
    {
        return open_surface<SurfaceFeatures::all>(bake.file.data(), bake.file.size(), field) == FieldError::none;
    }

    void rate(Trial& trial, const SurfaceField& field, size_t k) const
    {
        SurfaceDrawSettings settings;
        settings.mode = kWays[k].mode;
        trial.psnr_db[k] =
            measure_.psnr_db([&](const quality::HeldOutView& view) { return draw_surface(field, view.eye, settings); });
        const uint64_t ram = planner::ram_of(host::counts_of(field, kWays[k].mode), screen_).all();
        const auto rates = planner::surface_rates(field, kWays[k].mode, screen_, kTrialPoses);
        trial.share[k] = 1e9;
        for (const planner::Pace& pace : paces_) {
            const double rate = rates[static_cast<size_t>(pace.chip - planner::kChipList.data())].of(pace.cores);
            if (&pace == paces_.data()) trial.rate[k] = rate;
            const double share = ram > pace.chip->ram_bytes ? 0 : rate / pace.frames_per_second;
            trial.share[k] = std::min(trial.share[k], share);
        }
    }

    static double triangles_of(const Trial& trial) { return trial.plan.settings.triangles; }

    // The share of the pace by one way with so many triangles: a frame's time is about linear in them.
    static double share_at(const Trial& a, const Trial& b, size_t way, double triangles)
    {
        const double slope = (1 / a.share[way] - 1 / b.share[way]) / (triangles_of(a) - triangles_of(b));
        return 1 / (1 / b.share[way] + slope * (triangles - triangles_of(b)));
    }

    // Whether a way that is too slow with the last mesh shows more than what keeps the pace, and may keep it with fewer
    // triangles.
    bool fewer_may_gain() const
    {
        const Trial& last = trials_.back();
        const double best = best_db();
        for (size_t k = 0; k < kWayCount; ++k) {
            if (last.share[k] <= 0 || last.share[k] >= 1 || last.psnr_db[k] <= best) continue;
            if (trials_.size() < 2 || share_at(trials_[trials_.size() - 2], last, k, kFewestTriangles) >= 1)
                return true;
        }
        return false;
    }

    // The most dB of what keeps the pace.
    double best_db() const
    {
        double best = -1e9;
        for (const Trial& trial : trials_)
            for (size_t k = 0; k < kWayCount; ++k)
                if (trial.share[k] >= 1) best = std::max(best, trial.psnr_db[k]);
        return best;
    }

    // Between two meshes, of which the larger is too slow, lies one that just keeps the pace: by the way of drawing
    // that promises most, and again between those that are known then.
    void refine()
    {
        for (int k = 0; k < kMostRefined; ++k) {
            const uint32_t triangles = between_trials();
            if (triangles == 0 || !try_mesh(triangles)) return;
        }
    }

    uint32_t between_trials()
    {
        constexpr double kNear = 0.01;  // of the pace
        std::sort(trials_.begin(), trials_.end(),
                  [](const Trial& a, const Trial& b) { return a.plan.settings.triangles > b.plan.settings.triangles; });
        double most_db = best_db();
        uint32_t triangles = 0;
        for (size_t n = 0; n + 1 < trials_.size(); ++n) {
            const Trial &slow = trials_[n], &fast = trials_[n + 1];
            for (size_t k = 0; k < kWayCount; ++k) {
                const double from = slow.share[k], to = fast.share[k];
                if (from <= 0 || from >= 1 || to < 1 + 2 * kNear || slow.psnr_db[k] <= most_db) continue;
                most_db = slow.psnr_db[k];
                const double time = 1 / (1 + kNear), part = (1 / from - time) / (1 / from - 1 / to);
                triangles =
                    static_cast<uint32_t>(triangles_of(slow) + part * (triangles_of(fast) - triangles_of(slow)));
            }
        }
        return triangles;
    }

    static PacedField field_of(const Trial& trial, size_t k)
    {
        PacedField field = {trial.plan, kWays[k].mode, trial.psnr_db[k], trial.rate[k], trial.share[k]};
        field.plan.settings.view_tables &= kWays[k].view_tables;
        return field;
    }

    // Texels take the bytes of view tables that it does without.
    void plan_without_tables(baker::SurfacePlan& plan) const
    {
        baker::SurfaceLimits limits = limits_;
        limits.chooses_triangles = limits.chooses_edge = false;
        plan = baker::plan_surface(scene_, plan.settings, limits, progress_);
    }

    // The best that keeps the pace, else the fastest.
    PacePlan chosen() const
    {
        struct Point {
            const Trial* trial;
            size_t way;
            double share() const { return trial->share[way]; }
            double psnr_db() const { return trial->psnr_db[way]; }
        };
        std::vector<Point> points;
        for (const Trial& trial : trials_)
            for (size_t k = 0; k < kWayCount; ++k)
                if (trial.share[k] > 0 && trial.share[k] < 1e9) points.push_back({&trial, k});
        if (points.empty()) throw baker::BakeError("no mesh that was tried fits the RAM of the part");
        const auto best = [&](auto takes, auto is_better) {
            std::optional<Point> found;
            for (const Point& p : points)
                if (takes(p) && (!found || is_better(p, *found))) found = p;
            return found;
        };
        const auto shows_more = [](const Point& a, const Point& b) { return a.psnr_db() > b.psnr_db(); };
        const auto is_faster = [](const Point& a, const Point& b) { return a.share() > b.share(); };
        const auto keeps_pace = best([](const Point& p) { return p.share() >= 1; }, shows_more);
        const Point choice = keeps_pace ? *keeps_pace : *best([](const Point&) { return true; }, is_faster);
        const auto slower = best([&](const Point& p) { return p.psnr_db() > choice.psnr_db(); }, is_faster);
        const auto faster = best([&](const Point& p) { return p.share() > choice.share(); }, shows_more);
        PacePlan plan = {field_of(*choice.trial, choice.way), {}, {}};
        if (!kWays[choice.way].view_tables) plan_without_tables(plan.chosen.plan);
        if (slower) plan.slower = field_of(*slower->trial, slower->way);
        if (faster) plan.faster = field_of(*faster->trial, faster->way);
        return plan;
    }

    const baker::Scene& scene_;
    const baker::SurfacePlan& largest_;
    const baker::SurfaceLimits& limits_;
    const std::vector<planner::Pace>& paces_;
    const host::ScreenSize screen_;
    const baker::ProgressCallback& progress_;
    const quality::QuickMeasure measure_;
    std::vector<Trial> trials_;
};

std::string line_of(const char* head, const PacedField& field)
{
    return formatted("%s%s, %u triangles%s: %.1f frames a second, %.1f dB in a small bake\n", head, name_of(field.mode),
                     field.plan.triangles, field.plan.settings.view_tables ? "" : " without view tables",
                     field.frames_per_second, field.psnr_db);
}

}  // namespace

PacePlan plan_for_pace(const baker::Scene& scene, const baker::SurfacePlan& largest, const baker::SurfaceLimits& limits,
                       const std::vector<planner::Pace>& paces, const host::ScreenSize& screen,
                       const baker::ProgressCallback& progress)
{
    return PacePlanner(scene, largest, limits, paces, screen, progress).plan();
}

std::string text_of(const PacePlan& plan, const planner::Pace& first)
{
    std::string text = line_of(formatted("%s%s at %g frames a second: ", first.chip->title,
                                         first.cores == 2 ? ", both cores," : "", first.frames_per_second)
                                   .c_str(),
                               plan.chosen);
    if (plan.chosen.share < 1) text += "  nothing that was tried is as fast\n";
    if (plan.slower) text += line_of("  shows more: ", *plan.slower);
    if (plan.faster) text += line_of("  is faster: ", *plan.faster);
    return text;
}

}  // namespace lumi::tools
