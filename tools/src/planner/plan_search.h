// SPDX-License-Identifier: MIT
// Looks for the best of many plans by trying few: every trial costs seconds, so it walks from a good start, one
// coordinate at a time, and never tries a plan twice. It knows nothing of fields; what a plan means, the trial knows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lumi::planner
{

// A coordinate of a plan: a list of choices. One choice alone is one that the search may not touch.
struct Coordinate {
    std::string name;
    std::vector<std::string> choices;  // as people read them, at least one
    size_t start = 0;
    bool ordered = true;  // the neighbours of a choice are those beside it in the list; otherwise all others
};

// Plans of one kind, with the coordinates that this kind has.
struct Family {
    std::string name;
    std::vector<Coordinate> coordinates;  // what decides most comes first
};

// A plan: a place in each of its family's lists.
struct Candidate {
    size_t family = 0;
    std::vector<size_t> choice;
};
bool operator==(const Candidate& a, const Candidate& b);

// What a trial has found. A plan that does not work tells how many bytes it would have needed, if it knows: that leads
// the search towards one that fits.
struct Outcome {
    bool works = false;
    double score_db = 0;
    uint64_t bytes = 0;  // 0: unknown
    std::string note;    // why it does not work; or what else to say of it
};

struct Tried {
    Candidate candidate;
    Outcome outcome;
};

struct SearchSettings {
    size_t max_trials = 40;
    double least_gain_db = 0.06;  // less is noise of the measurement, and no reason to move
    double rival_db = 1;          // families whose start is this close to the best start are searched as well
};

struct SearchResult {
    std::vector<Tried> tried;    // in order
    std::optional<size_t> best;  // of `tried`; nothing works: empty
    bool exhausted = false;      // the search ended with max_trials, not because no neighbour was better
};

// How far a search is: trials done, and how many it takes at least until nothing is left beside the best.
struct SearchProgress {
    size_t done = 0, left = 0;
    const Tried* last = nullptr;  // null before the first
    const Tried* best = nullptr;  // of those that work
};

// Trials report failure by Outcome::works; an exception ends the search and passes through.
using Trial = std::function<Outcome(const Candidate&)>;
using SearchReport = std::function<void(const SearchProgress&)>;

// Tries the start of every family, then walks from the best of them, and from its rivals, to where no neighbour is
// better. Precondition: choice lists are not empty, starts lie within them.
SearchResult search(const std::vector<Family>& families, const Trial& trial, const SearchSettings& settings,
                    const SearchReport& report = {});

// The family's plan where every coordinate has its start.
Candidate start_of(const std::vector<Family>& families, size_t family);

// All plans that differ from `candidate` by one step of one coordinate.
std::vector<Candidate> neighbours_of(const std::vector<Family>& families, const Candidate& candidate);

}  // namespace lumi::planner
