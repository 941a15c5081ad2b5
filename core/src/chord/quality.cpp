// SPDX-License-Identifier: MIT
#include "lumi/chord/quality.h"

namespace lumi
{
namespace
{

using namespace detail;

// What a step costs at most, in sixteenths of the one before: docs/log/tradeoff.md, with a margin. From one tap to the
// product's reconstruction it is that of 3×3; where it costs more, a raise fails and is tried ever more seldom.
constexpr uint8_t kGrowth_q4[] = {16, 34, 34, 20, 22, 28, 250};
constexpr uint8_t number(QualityStep step)
{
    return static_cast<uint8_t>(step);
}

}  // namespace

int32_t detail::span_px_of(QualityStep step)
{
    switch (step) {
        case QualityStep::one_tap_interlaced:
        case QualityStep::one_tap:
        case QualityStep::spans16:
            return 16;
        case QualityStep::spans8:
            return 8;
        case QualityStep::spans4:
            return 4;
        case QualityStep::spans2:
            return 2;
        case QualityStep::exact:
            break;
    }
    return 1;
}

LadderLimits detail::ladder_limits(const QualityLimits& limits)
{
    return {limits.budget,
            kGrowth_q4,
            number(limits.coarsest),
            number(limits.finest_moving),
            number(QualityStep::spans16),
            number(limits.finest_resting),
            number(QualityStep::spans16)};
}

QualityControl::QualityControl(const QualityLimits& limits) : ladder_(ladder_limits(limits)) {}

FrameQuality QualityControl::next(uint32_t last_frame, bool moving)
{
    const bool draws = ladder_.next(last_frame, moving);
    parity_ ^= 1;
    const QualityStep now = step();
    return {draws, now <= QualityStep::one_tap, now == QualityStep::one_tap_interlaced, parity_, span_px_of(now)};
}

}  // namespace lumi
