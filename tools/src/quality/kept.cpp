// SPDX-License-Identifier: MIT
#include "quality/kept.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "files/output_file.h"
#include "lumi/baker/file_guard.h"
#include "lumi/baker/picture_file.h"
#include "lumi/host/png.h"
#include "util/digest.h"

namespace lumi::quality
{

namespace
{

constexpr const char* kProgramFile = "/proc/self/exe";

std::string hex(const baker::Digest& digest)
{
    char text[40];
    std::snprintf(text, sizeof text, "%016" PRIx64 "%016" PRIx64, digest.value()[0], digest.value()[1]);
    return text;
}

}  // namespace

std::optional<std::string> kept_bytes(const std::string& path)
{
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) return std::nullopt;
    const uintmax_t size = std::filesystem::file_size(path, unknown);
    if (unknown || size > baker::kMaxPictureFileBytes) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

std::optional<tools::Picture> kept_picture(const std::string& bytes, int width_px, int height_px)
{
    try {
        host::DecodedPicture decoded = host::decode_png(bytes, false);
        if (decoded.width != width_px || decoded.height != height_px) return std::nullopt;
        tools::Picture picture(width_px, height_px);
        picture.rgb = std::move(decoded.rgb);
        return picture;
    } catch (const host::PictureError&) {
        return std::nullopt;
    }
}

Kept::Kept(const std::filesystem::path& folder)
{
    baker::note_input(kProgramFile);
    const std::optional<std::string> program = kept_bytes(kProgramFile);
    if (!program) return;
    baker::Digest digest;
    digest.add(*program);
    program_ = hex(digest);
    folder_ = folder;
    std::error_code ignored;  // what cannot be made is told by the write
    std::filesystem::create_directories(folder, ignored);
}

std::string Kept::stem(const std::vector<std::string_view>& inputs) const
{
    baker::Digest digest;
    digest.add(program_);
    for (const std::string_view input : inputs) digest.add_bytes(input.data(), input.size());
    return (folder_ / hex(digest)).string();
}

std::string Kept::seal(const std::string& path, std::string_view text, std::string_view beside) const
{
    baker::Digest digest;
    digest.add(program_);
    digest.add(std::filesystem::path(path).filename().string());
    digest.add_bytes(text.data(), text.size());
    digest.add_bytes(beside.data(), beside.size());
    return hex(digest) + "\n";
}

void Kept::write(const std::string& path, const std::string& text, std::string_view beside) const
{
    tools::write_output(path, seal(path, text, beside) + text);
}

std::optional<std::string> Kept::read(const std::string& path, std::string_view beside) const
{
    const std::optional<std::string> bytes = kept_bytes(path);
    const size_t end = bytes ? bytes->find('\n') : std::string::npos;
    if (end == std::string::npos) return std::nullopt;
    std::string text = bytes->substr(end + 1);
    if (bytes->compare(0, end + 1, seal(path, text, beside)) != 0) return std::nullopt;
    return text;
}

}  // namespace lumi::quality
