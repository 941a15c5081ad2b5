// SPDX-License-Identifier: MIT
// Views of the frame list, an ordinary one and the corners of what a camera may do; and a frame of its chord fields, as
// the list and the files that draw it know it.
#pragma once

#include "frame_list.h"
#include "lumi/camera.h"
#include "lumi/chord/render.h"
#include "text_line.h"

namespace lumi::firmware
{

inline constexpr uint32_t kTurnHundredth = 42949673;  // 2^32 / 100
inline constexpr uint32_t kDegree = 11930465;         // 2^32 / 360
inline constexpr int32_t kQuarterTurn = 1 << 30;

struct View {
    const char* name;
    uint32_t azimuth_turns32;
    int32_t elevation_turns32;
    int32_t distance_q20;
    uint32_t fov_turns32;
    int32_t shift_x_q8, shift_y_q8;

    Pose pose() const { return detail::orbit(azimuth_turns32, elevation_turns32, distance_q20); }
    Image image(int32_t width_px, int32_t height_px) const
    {
        return {width_px, height_px, fov_turns32, shift_x_q8, shift_y_q8};
    }
};

constexpr int32_t radii_q20(int32_t hundredths)
{
    return static_cast<int32_t>(int64_t{hundredths} * kOneQ20 / 100);
}

inline constexpr View kViews[] = {
    {"front", 7 * kTurnHundredth, 8 * kTurnHundredth, radii_q20(250), 60 * kDegree, 0, 0},
    {"pole", 61 * kTurnHundredth, kQuarterTurn, radii_q20(180), 90 * kDegree, 0, 0},
    {"close", 33 * kTurnHundredth, -12 * static_cast<int32_t>(kTurnHundredth), radii_q20(102), 110 * kDegree, 0, 0},
    {"far-beside", 88 * kTurnHundredth, 3 * kTurnHundredth, radii_q20(4000), 4 * kDegree, 23 * 256, -13 * 256},
};

inline constexpr int32_t kWidth = 48;
inline constexpr int32_t kHeight = 36;

// A line of the list is about this; it is passed down while the policies are chosen one after the other.
struct Frame {
    const View& view;
    const Camera& camera;
    const Field& field;
    const char* texel;
    WriteText write;
};

inline bool refuse(WriteText write, const char* why)
{
    TextLine line;
    write(line.text("error: ").text(why).text("\n").c_str());
    return false;
}

// Writes all lines of one view and one texel format; instantiated for each format from texel_frames.cpp.in.
template <class Texel>
bool write_texel_frames(const Frame& frame);

}  // namespace lumi::firmware
