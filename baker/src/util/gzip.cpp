// SPDX-License-Identifier: MIT
// The one file of the baker that sees zlib.
#include "util/gzip.h"

#define ZLIB_CONST  // inputs are not written
#include <zlib.h>

#include <algorithm>
#include <new>

#include "util/byte_stream.h"

namespace lumi::baker
{
namespace
{

// Bytes unpacked at a time: a short file that claims much takes little memory.
constexpr size_t kPiece = size_t{1} << 22;

class Inflater
{
public:
    explicit Inflater(const std::string& bytes) : in_(bytes)
    {
        constexpr int kGzip = 16;  // zlib's flag for that format
        if (inflateInit2(&stream_, MAX_WBITS + kGzip) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    // Fills as much of `out` as it can; returns how many bytes that are.
    size_t read(char* out, size_t size)
    {
        stream_.next_out = reinterpret_cast<Bytef*>(out);
        stream_.avail_out = static_cast<uInt>(size);
        while (stream_.avail_out != 0 && !done_) step();
        return size - stream_.avail_out;
    }

private:
    void step()
    {
        const size_t piece = std::min(kPiece, in_.size() - at_);
        stream_.next_in = reinterpret_cast<const Bytef*>(in_.data() + at_);
        stream_.avail_in = static_cast<uInt>(piece);
        const int result = inflate(&stream_, Z_NO_FLUSH);
        at_ += piece - stream_.avail_in;
        if (result == Z_STREAM_END)  // another member may follow
            done_ = at_ == in_.size() || inflateReset(&stream_) != Z_OK;
        else
            done_ = result != Z_OK;  // damaged, or no more input
    }

    const std::string& in_;
    size_t at_ = 0;
    bool done_ = false;
    z_stream stream_ = {};
};

}  // namespace

bool is_gzip(const std::string& bytes)
{
    return bytes.rfind("\x1F\x8B", 0) == 0;
}

std::string unpack_gzip(const std::string& bytes, size_t most)
{
    Inflater inflater(bytes);
    std::string out;
    for (size_t size = 0, taken = 1; taken != 0 && size < most; size = out.size()) {
        out.resize(std::min(most, size + kPiece));
        taken = inflater.read(&out[size], out.size() - size);
        out.resize(size + taken);
    }
    return out;
}

namespace
{

constexpr size_t kSizeBytes = 8;  // before the packed bytes, how many they were

}  // namespace

uint32_t checksum(uint32_t previous, const uint8_t* bytes, size_t size)
{
    if (size == 0) return previous;  // zlib begins anew where there are no bytes
    return static_cast<uint32_t>(crc32_z(previous, bytes, size));
}

std::vector<uint8_t> packed(const std::vector<uint8_t>& bytes)
{
    ByteWriter head;
    head.put64(bytes.size());
    std::vector<uint8_t> out = head.bytes();
    uLongf size = compressBound(bytes.size());
    out.resize(kSizeBytes + size);
    if (compress2(out.data() + kSizeBytes, &size, bytes.data(), bytes.size(), Z_BEST_SPEED) != Z_OK)
        throw std::bad_alloc();
    out.resize(kSizeBytes + size);
    return out;
}

std::optional<std::vector<uint8_t>> unpacked(const std::vector<uint8_t>& bytes)
{
    constexpr uint64_t kMostRatio = 1100;  // deflate makes nothing smaller than by 1032
    if (bytes.size() < kSizeBytes) return std::nullopt;
    const uint64_t wanted = ByteReader(bytes.data(), kSizeBytes).get64();
    if (wanted / kMostRatio > bytes.size()) return std::nullopt;
    std::vector<uint8_t> out(wanted);
    uLongf size = wanted;
    const int result = uncompress(out.data(), &size, bytes.data() + kSizeBytes, bytes.size() - kSizeBytes);
    if (result != Z_OK || size != wanted) return std::nullopt;
    return out;
}

}  // namespace lumi::baker
