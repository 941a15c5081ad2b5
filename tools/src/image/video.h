// SPDX-License-Identifier: MIT
// A turning picture as GIF or MP4, by the program ffmpeg where it is installed.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "image/animation.h"

namespace lumi::tools
{

bool is_video_name(const std::string& path);

// Frames of one size, kept in a temporary file. An MP4 (H.264) plays once and has even sides, by a black row or column
// where needed; a GIF repeats without end, in 256 colours. Throws Failure where ffmpeg is missing or fails, or the
// temporary files cannot be written.
class VideoAnimation : public Animation
{
public:
    VideoAnimation(const std::string& path, int width_px, int height_px, int frame_ms);
    ~VideoAnimation() override;

    void add(const Picture& frame) override;
    std::string bytes() override;

private:
    std::string path_;
    int width_px_, height_px_, frame_ms_;
    std::filesystem::path folder_;
    std::ofstream frames_;
};

}  // namespace lumi::tools
