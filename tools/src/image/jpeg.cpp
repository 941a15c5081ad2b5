// SPDX-License-Identifier: MIT
#include "image/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <stdexcept>

namespace lumi::tools
{

namespace
{

using Handle = std::unique_ptr<void, int (*)(tjhandle)>;

void check(int result, const Handle& handle)
{
    if (result != 0) throw std::length_error(tjGetErrorStr2(handle.get()));
}

}  // namespace

std::string jpeg_bytes(const Picture& picture, int quality)
{
    const Handle handle(tjInitCompress(), tjDestroy);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const int result = tjCompress2(handle.get(), picture.rgb.data(), picture.width_px, 0, picture.height_px, TJPF_RGB,
                                   &bytes, &size, TJSAMP_420, quality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owned(bytes, tjFree);
    check(result, handle);
    return {reinterpret_cast<const char*>(owned.get()), size};
}

Picture through_jpeg(const Picture& picture, size_t bytes)
{
    int low = 1, high = 101;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (jpeg_bytes(picture, middle).size() <= bytes ? low : high) = middle;
    }
    const std::string packed = jpeg_bytes(picture, low);
    Picture shown(picture.width_px, picture.height_px);
    const Handle handle(tjInitDecompress(), tjDestroy);
    check(tjDecompress2(handle.get(), reinterpret_cast<const unsigned char*>(packed.data()), packed.size(),
                        shown.rgb.data(), shown.width_px, 0, shown.height_px, TJPF_RGB, TJFLAG_ACCURATEDCT),
          handle);
    return shown;
}

}  // namespace lumi::tools
