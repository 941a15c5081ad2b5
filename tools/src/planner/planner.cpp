// SPDX-License-Identifier: MIT
#include "planner/planner.h"

#include <algorithm>
#include <chrono>

#include "terminal/text.h"

namespace lumi::planner
{

namespace
{

using Clock = std::chrono::steady_clock;

// What a candidate has that the best one has not; empty if they differ in more than one thing.
std::string difference(const std::vector<Family>& families, const Candidate& candidate, const Candidate& best)
{
    const Family& family = families[candidate.family];
    std::string what;
    for (size_t c = 0; c < family.coordinates.size(); ++c) {
        if (candidate.choice[c] == best.choice[c]) continue;
        if (!what.empty()) return "";
        what = family.coordinates[c].name + " " + family.coordinates[c].choices[candidate.choice[c]];
    }
    return what;
}

class Planner
{
public:
    Planner(const baker::Scene& scene, const Task& task, const PlanSettings& settings,
            const baker::ProgressCallback& progress, const PlanReport& report)
        : task_(task),
          settings_(settings),
          progress_(progress),
          report_(report),
          families_(families_of(task)),
          measurer_(scene, task, settings.measure, progress)
    {
    }

    Result run()
    {
        const Clock::time_point start = Clock::now();
        const Trial trial = [this](const Candidate& candidate) { return outcome(candidate); };
        const SearchResult found = search(families_, trial, settings_.search,
                                          [&](const SearchProgress& at) { tell(found_so_far(at, start)); });
        if (!found.best) throw NoPlan(why_none());
        Result result;
        result.task = task_;
        result.settings = settings_.measure;
        result.exhausted = found.exhausted;
        result.best = tried_[*found.best];
        result.tried = tried_;
        result.alternatives = alternatives(found);
        if (settings_.outlook) {
            const Candidate& best = found.tried[*found.best].candidate;
            result.half = best_with(best, task_.budget_bytes / 2);
            result.twice = best_with(best, task_.budget_bytes * 2);
        }
        result.seconds = seconds_since(start);
        return result;
    }

private:
    static double seconds_since(Clock::time_point start)
    {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    Measurement measured(const Task& task, const Candidate& candidate)
    {
        const std::vector<Family> families = families_of(task);
        Plan plan;
        try {
            plan = plan_of(task, families, candidate);
        } catch (const baker::BakeError& error) {
            Measurement failed;
            failed.note = error.what();
            return failed;
        }
        return measurer_.measure(task, plan, progress_);
    }

    Outcome outcome(const Candidate& candidate)
    {
        tried_.push_back(measured(task_, candidate));
        const Measurement& m = tried_.back();
        return {m.works, m.psnr_db, m.bytes, m.note};
    }

    PlanProgress found_so_far(const SearchProgress& at, Clock::time_point start) const
    {
        PlanProgress progress = {at.done, at.left, seconds_since(start), -1, nullptr, nullptr};
        if (at.done > 0) {
            progress.eta_seconds =
                progress.elapsed_seconds / static_cast<double>(at.done) * static_cast<double>(at.left);
            progress.last = &tried_.back();
        }
        // Both lists have the same order.
        if (at.best != nullptr) progress.best = &tried_.back() - (at.last - at.best);
        return progress;
    }

    void tell(const PlanProgress& progress) const
    {
        if (report_) report_(progress);
    }

    std::vector<Alternative> alternatives(const SearchResult& found) const
    {
        const Candidate& best = found.tried[*found.best].candidate;
        const double best_db = found.tried[*found.best].outcome.score_db;
        std::vector<Alternative> all;
        for (size_t t = 0; t < found.tried.size(); ++t) {
            const std::string what = t == *found.best ? "" : difference(families_, found.tried[t].candidate, best);
            if (!what.empty()) all.push_back({what, tried_[t], found.tried[t].outcome.score_db - best_db});
        }
        return all;
    }

    // The better of the best plan resized, and of the plan that a search at that budget starts from.
    std::optional<Measurement> best_with(const Candidate& best, uint64_t budget)
    {
        Task task = task_;
        task.budget_bytes = budget;
        std::optional<Measurement> chosen;
        for (const Candidate& candidate : {best, start_of(families_of(task), best.family)}) {
            const Measurement m = measured(task, candidate);
            if (m.works && (!chosen || m.psnr_db > chosen->psnr_db)) chosen = m;
        }
        return chosen;
    }

    std::string why_none() const
    {
        uint64_t smallest = 0;
        bool fits = false;
        for (const Measurement& m : tried_) {
            fits = fits || (m.bytes > 0 && m.bytes <= task_.budget_bytes);
            if (m.bytes > 0 && (smallest == 0 || m.bytes < smallest)) smallest = m.bytes;
        }
        if (fits || smallest == 0) {
            std::string why = "no plan works";
            for (const Measurement& m : tried_)
                if (!m.note.empty() && m.note != "does not fit") return why + ": " + m.note;
            return why;
        }
        return "nothing fits into " + tools::byte_text(task_.budget_bytes) + "; the smallest that works takes " +
               std::to_string(smallest) + " bytes";
    }

    const Task task_;
    const PlanSettings settings_;
    const baker::ProgressCallback& progress_;
    const PlanReport& report_;
    const std::vector<Family> families_;
    Measurer measurer_;
    std::vector<Measurement> tried_;
};

}  // namespace

Result plan_field(const baker::Scene& scene, const Task& task, const PlanSettings& settings,
                  const baker::ProgressCallback& progress, const PlanReport& report)
{
    return Planner(scene, task, settings, progress, report).run();
}

Plan final_plan(const Result& result)
{
    const BytesOf bytes_of = [](const Plan& plan) { return baker::field_file_bytes(plan.chord); };
    const Fit fit = fit_plan(result.task, result.best.plan, bytes_of, 0);
    if (!fit.fits) throw NoPlan("the plan does not fit after all: " + fit.note);
    return fit.plan;
}

}  // namespace lumi::planner
