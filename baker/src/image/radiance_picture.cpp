// SPDX-License-Identifier: MIT
#include "image/radiance_picture.h"

#include <array>
#include <cmath>
#include <string_view>

#include "image/picture_bytes.h"
#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{

namespace
{

// Sharpened pictures undershoot: a little below 0 is ordinary, and means 0.
Rgb clamped(const Rgb& c)
{
    return {std::clamp(c.r, 0.0f, kMaxRadiance), std::clamp(c.g, 0.0f, kMaxRadiance),
            std::clamp(c.b, 0.0f, kMaxRadiance)};
}

void repair(const std::filesystem::path& file, RadiancePicture& picture, std::vector<std::string>& warnings)
{
    size_t bad = 0, first = 0;
    for (size_t k = 0; k < picture.pixels.size(); ++k) {
        Rgb& p = picture.pixels[k];
        if (!std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b)) {
            first = bad++ == 0 ? k : first;
            p = {};
        }
        p = clamped(p);
    }
    if (bad != 0) {
        const size_t width = static_cast<size_t>(picture.width);
        warnings.push_back(at({file.string()}, std::to_string(bad) +
                                                   " pixel(s) are no number or infinite and count as black; "
                                                   "repair the picture, first at column " +
                                                   std::to_string(first % width) + ", row " +
                                                   std::to_string(first / width)));
    }
}

RadiancePicture read(const std::filesystem::path& file)
{
    const std::string bytes = picture_bytes(file);
    if (is_exr(bytes)) return decode_exr(bytes);
    if (is_hdr(bytes)) return decode_hdr(bytes);
    throw SceneError(
        at({file.string()}, "this is neither a Radiance .hdr nor an OpenEXR picture; save it as one of them"));
}

}  // namespace

RadiancePicture read_radiance_picture(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    RadiancePicture picture;
    try {
        picture = read(file);
    } catch (const PictureError& e) {
        throw SceneError(at({file.string()}, std::string("the picture cannot be read (") + e.what() +
                                                 "); save it again as .hdr or .exr"));
    }
    repair(file, picture, warnings);
    return picture;
}

// A reader of our own: stb_image, the only library of Debian that reads the format alone, never ends on a file that is
// cut short (CVE-2021-42715).

namespace
{

using Rgbe = std::array<uint8_t, 4>;

// Scanlines of these widths may have run lengths.
constexpr int kLeastPackedWidth = 8, kMostPackedWidth = 32767;
constexpr int kMostRun = 127;

Rgb to_rgb(const Rgbe& c)
{
    if (c[3] == 0) return {};
    const float unit = std::ldexp(1.0f, c[3] - (128 + 8));
    return {static_cast<float>(c[0]) * unit, static_cast<float>(c[1]) * unit, static_cast<float>(c[2]) * unit};
}

class HdrReader
{
public:
    explicit HdrReader(std::string_view bytes) : rest_(bytes) {}

    RadiancePicture read()
    {
        read_header();
        RadiancePicture picture;
        read_size(picture);
        const size_t width = static_cast<size_t>(picture.width), height = static_cast<size_t>(picture.height);
        picture.pixels.reserve(width * height);
        std::vector<Rgbe> scanline(width);
        for (size_t y = 0; y < height; ++y) {
            read_scanline(scanline);
            for (const Rgbe& c : scanline) picture.pixels.push_back(to_rgb(c));
        }
        return picture;
    }

private:
    std::string_view line()
    {
        const size_t end = rest_.find('\n');
        if (end == std::string_view::npos) throw PictureError("its header has no end");
        const std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return result;
    }

    void read_header()
    {
        bool known = false;
        for (std::string_view text = line(); !text.empty(); text = line())
            known = known || text == "FORMAT=32-bit_rle_rgbe";
        if (!known) throw PictureError("its header lacks 'FORMAT=32-bit_rle_rgbe'");
    }

    void read_size(RadiancePicture& picture)
    {
        const std::vector<std::string_view> parts = words(line());
        int64_t width = 0, height = 0;
        if (parts.size() != 4 || parts[0] != "-Y" || parts[2] != "+X" || !parse_integer(parts[1], height) ||
            !parse_integer(parts[3], width))
            throw PictureError("its size is not of the form '-Y HEIGHT +X WIDTH'");
        check_picture_size(width, height);
        const int64_t runs = (width + kMostRun - 1) / kMostRun;
        check_picture_bytes(static_cast<int64_t>(rest_.size()), height * std::min(4 * width, 4 + 4 * 2 * runs));
        picture.width = static_cast<int>(width);
        picture.height = static_cast<int>(height);
    }

    uint8_t byte()
    {
        if (rest_.empty()) throw PictureError("it ends too early");
        const uint8_t value = static_cast<uint8_t>(rest_.front());
        rest_.remove_prefix(1);
        return value;
    }

    void read_scanline(std::vector<Rgbe>& scanline)
    {
        const int width = static_cast<int>(scanline.size());
        const auto at = [&](size_t k) { return k < rest_.size() ? static_cast<uint8_t>(rest_[k]) : 0; };
        const bool packed =
            width >= kLeastPackedWidth && width <= kMostPackedWidth && at(0) == 2 && at(1) == 2 && at(2) < 128;
        if (!packed) {
            read_flat(scanline);
            return;
        }
        if (at(2) * 256 + at(3) != width) throw PictureError("a scanline has another length than the picture");
        rest_.remove_prefix(4);
        for (size_t channel = 0; channel < 4; ++channel) read_runs(scanline, channel);
    }

    void read_flat(std::vector<Rgbe>& scanline)
    {
        for (Rgbe& c : scanline) {
            c = {byte(), byte(), byte(), byte()};
            if (c[0] == 1 && c[1] == 1 && c[2] == 1)
                throw PictureError("it has run lengths of the first version of the format");
        }
    }

    void read_runs(std::vector<Rgbe>& scanline, size_t channel)
    {
        for (size_t x = 0; x < scanline.size();) {
            const uint8_t code = byte();
            const bool same = code > 128;
            const size_t count = same ? code - 128u : code;
            if (count == 0 || count > scanline.size() - x) throw PictureError("a run has a wrong length");
            for (size_t k = 0; k < count; ++k)
                scanline[x + k][channel] = k == 0 || !same ? byte() : scanline[x][channel];
            x += count;
        }
    }

    std::string_view rest_;
};

}  // namespace

bool is_hdr(const std::string& bytes)
{
    return bytes.rfind("#?RADIANCE\n", 0) == 0 || bytes.rfind("#?RGBE\n", 0) == 0;
}

RadiancePicture decode_hdr(const std::string& bytes)
{
    return HdrReader(bytes).read();
}

}  // namespace lumi::baker
