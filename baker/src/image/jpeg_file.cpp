// SPDX-License-Identifier: MIT
// The one file that sees libjpeg-turbo.

#include <turbojpeg.h>

#include <memory>

#include "image/picture_bytes.h"

namespace lumi::baker
{
namespace
{

using Handle = std::unique_ptr<void, int (*)(tjhandle)>;

Handle owned(tjhandle handle)
{
    if (!handle) throw std::bad_alloc();
    return {handle, tjDestroy};
}

[[noreturn]] void fail(const Handle& decoder)
{
    throw PictureError(std::string("it is damaged: ") + tjGetErrorStr2(decoder.get()));
}

}  // namespace

bool is_jpeg(const std::string& bytes)
{
    return bytes.rfind("\xFF\xD8\xFF", 0) == 0;
}

int64_t pixels_of_jpeg(const std::string& bytes)
{
    const Handle decoder = owned(tjInitDecompress());
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    int width = 0, height = 0, subsampling = 0, colours = 0;
    const bool is_sound =
        tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling, &colours) == 0;
    return is_sound ? int64_t{width} * height : 0;
}

DecodedPicture decode_jpeg(const std::string& bytes)
{
    const Handle decoder = owned(tjInitDecompress());
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    DecodedPicture picture;
    int subsampling = 0, colours = 0;
    if (tjDecompressHeader3(decoder.get(), data, bytes.size(), &picture.width, &picture.height, &subsampling,
                            &colours) != 0)
        fail(decoder);
    check_picture_size(picture.width, picture.height);
    if (colours == TJCS_CMYK || colours == TJCS_YCCK) throw PictureError("its colours are CMYK");
    picture.rgb.resize(3 * static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
    // A picture of 500 scans takes minutes, and no program writes one.
    constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT;
    if (tjDecompress2(decoder.get(), data, bytes.size(), picture.rgb.data(), picture.width, 0, picture.height, TJPF_RGB,
                      kFlags) != 0)
        fail(decoder);
    return picture;
}

}  // namespace lumi::baker
