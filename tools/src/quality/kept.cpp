// SPDX-License-Identifier: MIT
#include "quality/kept.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "lumi/baker/file_guard.h"
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
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
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

}  // namespace lumi::quality
