// SPDX-License-Identifier: MIT
#include "image/video.h"

#include <iterator>

#include "image/picture_file.h"
#include "terminal/child_program.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

constexpr char kGif[] = ".gif", kMp4[] = ".mp4";
constexpr char kMend[] = "apt-get install ffmpeg, or name the picture turn.webp";

std::vector<std::string> options_for(const std::string& ending)
{
    if (ending == kGif) return {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-loop", "0"};
    return {"-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-c:v",      "libx264",
            "-crf",      "18",
            "-pix_fmt",  "yuv420p",
            "-movflags", "+faststart"};
}

}  // namespace

bool is_video_name(const std::string& path)
{
    const std::string ending = small_ending(path);
    return ending == kGif || ending == kMp4;
}

VideoAnimation::VideoAnimation(const std::string& path, int width_px, int height_px, int frame_ms)
    : path_(path),
      width_px_(width_px),
      height_px_(height_px),
      frame_ms_(frame_ms),
      folder_(new_temporary_folder("name a folder with space in TMPDIR")),
      frames_(folder_ / "frames.rgb", std::ios::binary)
{
}

VideoAnimation::~VideoAnimation()
{
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void VideoAnimation::add(const Picture& frame)
{
    frames_.write(reinterpret_cast<const char*>(frame.rgb.data()), static_cast<std::streamsize>(frame.rgb.size()));
}

std::string VideoAnimation::bytes()
{
    const std::filesystem::path frames = folder_ / "frames.rgb";
    const std::string ending = small_ending(path_), made = (folder_ / ("turn" + ending)).string();
    frames_.close();
    if (!frames_) throw Failure(frames.string(), "cannot be written", "name a folder with space in TMPDIR");
    const std::string size = std::to_string(width_px_) + "x" + std::to_string(height_px_);
    std::vector<std::string> words = {"-v",
                                      "error",
                                      "-nostdin",
                                      "-f",
                                      "rawvideo",
                                      "-pixel_format",
                                      "rgb24",
                                      "-video_size",
                                      size,
                                      "-framerate",
                                      "1000/" + std::to_string(frame_ms_),
                                      "-i",
                                      frames.string()};
    for (const std::string& option : options_for(ending)) words.push_back(option);
    words.push_back(made);
    run_program("ffmpeg", words, kMend);
    std::ifstream file(made, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace lumi::tools
