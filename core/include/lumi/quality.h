// SPDX-License-Identifier: MIT
// Holds a frame rate: chooses the mode of the next frame from how long the last one took.
//
//     QualityControl<SurfaceMode> control({33333});    // microseconds a frame
//     const FrameQuality<SurfaceMode> frame = control.next(last_us, is_moving);
//     if (frame.draws) view.look(orbit, frame.mode);
//
// While the object moves, quality goes down a mode as soon as a frame takes longer than its budget, and up again where
// there is room. Once it rests, every call refines it until the finest mode has been drawn; then there is nothing to
// draw. A pure function of its inputs: equal calls give equal answers, on every core.
#pragma once
#pragma GCC system_header

#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi
{

enum class SurfaceMode : uint8_t;  // the modes of surface fields: surface/frame.h

// The modes of chord fields. Each costs more than the one before.
enum class QualityStep : uint8_t {
    one_tap,  // Nearest by spans of 16
    spans16,  // the firmware's reconstruction from here on
    spans8,
    spans4,
    spans2,
    exact,
};

// Returns the span of render_spans() and of a view's look(); 1 stands for render().
constexpr int32_t span_px_of(QualityStep step)
{
    return step <= QualityStep::spans16 ? 16 : 32 >> static_cast<int32_t>(step);
}

}  // namespace lumi

namespace lumi::detail
{

// Modes of a kind, as numbers from coarse to fine: where control begins, the finest that moves, the coarsest and the
// finest at rest; and what a mode costs at most, in sixteenths of the one before (docs/log/tradeoff.md, with a margin).
template <class Mode>
struct QualityModes;

template <>
struct QualityModes<SurfaceMode> {
    static constexpr uint8_t kFirst = 1, kFinestMoving = 2, kCoarsestResting = 0, kFinestResting = 2;
    static constexpr uint8_t kGrowth_q4[] = {16, 27, 33};
};

// Spans of 4 look like exact pixels. From one tap to the firmware's reconstruction the growth is that of 3×3; where a
// reconstruction costs more, a raise fails and is tried ever more seldom.
template <>
struct QualityModes<QualityStep> {
    static constexpr uint8_t kFirst = 1, kFinestMoving = 3, kCoarsestResting = 1, kFinestResting = 5;
    static constexpr uint8_t kGrowth_q4[] = {16, 34, 20, 22, 28, 250};
};

struct LadderLimits {
    uint32_t budget;
    const uint8_t* growth_q4;  // that of step 0 is not read
    uint8_t coarsest, finest_moving;
    uint8_t coarsest_resting, finest_resting;
    uint8_t first;  // where control begins, or at the limit next to it
};

// Chooses steps of any renderer whose pictures come from coarse to fine.
class QualityLadder
{
public:
    explicit QualityLadder(const LadderLimits& limits);

    // QualityControl::next says what it takes and returns.
    bool next(uint32_t last_frame, bool moving);
    uint8_t step() const { return resting_ ? refined_ : moving_; }

private:
    bool has_room_above(uint32_t last_frame) const;
    void adapt(uint32_t last_frame);
    void refine();

    LadderLimits limits_;
    uint8_t moving_, refined_;
    bool resting_ = false, measured_ = false, finished_ = false;
    uint32_t roomy_frames_ = 0;      // frames in a row with room for a finer step
    uint32_t patience_;              // how many of them it takes
    uint32_t since_raised_ = kLong;  // frames since the last raise

    static constexpr uint32_t kLong = 1u << 20;
};

}  // namespace lumi::detail

namespace lumi
{

// No mode may be finer than that of the view (SurfaceDrawing's kFinest, antialiased by default): View::look refuses it.
template <class Mode>
struct QualityLimits {
    uint32_t budget;  // what a frame may take, in any unit: that of next()'s `last_frame`. Below 2^29.
    Mode coarsest = Mode{};
    Mode finest_moving = static_cast<Mode>(detail::QualityModes<Mode>::kFinestMoving);
    Mode finest_resting = static_cast<Mode>(detail::QualityModes<Mode>::kFinestResting);  // at least finest_moving
};

// Says how to draw a frame.
template <class Mode>
struct FrameQuality {
    bool draws;  // false: the finest picture is on the display already
    Mode mode;
};

}  // namespace lumi

namespace lumi::detail
{

template <class Mode>
constexpr LadderLimits ladder_limits(const QualityLimits<Mode>& limits)
{
    using Modes = QualityModes<Mode>;
    const auto number = [](Mode mode) { return static_cast<uint8_t>(mode); };
    return {limits.budget,
            Modes::kGrowth_q4,
            number(limits.coarsest),
            number(limits.finest_moving),
            Modes::kCoarsestResting,
            number(limits.finest_resting),
            Modes::kFirst};
}

}  // namespace lumi::detail

namespace lumi
{

// `Mode` is SurfaceMode or QualityStep.
template <class Mode>
class QualityControl
{
public:
    // Begins antialiased, at spans of 16, or at the limit next to it.
    explicit QualityControl(const QualityLimits<Mode>& limits) : ladder_(detail::ladder_limits(limits)) {}

    // Chooses what to draw now. `last_frame` is what drawing the last answer took (of the first call and where nothing
    // was drawn, anything); `moving`: whether the view differs from the last one. Costs some tens of instructions.
    FrameQuality<Mode> next(uint32_t last_frame, bool moving)
    {
        const bool draws = ladder_.next(last_frame, moving);
        return {draws, static_cast<Mode>(ladder_.step())};
    }

private:
    detail::QualityLadder ladder_;
};

}  // namespace lumi
