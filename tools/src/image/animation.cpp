// SPDX-License-Identifier: MIT
#include "image/animation.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <new>

#include "image/picture_file.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

WebPConfig lossy()
{
    constexpr float kQuality = 80;
    constexpr int kSlowest = 6;  // smallest files
    WebPConfig config;
    WebPConfigPreset(&config, WEBP_PRESET_PICTURE, kQuality);
    config.method = kSlowest;
    return config;
}

// Pictures have sides of at most 8192 pixels, and a WebP of 16383: only memory can be missing.
void require(bool done)
{
    if (!done) throw std::bad_alloc();
}

// A picture of the library, with memory of its own.
struct Frame {
    WebPPicture picture = {};

    explicit Frame(const Picture& source)
    {
        WebPPictureInit(&picture);
        picture.use_argb = 1;
        picture.width = source.width_px;
        picture.height = source.height_px;
        require((source.alpha.empty()
                     ? WebPPictureImportRGB(&picture, source.rgb.data(), 3 * source.width_px)
                     : WebPPictureImportRGBA(&picture, rgba_of(source).data(), 4 * source.width_px)) != 0);
    }
    ~Frame() { WebPPictureFree(&picture); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
};

}  // namespace

bool is_animation_name(const std::string& path)
{
    return small_ending(path) == ".webp";
}

std::string wrong_views_name(const std::string& path)
{
    if (is_animation_name(path)) return "";
    const std::string wrong = wrong_png_name(path);
    return wrong.find("PNG") == std::string::npos ? wrong : wrong + "; a --turntable may also be one .webp";
}

struct Animation::Encoder {
    std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> made{nullptr, WebPAnimEncoderDelete};
    WebPConfig config = lossy();
};

Animation::Animation(int width_px, int height_px, int frame_ms)
    : encoder_(std::make_unique<Encoder>()), frame_ms_(frame_ms)
{
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    encoder_->made.reset(WebPAnimEncoderNew(width_px, height_px, &options));
    require(encoder_->made != nullptr);
}

Animation::~Animation() = default;

void Animation::add(const Picture& frame)
{
    Frame converted(frame);
    require(WebPAnimEncoderAdd(encoder_->made.get(), &converted.picture, time_ms_, &encoder_->config) != 0);
    time_ms_ += frame_ms_;
}

std::string Animation::bytes()
{
    WebPData data;
    WebPDataInit(&data);
    require(WebPAnimEncoderAdd(encoder_->made.get(), nullptr, time_ms_, nullptr) != 0);
    const bool assembled = WebPAnimEncoderAssemble(encoder_->made.get(), &data) != 0;
    std::string bytes(reinterpret_cast<const char*>(data.bytes), assembled ? data.size : 0);
    WebPDataClear(&data);
    require(assembled);
    return bytes;
}

}  // namespace lumi::tools
