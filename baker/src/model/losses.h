// SPDX-License-Identifier: MIT
// What a reader of a model leaves out, counted: one warning for each kind.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "util/text_lines.h"

namespace lumi::baker
{

class Losses
{
public:
    // `kind` goes on after the count, and says the mend: "normal map(s) are left out; ...".
    void add(const std::string& kind, size_t count = 1) { counts_[kind] += count; }

    void report(const std::filesystem::path& file, std::vector<std::string>& warnings) const
    {
        for (const auto& [kind, count] : counts_)
            if (count != 0) warnings.push_back(at({file.string()}, std::to_string(count) + " " + kind));
    }

private:
    std::map<std::string, size_t> counts_;
};

}  // namespace lumi::baker
