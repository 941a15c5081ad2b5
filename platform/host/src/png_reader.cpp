// SPDX-License-Identifier: MIT
// The one file that sees libpng, which only reads.

#include <png.h>

#include <csetjmp>
#include <cstring>

#include "lumi/host/png.h"

namespace lumi::host
{
namespace
{

// libpng reports errors by longjmp. So each method that calls it has no variables with destructors, and says by its
// result whether it came to its end.
class PngReader
{
public:
    explicit PngReader(const std::string& bytes) : at_(bytes.data()), left_(bytes.size())
    {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, this, on_read);
        png_set_user_limits(png_, kMaxPictureSide, kMaxPictureSide);
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    bool read_header()
    {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_info(png_, info_);
        return true;
    }

    int64_t width() const { return png_get_image_width(png_, info_); }
    int64_t height() const { return png_get_image_height(png_, info_); }
    bool has_alpha() const
    {
        return (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0 ||
               png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    }
    // Before read_as.
    int64_t packed_row_bytes() const { return static_cast<int64_t>(png_get_rowbytes(png_, info_)); }

    // 8 bits a channel, three or four of them. False also where libpng makes other rows of it.
    bool read_as(int channels, std::vector<png_bytep>& rows)
    {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_expand(png_);
        png_set_scale_16(png_);
        png_set_gray_to_rgb(png_);
        if (channels == 3) png_set_strip_alpha(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        if (png_get_rowbytes(png_, info_) != static_cast<size_t>(width()) * static_cast<size_t>(channels)) return false;
        png_read_image(png_, rows.data());
        png_read_end(png_, nullptr);
        return true;
    }

    [[noreturn]] void fail() const
    {
        throw PictureError(std::string("it is damaged: ") + (*why_ ? why_ : "its rows have another size"));
    }

private:
    static PngReader& of(void* reader) { return *static_cast<PngReader*>(reader); }

    [[noreturn]] static void on_error(png_structp png, png_const_charp text)
    {
        PngReader& reader = of(png_get_error_ptr(png));
        std::strncpy(reader.why_, text, sizeof reader.why_ - 1);
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
    static void on_read(png_structp png, png_bytep out, size_t size)
    {
        PngReader& reader = of(png_get_io_ptr(png));
        if (size > reader.left_) png_error(png, "it ends too early");
        std::memcpy(out, reader.at_, size);
        reader.at_ += size;
        reader.left_ -= size;
    }

    const char* at_;
    size_t left_;
    char why_[128] = {};
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

// Deflate packs at most 1032 bytes into one; a row has a byte of its own before its pixels.
void check_plausible(const PngReader& reader, size_t bytes)
{
    constexpr int64_t kMostRatio = 1032;
    check_picture_bytes(static_cast<int64_t>(bytes), reader.height() * (reader.packed_row_bytes() + 1) / kMostRatio);
}

void take_alpha_apart(DecodedPicture& picture)
{
    const size_t count = picture.rgb.size() / 4;
    picture.alpha.resize(count);
    for (size_t k = 0; k < count; ++k) {
        picture.alpha[k] = picture.rgb[4 * k + 3];
        std::memmove(&picture.rgb[3 * k], &picture.rgb[4 * k], 3);
    }
    picture.rgb.resize(3 * count);
}

}  // namespace

bool is_png(const std::string& bytes)
{
    constexpr char kMagic[] = "\x89PNG\r\n\x1A\n";
    return bytes.rfind(kMagic, 0) == 0;
}

DecodedPicture decode_png(const std::string& bytes, bool with_alpha)
{
    PngReader reader(bytes);
    if (!reader.read_header()) reader.fail();
    check_picture_size(reader.width(), reader.height());
    check_plausible(reader, bytes.size());
    const int channels = with_alpha && reader.has_alpha() ? 4 : 3;
    DecodedPicture picture;
    picture.width = static_cast<int>(reader.width());
    picture.height = static_cast<int>(reader.height());
    const size_t row_bytes = static_cast<size_t>(picture.width) * static_cast<size_t>(channels);
    picture.rgb.resize(row_bytes * static_cast<size_t>(picture.height));
    std::vector<png_bytep> rows(static_cast<size_t>(picture.height));
    for (size_t y = 0; y < rows.size(); ++y) rows[y] = &picture.rgb[y * row_bytes];
    if (!reader.read_as(channels, rows)) reader.fail();
    if (channels == 4) take_alpha_apart(picture);
    return picture;
}

}  // namespace lumi::host
