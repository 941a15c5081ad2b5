// SPDX-License-Identifier: MIT
// Fuzz target: a picture from a stranger, read by the reader that its first bytes choose.
#include <cstdlib>
#include <string>

#include "image/picture_bytes.h"
#include "image/radiance_picture.h"
#include "lumi/host/png.h"

namespace
{

using namespace lumi::baker;

void check(const DecodedPicture& picture, size_t alpha)
{
    const size_t count = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
    if (picture.rgb.size() != 3 * count || (picture.alpha.size() != alpha * count && !picture.alpha.empty())) abort();
}

void check(const RadiancePicture& picture)
{
    if (picture.pixels.size() != static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height)) abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        if (pixels_of(bytes) < 0) abort();
        if (lumi::host::is_png(bytes)) {
            check(lumi::host::decode_png(bytes, false), 0);
            check(lumi::host::decode_png(bytes, true), 1);
        } else if (is_jpeg(bytes)) {
            check(decode_jpeg(bytes), 0);
        } else if (is_webp(bytes)) {
            check(decode_webp(bytes, false), 0);
            check(decode_webp(bytes, true), 1);
        } else if (is_exr(bytes)) {
            check(decode_exr(bytes));
        } else if (is_hdr(bytes)) {
            check(decode_hdr(bytes));
        }
    } catch (const PictureError&) {
    }
    return 0;
}
