// SPDX-License-Identifier: MIT
#include "lumi/gesture.h"

namespace lumi
{
namespace
{

using namespace detail;

constexpr int32_t kLongestMs = 1000;
constexpr int64_t kSlowest = degrees(1) / 1000;  // turns32 a millisecond: a degree a second is rest

// Returns 2^-(elapsed / half life), Q16; a parabola between whole powers, right to 0.2 %.
int64_t decay_q16(int32_t elapsed_ms, uint32_t half_life_ms)
{
    const uint32_t elapsed = static_cast<uint32_t>(elapsed_ms);
    if (half_life_ms == 0 || elapsed / half_life_ms >= 16) return 0;
    const uint32_t whole = elapsed / half_life_ms;
    const int64_t f = (int64_t{elapsed - whole * half_life_ms} << 16) / half_life_ms;
    return (65536 - (f * 43691 >> 16) + ((f * f >> 16) * 10923 >> 16)) >> whole;
}

int64_t magnitude_of(int64_t v)
{
    return v < 0 ? -v : v;
}

}  // namespace

void OrbitDrag::turn(int64_t azimuth, int64_t elevation, Orbit& orbit) const
{
    const int64_t limit = settings_.elevation_limit;
    const int64_t raised = static_cast<int32_t>(orbit.elevation_turns32) + elevation;
    orbit.azimuth_turns32 += static_cast<uint32_t>(azimuth);
    orbit.elevation_turns32 = static_cast<uint32_t>(raised < -limit ? -limit : raised > limit ? limit : raised);
}

// The object's front follows the finger: to the right the eye goes to the left, down it goes up.
void OrbitDrag::follow(int32_t x_px, int32_t y_px, int32_t elapsed_ms, Orbit& orbit)
{
    const int64_t azimuth = -int64_t{x_px - x_px_} * settings_.turns32_per_px;
    const int64_t elevation = int64_t{y_px - y_px_} * settings_.turns32_per_px;
    turn(azimuth, elevation, orbit);
    // Keeps the mean of the last frames: panels report a finger in jerks.
    azimuth_speed_ = (azimuth_speed_ + 3 * (azimuth / elapsed_ms)) / 4;
    elevation_speed_ = (elevation_speed_ + 3 * (elevation / elapsed_ms)) / 4;
}

void OrbitDrag::run_on(int32_t elapsed_ms, Orbit& orbit)
{
    const int64_t decay = decay_q16(elapsed_ms, settings_.half_life_ms);
    const auto slower = [&](int64_t speed) { return speed * decay / 65536; };
    const int64_t azimuth = slower(azimuth_speed_), elevation = slower(elevation_speed_);
    turn((azimuth_speed_ + azimuth) * elapsed_ms / 2, (elevation_speed_ + elevation) * elapsed_ms / 2, orbit);
    azimuth_speed_ = azimuth;
    elevation_speed_ = elevation;
}

bool OrbitDrag::next(const Touch& touch, uint32_t elapsed_ms, Orbit& orbit)
{
    const int32_t elapsed = elapsed_ms < 1            ? 1
                            : elapsed_ms > kLongestMs ? kLongestMs
                                                      : static_cast<int32_t>(elapsed_ms);
    if (touch.is_down && was_down_)
        follow(touch.x_px, touch.y_px, elapsed, orbit);
    else if (touch.is_down || settings_.half_life_ms == 0)
        azimuth_speed_ = elevation_speed_ = 0;
    else
        run_on(elapsed, orbit);
    was_down_ = touch.is_down;
    x_px_ = touch.x_px;
    y_px_ = touch.y_px;
    const bool rests = magnitude_of(azimuth_speed_) < kSlowest && magnitude_of(elevation_speed_) < kSlowest;
    if (rests && !touch.is_down) azimuth_speed_ = elevation_speed_ = 0;
    return touch.is_down || !rests;
}

}  // namespace lumi
