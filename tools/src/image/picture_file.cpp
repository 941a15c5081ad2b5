// SPDX-License-Identifier: MIT
#include "image/picture_file.h"

#include <filesystem>
#include <stdexcept>

#include "files/output_file.h"
#include "image/animation.h"
#include "lumi/baker/picture_file.h"
#include "lumi/host/png.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

std::string wrong_png_name(const std::string& path)
{
    namespace fs = std::filesystem;
    const fs::path name(path);
    std::error_code ignored;
    const fs::file_status status = fs::status(name, ignored);
    if (small_ending(path) == ".png" || fs::is_character_file(status) || fs::is_fifo(status)) return "";
    if (!name.has_filename()) return "takes a file, not the folder \"" + path + "\"";
    const fs::path mended =
        name.stem() == ".png" ? fs::path(name).replace_filename("view.png") : fs::path(name).replace_extension(".png");
    return "pictures are PNG files; name it " + mended.string() + ", not \"" + path + "\"";
}

Picture read_png(const std::string& path)
{
    try {
        baker::DecodedPicture decoded = baker::read_png(path);
        Picture picture(decoded.width, decoded.height);
        picture.rgb = std::move(decoded.rgb);
        for (size_t i = 0; i < 3 * decoded.alpha.size(); ++i)
            picture.rgb[i] = static_cast<uint8_t>((picture.rgb[i] * decoded.alpha[i / 3] + kOpaque / 2) / kOpaque);
        return picture;
    } catch (const baker::PictureError& error) {
        throw Failure(path, std::string("is not read (") + error.what() + ")", "give a whole PNG file");
    }
}

std::string png_bytes(const Picture& picture)
{
    if (picture.alpha.empty()) return host::png_bytes({picture.width_px, picture.height_px, picture.rgb.data()});
    return host::png_bytes({picture.width_px, picture.height_px, rgba_of(picture).data(), 4});
}

void write_png(const std::string& path, const Picture& picture)
{
    try {
        write_output(path, png_bytes(picture));
    } catch (const std::length_error& error) {
        throw Failure(path, error.what(), "choose a smaller --size");
    }
}

bool is_exr_name(const std::string& path)
{
    return small_ending(path) == ".exr";
}

std::string wrong_reference_name(const std::string& path)
{
    if (is_exr_name(path)) return "";
    const std::string wrong = wrong_views_name(path);
    return wrong.find("PNG") == std::string::npos ? wrong
                                                  : wrong + "; linear light is written to names that end in .exr";
}

std::string exr_bytes(const baker::RadianceImage& image)
{
    return baker::exr_bytes({image.width, image.height, image.rgba.data()});
}

}  // namespace lumi::tools
