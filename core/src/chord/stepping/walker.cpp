// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/walker.h"

#include "chord/stepping/coarse_math.h"
#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

// How many of a span's pixels lie on this side of a height, as far as heights are linear along it: 0 .. length - 1.
int32_t length_before(int32_t limit_z_q30, int32_t from_z_q30, int32_t next_z_q30, int32_t length)
{
    const auto way = [&](int32_t to) { return static_cast<uint32_t>(magnitude((to >> 1) - (from_z_q30 >> 1))) >> 13; };
    const int32_t limit = limit_z_q30;
    const uint32_t whole = way(next_z_q30) + 1;
    const uint32_t part = way(limit) < whole ? way(limit) : whole;
    const int32_t before = static_cast<int32_t>((static_cast<uint32_t>(length) * ratio_q15(part, whole)) >> 15);
    return before < length ? before : length - 1;
}

}  // namespace

void LineWalker::begin(const HitPair& at)
{
    const Hit& hit = at.*track_.hit;
    longitude_q20_ = static_cast<int32_t>(hit.longitude_turns32 >> 12);
    in_plane_ = false;
    if (track_.map.holds(hit.z_q30)) place_ = track_.map.at(longitude_q20_, hit.z_q30 >> 14);
}

int32_t LineWalker::prepare(const HitPair& at_pixel, const HitPair& next_pixel, int32_t length)
{
    LUMI_TALLY(Work::span_side, 1);
    const Hit& at = at_pixel.*track_.hit;
    const Hit& next = next_pixel.*track_.hit;
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - at.longitude_turns32) >> 12;
    next_longitude_q20_ = longitude_q20_ + turn_q20;
    ZoneMap& map = track_.map;
    CellLine& line = track_.line.cells;
    if (!map.holds(at.z_q30)) {
        const int32_t height = magnitude(at.z_q30);
        const int32_t polar_z_q30 = map.zones().polar_z_q30;
        if (height > polar_z_q30) {
            if (is_over_pole(at, next)) return prepare_polar(at_pixel, next_pixel, length);
            return length_before(polar_z_q30, height, magnitude(next.z_q30), length);
        }
        map.choose(at.z_q30, line);
        in_plane_ = false;
        place_ = map.at(longitude_q20_, at.z_q30 >> 14);
    }
    if (!map.reaches(next.z_q30)) {
        if (is_over_pole(at, next)) return prepare_polar(at_pixel, next_pixel, length);
        const int32_t limit = next.z_q30 < map.lowest_z_q30() ? map.lowest_z_q30() : map.highest_z_q30();
        return length_before(limit, at.z_q30, next.z_q30, length);
    }
    if (magnitude(turn_q20) > kMaxTurnQ20) return magnitude(turn_q20) > 2 * kMaxTurnQ20 ? length >> 2 : length >> 1;
    next_place_ = map.at(next_longitude_q20_, next.z_q30 >> 14);
    const int32_t u_q16 = next_place_.u_q16 - place_.u_q16;
    const int32_t v_q16 = next_place_.v_q16 - place_.v_q16;
    if (!is_steppable(u_q16) || !is_steppable(v_q16)) return length >> 1;
    line.u_q16 = place_.u_q16;
    line.v_q16 = place_.v_q16;
    line.du_q16 = step_of(u_q16, length);
    line.dv_q16 = step_of(v_q16, length);
    line.uniform = map.is_uniform_at(at.z_q30) && map.is_uniform_at(next.z_q30);
    track_.line.over_pole = false;
    z_q30_ = at.z_q30;
    next_z_q30_ = next.z_q30;
    return length;
}

void LineWalker::shift(int32_t share_q8)
{
    if (track_.line.over_pole) return;
    // A share is below an eighth of the span's length: it changes heights by less than an eighth of what the span does.
    const ZoneMap& map = track_.map;
    const int32_t z_q29 = z_q30_ >> 1;
    const int32_t next_z_q29 = next_z_q30_ >> 1;
    const int32_t reach = magnitude(next_z_q29 - z_q29) >> 3;
    const int32_t lowest = (z_q29 < next_z_q29 ? z_q29 : next_z_q29) - reach;
    const int32_t highest = (z_q29 < next_z_q29 ? next_z_q29 : z_q29) + reach;
    if (lowest <= map.lowest_z_q30() >> 1 || highest >= map.highest_z_q30() >> 1) return;
    CellLine& line = track_.line.cells;
    line.u_q16 += (line.du_q16 * share_q8) >> 8;
    line.v_q16 += (line.dv_q16 * share_q8) >> 8;
}

// Whether the polar pattern holds both hits.
bool LineWalker::is_over_pole(const Hit& at, const Hit& next) const
{
    const int32_t polar = track_.map.zones().polar_z_q30;
    return at.z_q30 >= polar ? next.z_q30 >= polar : at.z_q30 <= -polar && next.z_q30 <= -polar;
}

int32_t LineWalker::prepare_polar(const HitPair& at, const HitPair& next, int32_t length)
{
    LUMI_TALLY(Work::polar_side, 1);
    const bool mirrored = (at.*track_.hit).z_q30 < 0;
    if (!in_plane_) {
        track_.enter_pole(mirrored);
        place_ = track_.in_plane(at, mirrored);
        in_plane_ = true;
    }
    next_place_ = track_.in_plane(next, mirrored);
    track_.line.over_pole = true;
    track_.set_polar(
        place_, {step_of(next_place_.u_q16 - place_.u_q16, length), step_of(next_place_.v_q16 - place_.v_q16, length)});
    return length;
}

}  // namespace lumi::detail
