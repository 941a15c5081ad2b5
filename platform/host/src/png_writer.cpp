// SPDX-License-Identifier: MIT
// The one file that sees stb_image_write. zlib packs for it, since its own packer makes files a third larger.
#include <zlib.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <new>

#include "lumi/host/png.h"

namespace
{

// The counterpart of stbi_zlib_compress: memory that free() takes, or null.
unsigned char* deflated(unsigned char* bytes, int size, int* packed_size, int level)
{
    constexpr int kMemory = 8;  // zlib's default
    z_stream stream = {};
    if (deflateInit2(&stream, level, Z_DEFLATED, MAX_WBITS, kMemory, Z_FILTERED) != Z_OK) return nullptr;
    const uLong most = deflateBound(&stream, static_cast<uLong>(size));
    auto* packed = static_cast<unsigned char*>(std::malloc(most));
    if (packed != nullptr) {
        stream.next_in = bytes;
        stream.avail_in = static_cast<uInt>(size);
        stream.next_out = packed;
        stream.avail_out = static_cast<uInt>(most);
        deflate(&stream, Z_FINISH);
        *packed_size = static_cast<int>(stream.total_out);
    }
    deflateEnd(&stream);
    return packed;
}

unsigned crc_of(const unsigned char* bytes, int size)
{
    return static_cast<unsigned>(crc32(0, bytes, static_cast<uInt>(size)));
}

}  // namespace

#define STBIW_ZLIB_COMPRESS deflated
#define STBIW_CRC32 crc_of
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace lumi::host
{
namespace
{

// stb_image_write counts bytes in an int: all rows with a byte of its own before each, what they are packed into, and,
// to choose a row's filter, the sum of its bytes' magnitudes, which are at most 128.
bool fits_int(const PictureView& picture)
{
    constexpr int64_t kMost = std::numeric_limits<int>::max();
    constexpr int64_t kMagnitude = 128;
    constexpr int64_t kAroundPacked = 1 << 20;  // more than chunks take, and zlib for 2 GB that it cannot pack
    const int64_t row = int64_t{picture.width} * picture.channels;
    return row * kMagnitude <= kMost && (row + 1) * picture.height <= kMost - kAroundPacked;
}

}  // namespace

std::string png_bytes(const PictureView& picture)
{
    if (!fits_int(picture)) {
        throw std::length_error("a picture of " + std::to_string(picture.width) + " by " +
                                std::to_string(picture.height) + " pixels is too large for a PNG file");
    }
    stbi_write_png_compression_level = Z_DEFAULT_COMPRESSION;
    int size = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> bytes(
        stbi_write_png_to_mem(picture.pixels, 0, picture.width, picture.height, picture.channels, &size), &std::free);
    if (!bytes) throw std::bad_alloc();
    return std::string(reinterpret_cast<const char*>(bytes.get()), static_cast<size_t>(size));
}

}  // namespace lumi::host
