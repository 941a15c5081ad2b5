// SPDX-License-Identifier: MIT
// A frame of the list's chord fields, as the list and the files that draw it know it.
#pragma once

#include "frame_list.h"
#include "lumi/chord/render.h"
#include "text_line.h"
#include "views.h"

namespace lumi::firmware
{

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

// All lines of one view and one texel format; instantiated for each format from texel_frames.cpp.in.
template <class Texel>
bool write_texel_frames(const Frame& frame);

}  // namespace lumi::firmware
