// SPDX-License-Identifier: MIT
// A folder keeps what a report has measured: the next report, and one that was stopped, need not measure it again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/picture.h"

namespace lumi::quality
{

class Kept
{
public:
    Kept() = default;  // keeps nothing
    // Makes the folder. What another build of this program kept there is not found: it may measure by other code.
    explicit Kept(const std::filesystem::path& folder);

    bool keeps() const { return !folder_.empty(); }

    // The path, without an ending, of what these inputs decide: every byte that this program's answer depends on.
    // Precondition: keeps().
    std::string stem(const std::vector<std::string_view>& inputs) const;

    // Writes a text that read() gives back, with a seal over it and over `beside`, the bytes of another file. Throws
    // Failure.
    void write(const std::string& path, const std::string& text, std::string_view beside = {}) const;

    // Nothing where the file is not whole, or was written by another build or beside other bytes. The seal withstands
    // accidents and editors, but nobody who computes it: check what the text says.
    std::optional<std::string> read(const std::string& path, std::string_view beside = {}) const;

private:
    std::string seal(const std::string& path, std::string_view text, std::string_view beside) const;

    std::filesystem::path folder_;
    std::string program_;  // a digest of its file
};

// The bytes of a file; nothing where there is none, or where it is larger than any that a report keeps. What a report
// leaves for itself is no input of it (file_guard.h).
std::optional<std::string> kept_bytes(const std::string& path);

// A PNG of that size from those bytes; nothing where they are something else.
std::optional<tools::Picture> kept_picture(const std::string& bytes, int width_px, int height_px);

}  // namespace lumi::quality
