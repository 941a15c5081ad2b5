// SPDX-License-Identifier: MIT
// What a report has measured, kept in a folder: the next report, and one that was stopped, need not measure it again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

private:
    std::filesystem::path folder_;
    std::string program_;  // a digest of its file
};

// The bytes of a file; nothing where there is none. What a report leaves for itself is no input of it (file_guard.h).
std::optional<std::string> kept_bytes(const std::string& path);

}  // namespace lumi::quality
