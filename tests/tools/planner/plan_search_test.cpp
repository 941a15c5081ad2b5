// SPDX-License-Identifier: MIT
// The planner's search, on landscapes whose best plan is known.
#include "planner/plan_search.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <stdexcept>

namespace lumi::planner
{

namespace
{

Coordinate numbers(const std::string& name, size_t count, size_t start)
{
    Coordinate coordinate = {name, {}, start, true};
    for (size_t k = 0; k < count; ++k) coordinate.choices.push_back(std::to_string(k));
    return coordinate;
}

Coordinate words(const std::string& name, size_t count)
{
    Coordinate coordinate = numbers(name, count, 0);
    coordinate.ordered = false;
    return coordinate;
}

std::vector<Family> surface_families()
{
    return {{"surface", {numbers("origins", 9, 2), numbers("mean", 7, 3), numbers("mesh", 5, 1), words("format", 2)}},
            {"chord", {numbers("ratio", 3, 1), words("texel", 3)}}};
}

double number_of(const Candidate& candidate, size_t c)
{
    return static_cast<double>(candidate.choice[c]);
}

// What flash does: each part wants more of it, and what one part takes another one lacks. The best place depends on
// all coordinates together.
Outcome landscape(const Candidate& candidate, double flash)
{
    if (candidate.family == 1) return {true, 20 + 0.4 * number_of(candidate, 1), 100, ""};
    const double origins = std::exp2(number_of(candidate, 0) / 2), mean = std::exp2(number_of(candidate, 1) / 2);
    const double mesh = std::exp2(number_of(candidate, 2)), colour = number_of(candidate, 3);
    const double parts = 2 * mean * mean / (1 + colour) + 3 * mesh;
    const double charts = (flash - parts) / origins;
    if (charts < 1) return {false, 0, static_cast<uint64_t>(parts + origins), "does not fit"};
    const double error = 1 / origins + 1.5 / mean + 2 / charts + 0.3 / mesh + 0.05 * colour;
    return {true, 34 - 8 * error, static_cast<uint64_t>(flash), ""};
}

std::vector<Candidate> all_of(const std::vector<Family>& families)
{
    std::vector<Candidate> all;
    for (size_t f = 0; f < families.size(); ++f) {
        std::vector<Candidate> grown = {{f, {}}};
        for (const Coordinate& coordinate : families[f].coordinates) {
            std::vector<Candidate> longer;
            for (const Candidate& candidate : grown)
                for (size_t choice = 0; choice < coordinate.choices.size(); ++choice) {
                    longer.push_back(candidate);
                    longer.back().choice.push_back(choice);
                }
            grown = longer;
        }
        all.insert(all.end(), grown.begin(), grown.end());
    }
    return all;
}

double best_of_sweep(const std::vector<Family>& families, double flash)
{
    double best = -1;
    for (const Candidate& candidate : all_of(families)) {
        const Outcome outcome = landscape(candidate, flash);
        if (outcome.works) best = std::max(best, outcome.score_db);
    }
    return best;
}

}  // namespace

TEST_CASE("a search finds a plan within 0.3 dB of the best of a full sweep, at any budget, by a tenth of its trials")
{
    const auto families = surface_families();
    for (const double flash : {20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0}) {
        const auto result =
            search(families, [&](const Candidate& candidate) { return landscape(candidate, flash); }, {60, 0.03, 1});
        REQUIRE(result.best);
        INFO("flash " << flash << ", trials " << result.tried.size());
        CHECK(result.tried[*result.best].outcome.score_db >= best_of_sweep(families, flash) - 0.3);
        CHECK(result.tried.size() <= all_of(families).size() / 10);
        CHECK_FALSE(result.exhausted);
    }
}

TEST_CASE("a search takes the other family where it is better")
{
    const auto result =
        search(surface_families(),
               [](const Candidate& candidate) {
                   return Outcome{true, candidate.family == 1 ? 22 + number_of(candidate, 0) : 19.0, 1, ""};
               },
               {});
    REQUIRE(result.best);
    CHECK(result.tried[*result.best].candidate.family == 1);
    CHECK(result.tried[*result.best].candidate.choice[0] == 2);
}

TEST_CASE("a rival that starts a little lower and ends higher wins")
{
    const auto result =
        search(surface_families(),
               [](const Candidate& candidate) {
                   return Outcome{true, candidate.family == 1 ? 24.5 + 2 * number_of(candidate, 1) : 25.0, 1, ""};
               },
               {});
    CHECK(result.tried[*result.best].candidate.family == 1);
}

TEST_CASE("no plan is tried twice, and a coordinate of one choice stays")
{
    auto families = surface_families();
    families[0].coordinates[1] = {"mean", {"64"}, 0, true};
    std::set<std::pair<size_t, std::vector<size_t>>> seen;
    const auto result = search(families,
                               [&](const Candidate& candidate) {
                                   CHECK(seen.insert({candidate.family, candidate.choice}).second);
                                   if (candidate.family == 0) {
                                       CHECK(candidate.choice[1] == 0);
                                   }
                                   return landscape(candidate, 320);
                               },
                               {});
    CHECK(result.tried.size() == seen.size());
}

TEST_CASE("a search whose start does not fit walks towards what does")
{
    auto families = surface_families();
    families.pop_back();
    for (Coordinate& coordinate : families[0].coordinates) coordinate.start = coordinate.choices.size() - 1;
    const auto result =
        search(families, [](const Candidate& candidate) { return landscape(candidate, 30); }, {100, 0.03, 1});
    REQUIRE(result.best);
    CHECK(result.tried[*result.best].outcome.score_db >= best_of_sweep(families, 30) - 0.3);
}

TEST_CASE("where nothing fits, the trials tell the smallest size")
{
    auto families = surface_families();
    families.pop_back();
    const auto result = search(families, [](const Candidate& candidate) { return landscape(candidate, 2); }, {});
    CHECK_FALSE(result.best);
    uint64_t smallest = UINT64_MAX;
    for (const Tried& tried : result.tried) smallest = std::min(smallest, tried.outcome.bytes);
    uint64_t smallest_of_all = UINT64_MAX;
    for (const Candidate& candidate : all_of(families))
        smallest_of_all = std::min(smallest_of_all, landscape(candidate, 2).bytes);
    CHECK(smallest == smallest_of_all);
}

TEST_CASE("a trial that fails is told and passed over")
{
    const auto families = surface_families();
    const auto result = search(families,
                               [](const Candidate& candidate) {
                                   if (candidate.family == 0 && candidate.choice[0] == 3)
                                       return Outcome{false, 0, 0, "cannot be baked"};
                                   return landscape(candidate, 320);
                               },
                               {});
    REQUIRE(result.best);
    CHECK(result.tried[*result.best].candidate.choice[0] != 3);
    size_t failed = 0;
    for (const Tried& tried : result.tried) failed += tried.outcome.works ? 0 : 1;
    CHECK(failed > 0);
}

TEST_CASE("a search ends with its trials, says so, and still knows the best of them")
{
    const auto result =
        search(surface_families(), [](const Candidate& candidate) { return landscape(candidate, 1280); }, {5, 0.03, 1});
    CHECK(result.exhausted);
    CHECK(result.tried.size() == 5);
    REQUIRE(result.best);
    for (const Tried& tried : result.tried)
        CHECK(tried.outcome.score_db <= result.tried[*result.best].outcome.score_db + 0.03);
}

TEST_CASE("an exception out of a trial cancels the search at once")
{
    size_t trials = 0;
    const Trial cancelled = [&](const Candidate&) -> Outcome {
        if (++trials == 3) throw std::runtime_error("cancelled");
        return {true, 1, 1, ""};
    };
    CHECK_THROWS_WITH(search(surface_families(), cancelled, {}), "cancelled");
    CHECK(trials == 3);
}

TEST_CASE("progress counts every trial and expects none after the last")
{
    std::vector<size_t> done, left;
    const auto result = search(
        surface_families(), [](const Candidate& candidate) { return landscape(candidate, 320); }, {},
        [&](const SearchProgress& progress) {
            done.push_back(progress.done);
            left.push_back(progress.left);
            CHECK((progress.last != nullptr) == (progress.done > 0));
        });
    REQUIRE(done.size() == result.tried.size() + 1);
    for (size_t k = 0; k < done.size(); ++k) CHECK(done[k] == k);
    CHECK(left.front() > 0);
    CHECK(left.back() == 0);
}

TEST_CASE("scores that differ by noise alone do not move a plan")
{
    const auto families = surface_families();
    const auto result = search(families,
                               [](const Candidate& candidate) {
                                   double noise = 0;
                                   for (const size_t choice : candidate.choice)
                                       noise += 0.001 * static_cast<double>(choice);
                                   return Outcome{true, 25 + noise - 3 * static_cast<double>(candidate.family), 1, ""};
                               },
                               {});
    CHECK(result.tried.size() <= 2 + neighbours_of(families, start_of(families, 0)).size());
}

}  // namespace lumi::planner
