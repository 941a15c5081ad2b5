// SPDX-License-Identifier: MIT
#include "image/webp.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <new>
#include <stdexcept>

#include "image/picture_file.h"

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

void require(bool done)
{
    if (!done) throw std::length_error("cannot become a WebP, whose sides have at most 16383 pixels");
}

// A picture of the library, with memory of its own.
struct Frame {
    WebPPicture picture = {};

    explicit Frame(const Picture& source)
    {
        constexpr int kChannels = 3;
        WebPPictureInit(&picture);
        picture.use_argb = 1;
        picture.width = source.width_px;
        picture.height = source.height_px;
        require(WebPPictureImportRGB(&picture, source.rgb.data(), kChannels * source.width_px) != 0);
    }
    ~Frame() { WebPPictureFree(&picture); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
};

}  // namespace

bool is_webp_name(const std::string& path)
{
    return small_ending(path) == ".webp";
}

struct WebpAnimation::Encoder {
    std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> made{nullptr, WebPAnimEncoderDelete};
    WebPConfig config = lossy();
};

WebpAnimation::WebpAnimation(int width_px, int height_px, int frame_ms)
    : encoder_(std::make_unique<Encoder>()), frame_ms_(frame_ms)
{
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    require(width_px <= WEBP_MAX_DIMENSION && height_px <= WEBP_MAX_DIMENSION);
    encoder_->made.reset(WebPAnimEncoderNew(width_px, height_px, &options));
    if (encoder_->made == nullptr) throw std::bad_alloc();
}

WebpAnimation::~WebpAnimation() = default;

void WebpAnimation::add(const Picture& frame)
{
    Frame converted(frame);
    require(WebPAnimEncoderAdd(encoder_->made.get(), &converted.picture, time_ms_, &encoder_->config) != 0);
    time_ms_ += frame_ms_;
}

std::string WebpAnimation::bytes()
{
    WebPData data;
    WebPDataInit(&data);
    require(WebPAnimEncoderAdd(encoder_->made.get(), nullptr, time_ms_, nullptr) != 0);
    const bool assembled = WebPAnimEncoderAssemble(encoder_->made.get(), &data) != 0;
    std::string bytes(reinterpret_cast<const char*>(data.bytes), assembled ? data.size : 0);
    WebPDataClear(&data);
    if (!assembled) throw std::bad_alloc();
    return bytes;
}

}  // namespace lumi::tools
