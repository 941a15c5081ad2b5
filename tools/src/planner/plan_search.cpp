// SPDX-License-Identifier: MIT
#include "planner/plan_search.h"

#include <algorithm>

namespace lumi::planner
{

namespace
{

// Whether `a` is a better place to go on from than `b`: one that works before one that does not, then the higher score.
// Among those that do not work, the smaller is nearer to fitting.
bool is_better(const Outcome& a, const Outcome& b, double least_gain_db)
{
    if (a.works != b.works) return a.works;
    if (a.works) return a.score_db > b.score_db + least_gain_db;
    if (a.bytes == 0 || b.bytes == 0) return a.bytes > b.bytes;
    return a.bytes < b.bytes;
}

class Search
{
public:
    Search(const std::vector<Family>& families, const Trial& trial, const SearchSettings& settings,
           const SearchReport& report)
        : families_(families), trial_(trial), settings_(settings), report_(report)
    {
    }

    SearchResult run()
    {
        tell(0);
        for (size_t f = 0; f < families_.size(); ++f) measured(start_of(families_, f));
        for (const Candidate& start : starts_worth_walking_from()) walk(start);
        return std::move(result_);
    }

private:
    // The best start, and what comes close to it, best first.
    std::vector<Candidate> starts_worth_walking_from() const
    {
        std::vector<Tried> starts = result_.tried;
        std::stable_sort(starts.begin(), starts.end(),
                         [](const Tried& a, const Tried& b) { return is_better(a.outcome, b.outcome, 0); });
        std::vector<Candidate> worth;
        for (const Tried& start : starts) {
            const Outcome& best = starts.front().outcome;
            const bool close = start.outcome.works && start.outcome.score_db >= best.score_db - settings_.rival_db;
            if (!best.works || close) worth.push_back(start.candidate);
        }
        return worth;
    }

    void walk(const Candidate& start)
    {
        Candidate here = start;
        const size_t coordinates = families_[start.family].coordinates.size();
        // Ends after as many coordinates in a row as there are, none of which has led further.
        for (size_t c = 0, settled = 0; settled < coordinates && !result_.exhausted; c = (c + 1) % coordinates)
            settled = moves_along(c, here) ? 1 : settled + 1;
    }

    // Walks along one coordinate as far as it gets better; whether it has moved.
    bool moves_along(size_t c, Candidate& here)
    {
        const Coordinate& coordinate = families_[here.family].coordinates[c];
        if (!coordinate.ordered) return moves_to_best(c, here);
        const size_t from = here.choice[c];
        while (steps(c, +1, here)) {
        }
        if (here.choice[c] == from)
            while (steps(c, -1, here)) {
            }
        return here.choice[c] != from;
    }

    bool steps(size_t c, int step, Candidate& here)
    {
        const size_t last = families_[here.family].coordinates[c].choices.size() - 1;
        if (here.choice[c] == (step > 0 ? last : 0)) return false;
        Candidate next = here;
        next.choice[c] = step > 0 ? here.choice[c] + 1 : here.choice[c] - 1;
        return goes_to(next, here);
    }

    bool moves_to_best(size_t c, Candidate& here)
    {
        const size_t from = here.choice[c];
        for (size_t choice = 0; choice < families_[here.family].coordinates[c].choices.size(); ++choice) {
            if (choice == here.choice[c]) continue;
            Candidate next = here;
            next.choice[c] = choice;
            goes_to(next, here);
        }
        return here.choice[c] != from;
    }

    bool goes_to(const Candidate& next, Candidate& here)
    {
        const std::optional<Outcome> now = measured(here), then = measured(next);
        if (!now || !then || !is_better(*then, *now, settings_.least_gain_db)) return false;
        here = next;
        return true;
    }

    // By a trial, unless there was one; nothing once all trials are spent.
    std::optional<Outcome> measured(const Candidate& candidate)
    {
        const auto known = std::find_if(result_.tried.begin(), result_.tried.end(),
                                        [&](const Tried& tried) { return tried.candidate == candidate; });
        if (known != result_.tried.end()) return known->outcome;
        if (result_.tried.size() >= settings_.max_trials) {
            result_.exhausted = true;
            return std::nullopt;
        }
        result_.tried.push_back({candidate, trial_(candidate)});
        note_best();
        tell(result_.tried.size());
        return result_.tried.back().outcome;
    }

    void note_best()
    {
        const Outcome& last = result_.tried.back().outcome;
        const bool first = !result_.best && last.works;
        if (first || (last.works && is_better(last, result_.tried[*result_.best].outcome, settings_.least_gain_db)))
            result_.best = result_.tried.size() - 1;
    }

    void tell(size_t done) const
    {
        if (!report_) return;
        SearchProgress progress = {done, left(), nullptr, nullptr};
        if (done > 0) progress.last = &result_.tried.back();
        if (result_.best) progress.best = &result_.tried[*result_.best];
        report_(progress);
    }

    size_t left() const
    {
        const auto is_new = [&](const Candidate& candidate) {
            return std::none_of(result_.tried.begin(), result_.tried.end(),
                                [&](const Tried& tried) { return tried.candidate == candidate; });
        };
        size_t count = 0;
        for (size_t f = 0; f < families_.size(); ++f) count += is_new(start_of(families_, f)) ? 1u : 0u;
        const Candidate centre = result_.best ? result_.tried[*result_.best].candidate : start_of(families_, 0);
        const std::vector<Candidate> beside = neighbours_of(families_, centre);
        count += static_cast<size_t>(std::count_if(beside.begin(), beside.end(), is_new));
        return std::min(count, settings_.max_trials - result_.tried.size());
    }

    const std::vector<Family>& families_;
    const Trial& trial_;
    const SearchSettings& settings_;
    const SearchReport& report_;
    SearchResult result_;
};

}  // namespace

bool operator==(const Candidate& a, const Candidate& b)
{
    return a.family == b.family && a.choice == b.choice;
}

Candidate start_of(const std::vector<Family>& families, size_t family)
{
    Candidate start = {family, {}};
    for (const Coordinate& coordinate : families[family].coordinates) start.choice.push_back(coordinate.start);
    return start;
}

std::vector<Candidate> neighbours_of(const std::vector<Family>& families, const Candidate& candidate)
{
    std::vector<Candidate> all;
    const auto& coordinates = families[candidate.family].coordinates;
    for (size_t c = 0; c < coordinates.size(); ++c)
        for (size_t choice = 0; choice < coordinates[c].choices.size(); ++choice) {
            const size_t here = candidate.choice[c];
            const bool beside = choice + 1 == here || choice == here + 1;
            if (choice == here || (coordinates[c].ordered && !beside)) continue;
            all.push_back(candidate);
            all.back().choice[c] = choice;
        }
    return all;
}

SearchResult search(const std::vector<Family>& families, const Trial& trial, const SearchSettings& settings,
                    const SearchReport& report)
{
    return Search(families, trial, settings, report).run();
}

}  // namespace lumi::planner
