// SPDX-License-Identifier: MIT
#include "image/animation.h"

#include "image/picture_file.h"
#include "image/video.h"
#include "image/webp.h"

namespace lumi::tools
{

bool is_animation_name(const std::string& path)
{
    return is_webp_name(path) || is_video_name(path);
}

std::string wrong_views_name(const std::string& path)
{
    if (is_animation_name(path)) return "";
    const std::string wrong = wrong_png_name(path);
    return wrong.empty() ? "" : wrong + "; a --turntable may also be one .webp, .gif or .mp4";
}

std::unique_ptr<Animation> animation_for(const std::string& path, int width_px, int height_px, int frame_ms)
{
    if (is_webp_name(path)) return std::make_unique<WebpAnimation>(width_px, height_px, frame_ms);
    return std::make_unique<VideoAnimation>(path, width_px, height_px, frame_ms);
}

}  // namespace lumi::tools
