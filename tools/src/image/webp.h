// SPDX-License-Identifier: MIT
// A turning picture in one file: an animated WebP, as browsers and the pages of repositories show it.
#pragma once

#include <memory>
#include <string>

#include "image/animation.h"

namespace lumi::tools
{

bool is_webp_name(const std::string& path);

// Frames of one size, repeated without end. They are compressed with loss (quality 80 of 100), one after the other:
// memory for a few frames. Every function throws std::length_error for a size that no WebP can hold (16383 pixels a
// side).
class WebpAnimation : public Animation
{
public:
    WebpAnimation(int width_px, int height_px, int frame_ms);
    ~WebpAnimation() override;

    void add(const Picture& frame) override;
    std::string bytes() override;

private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
    int frame_ms_, time_ms_ = 0;
};

}  // namespace lumi::tools
