// SPDX-License-Identifier: MIT
// A turning picture in one file: an animated WebP, as browsers and the pages of repositories show it.
#pragma once

#include <memory>
#include <string>

#include "image/picture.h"

namespace lumi::tools
{

// Whether the name ends in ".webp".
bool is_animation_name(const std::string& path);

// Says what is wrong with it as the name of views to write; nothing if it is an animation's or ends in ".png", or is a
// device or a pipe.
std::string wrong_views_name(const std::string& path);

// Frames of one size, repeated without end. Their colours are compressed with loss (quality 80 of 100), their alpha
// without, one after the other: memory for a few frames.
class Animation
{
public:
    Animation(int width_px, int height_px, int frame_ms);
    ~Animation();

    void add(const Picture& frame);
    // The bytes of the file. Call once, after the last frame.
    std::string bytes();

private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
    int frame_ms_, time_ms_ = 0;
};

}  // namespace lumi::tools
