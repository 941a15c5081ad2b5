// SPDX-License-Identifier: MIT
#include "planner/fit.h"

#include <algorithm>
#include <cmath>

#include "lumi/lattice.h"

namespace lumi::planner
{

namespace
{

// A plan's size as one number that grows with its bytes: 1 .. largest.
struct Scale {
    uint32_t smallest, largest;
    double power;  // bytes grow about as the size to this power
    std::function<Plan(uint32_t)> at;
};

class Fitter
{
public:
    Fitter(const Scale& scale, uint64_t budget, const BytesOf& bytes_of, double slack)
        : scale_(scale), budget_(static_cast<double>(budget)), bytes_of_(bytes_of), enough_((1 - slack) * budget_)
    {
    }

    Fit run()
    {
        Fit fit;
        fit.plan = scale_.at(scale_.smallest);
        fit.bytes = bytes_of_(fit.plan);  // what is wrong with the smallest is wrong with all
        if (static_cast<double>(fit.bytes) > budget_) {
            fit.note = "does not fit";
            return fit;
        }
        fit.fits = true;
        base_ = static_cast<double>(fit.bytes);
        grow(fit);
        return fit;
    }

private:
    // Narrows down (low, high): low fits, high does not. Each guess puts the growth seen so far through the budget.
    void grow(Fit& fit)
    {
        uint32_t low = scale_.smallest, high = scale_.largest + 1;
        uint32_t guess = std::min(high - 1, 8 * low);
        while (high - low > 1 && static_cast<double>(fit.bytes) < enough_) {
            guess = std::clamp(guess, low + 1, high - 1);
            const double bytes = bytes_at(guess);
            if (bytes <= budget_) {
                low = guess;
                fit.bytes = static_cast<uint64_t>(bytes);
            } else {
                high = guess;
            }
            guess = std::isinf(bytes) ? (low + high) / 2 : size_for(guess, bytes);
        }
        fit.plan = scale_.at(low);
    }

    double bytes_at(uint32_t size) const
    {
        try {
            return static_cast<double>(bytes_of_(scale_.at(size)));
        } catch (const baker::BakeError&) {
            return INFINITY;  // larger than the format holds
        }
    }

    double grown(uint32_t size) const { return std::pow(size, scale_.power) - std::pow(scale_.smallest, scale_.power); }

    uint32_t size_for(uint32_t known, double bytes) const
    {
        constexpr double kAim = 0.5;  // of the slack: misses on either side are then as far away
        const double growth = std::max(1e-9, (bytes - base_) / grown(known));
        const double aim = kAim * enough_ + (1 - kAim) * budget_;
        const double power = (aim - base_) / growth + std::pow(scale_.smallest, scale_.power);
        return static_cast<uint32_t>(std::clamp(std::pow(power, 1 / scale_.power), 1.0, 1.0 * scale_.largest));
    }

    const Scale& scale_;
    const double budget_;
    const BytesOf& bytes_of_;
    const double enough_;
    double base_ = 0;
};

Fit as_it_is(const Task& task, const Plan& plan, const BytesOf& bytes_of)
{
    Fit fit = {false, plan, bytes_of(plan), ""};
    fit.fits = fit.bytes <= task.budget_bytes;
    if (!fit.fits) fit.note = "does not fit";
    return fit;
}

Fit fit_chord(const Task& task, const Plan& plan, const BytesOf& bytes_of, double slack)
{
    const ByHand& set = task.by_hand;
    if (set.origins && set.directions) return as_it_is(task, plan, bytes_of);
    const double shape = static_cast<double>(plan.chord.directions) / plan.chord.origins;
    const double used = static_cast<double>(plan.chord.used_origins) / plan.chord.origins;
    const auto at = [&](uint32_t size) {
        Plan sized = plan;
        baker::BakeSettings& s = sized.chord;
        s.origins = set.origins.value_or(size);
        s.directions = set.directions.value_or(
            set.origins ? size : std::clamp(static_cast<uint32_t>(std::lround(size * shape)), 1u, kMaxLatticeSize));
        s.used_origins = set.cap ? set.cap(s.origins) : static_cast<uint32_t>(std::ceil(s.origins * used));
        return sized;
    };
    const Scale scale = {1, kMaxLatticeSize, set.origins || set.directions ? 1.0 : 2.0, at};
    return Fitter(scale, task.budget_bytes, bytes_of, slack).run();
}

}  // namespace

Fit fit_plan(const Task& task, const Plan& plan, const BytesOf& bytes_of, double slack)
{
    try {
        return fit_chord(task, plan, bytes_of, slack);
    } catch (const baker::BakeError& error) {
        return {false, plan, 0, error.what()};
    }
}

}  // namespace lumi::planner
