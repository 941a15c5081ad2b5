// SPDX-License-Identifier: MIT
// Fuzz target: a picture from a stranger, read by the reader that its first bytes choose.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fuzz_folder.h"
#include "image/picture_bytes.h"
#include "image/radiance_picture.h"
#include "lumi/baker/scene.h"
#include "lumi/host/png.h"

namespace lumi::fuzz
{
size_t inputs_read = 0;  // for replay_main.cpp
}

namespace
{

using namespace lumi::baker;

void check(const DecodedPicture& picture, size_t alpha)
{
    const size_t count = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
    if (picture.rgb.size() != 3 * count || (picture.alpha.size() != alpha * count && !picture.alpha.empty())) abort();
}

void check(const RadiancePicture& sky)
{
    if (sky.pixels.size() != static_cast<size_t>(sky.width) * static_cast<size_t>(sky.height)) abort();
    for (const Rgb& c : sky.pixels)
        if (!std::isfinite(c.r + c.g + c.b) || std::min({c.r, c.g, c.b}) < 0) abort();
}

// As a bake reads it.
void read_sky(const std::string& bytes)
{
    static lumi::fuzz::FuzzFolder folder;
    std::vector<std::string> warnings;
    check(read_radiance_picture(folder.write("sky", bytes), warnings));
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
        } else if (is_exr(bytes) || is_hdr(bytes)) {
            read_sky(bytes);
        } else {
            return 0;
        }
        ++lumi::fuzz::inputs_read;
    } catch (const PictureError&) {  // readers of models add a mend
    } catch (const SceneError& refused) {
        lumi::fuzz::check_message(refused);
    }
    return 0;
}
