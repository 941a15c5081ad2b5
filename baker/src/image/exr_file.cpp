// SPDX-License-Identifier: MIT
// The one file that sees OpenEXR.
#include "image/radiance_picture.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cstring>

#include "image/picture_bytes.h"

namespace lumi::baker
{
namespace
{

// The bytes of a file as OpenEXR wants to read them.
class BytesStream : public Imf::IStream
{
public:
    explicit BytesStream(const std::string& bytes) : Imf::IStream("picture"), bytes_(bytes) {}

    bool read(char out[], int count) override
    {
        const uint64_t size = static_cast<uint64_t>(count);
        if (size > bytes_.size() - std::min<uint64_t>(position_, bytes_.size()))
            throw std::runtime_error("it ends too early");
        std::memcpy(out, bytes_.data() + position_, size);
        position_ += size;
        check_size(out, size);
        return position_ < bytes_.size();
    }
    int64_t size() const { return static_cast<int64_t>(bytes_.size()); }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override
    {
        position_ = position;
        is_behind_name_ = false;
    }
    void clear() override {}

private:
    // Names are read byte by byte. A number behind one is the size of a part of the header, for which OpenEXR takes
    // memory before it reads it, or the type of a channel, which is small.
    void check_size(const char read[], uint64_t count)
    {
        uint32_t number = 0;
        for (size_t k = 0; k < 4 && count == 4; ++k) number |= uint32_t{static_cast<uint8_t>(read[k])} << (8 * k);
        if (is_behind_name_ && number > bytes_.size() - position_)
            throw std::runtime_error("a part of its header is longer than the file");
        is_behind_name_ = count == 1 && read[0] == 0;
    }

    const std::string& bytes_;
    uint64_t position_ = 0;
    bool is_behind_name_ = false;
};

// A file that OpenEXR writes into memory.
class GrowingStream : public Imf::OStream
{
public:
    GrowingStream() : Imf::OStream("picture") {}

    void write(const char bytes[], int count) override
    {
        const size_t size = static_cast<size_t>(count);
        bytes_.resize(std::max(bytes_.size(), position_ + size));
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    size_t position_ = 0;
};

// Far above what a picture of the world packs into: a few bytes must not claim gigabytes.
constexpr int64_t kMostPixelsAByte = 2048;

RadiancePicture read(BytesStream& stream)
{
    Imf::InputFile input(stream, 1);
    const Imath::Box2i window = input.header().dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1;
    const int64_t height = int64_t{window.max.y} - window.min.y + 1;
    check_picture_size(width, height);
    check_picture_bytes(stream.size(), width * height / kMostPixelsAByte);
    const bool coloured = input.header().channels().findChannel("R") != nullptr;
    if (!coloured && !input.header().channels().findChannel("Y"))
        throw std::runtime_error("it has neither R, G and B nor Y channels");
    RadiancePicture picture{static_cast<int>(width), static_cast<int>(height),
                            std::vector<Rgb>(static_cast<size_t>(width * height))};
    Imf::FrameBuffer frame;
    const char* names[3] = {"R", "G", "B"};
    for (size_t k = 0; k < (coloured ? 3u : 1u); ++k) {
        char* base = reinterpret_cast<char*>(picture.pixels.data()) + sizeof(float) * k;
        frame.insert(coloured ? names[k] : "Y",
                     Imf::Slice::Make(Imf::FLOAT, base, window, sizeof(Rgb), sizeof(Rgb) * static_cast<size_t>(width)));
    }
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    for (size_t k = 0; k < picture.pixels.size() && !coloured; ++k) picture.pixels[k] = grey(picture.pixels[k].r);
    return picture;
}

// Pixels of four floats, as OpenEXR wants to find them.
Imf::FrameBuffer frame_of(const RadianceView& picture)
{
    constexpr size_t kPixelBytes = 4 * sizeof(float);
    Imf::FrameBuffer frame;
    char* base = const_cast<char*>(reinterpret_cast<const char*>(picture.rgba));  // OpenEXR only reads it
    for (const char* name : {"R", "G", "B", "A"}) {
        frame.insert(name, Imf::Slice(Imf::FLOAT, base, kPixelBytes, kPixelBytes * static_cast<size_t>(picture.width)));
        base += sizeof(float);
    }
    return frame;
}

}  // namespace

std::string exr_bytes(const RadianceView& picture)
{
    Imf::Header header(picture.width, picture.height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
    for (const char* name : {"R", "G", "B", "A"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    GrowingStream stream;
    {
        Imf::OutputFile output(stream, header, 0);
        output.setFrameBuffer(frame_of(picture));
        output.writePixels(picture.height);
    }  // writes where each scanline lies
    return stream.take();
}

bool is_exr(const std::string& bytes)
{
    constexpr char kMagic[] = "\x76\x2f\x31\x01";
    return bytes.compare(0, 4, kMagic) == 0;
}

RadiancePicture decode_exr(const std::string& bytes)
{
    Imf::Header::setMaxImageSize(kMaxPictureSide, kMaxPictureSide);  // before tables for all lines are made
    BytesStream stream(bytes);
    try {
        return read(stream);
    } catch (const PictureError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        throw PictureError(std::string("it is damaged: ") + e.what());
    }
}

}  // namespace lumi::baker
