// SPDX-License-Identifier: MIT
// The one file that sees libjpeg-turbo.
#include "image/jpeg_file.h"

#include <turbojpeg.h>

#include <memory>

#include "image/picture_bytes.h"

namespace lumi::baker
{
namespace
{

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

Decoder make_decoder()
{
    Decoder decoder(tjInitDecompress(), tjDestroy);
    if (!decoder) throw std::bad_alloc();
    return decoder;
}

[[noreturn]] void fail(const Decoder& decoder)
{
    throw PictureError(std::string("it is damaged: ") + tjGetErrorStr2(decoder.get()));
}

}  // namespace

bool is_jpeg(const std::string& bytes)
{
    return bytes.rfind("\xFF\xD8\xFF", 0) == 0;
}

DecodedPicture decode_jpeg(const std::string& bytes)
{
    const Decoder decoder = make_decoder();
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
