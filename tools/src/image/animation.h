// SPDX-License-Identifier: MIT
// A turning picture in one file.
#pragma once

#include <memory>
#include <string>

#include "image/picture.h"

namespace lumi::tools
{

class Animation
{
public:
    virtual ~Animation() = default;
    virtual void add(const Picture& frame) = 0;
    // The bytes of the file. Call once, after the last frame.
    virtual std::string bytes() = 0;
};

// Whether the name ends in ".webp", ".gif" or ".mp4".
bool is_animation_name(const std::string& path);

// Says what is wrong with it as the name of views to write; nothing if it is an animation's or ends in ".png", or is a
// device or a pipe.
std::string wrong_views_name(const std::string& path);

// For a name that is_animation_name: see WebpAnimation and VideoAnimation, also for what they throw.
std::unique_ptr<Animation> animation_for(const std::string& path, int width_px, int height_px, int frame_ms);

}  // namespace lumi::tools
