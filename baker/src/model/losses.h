// SPDX-License-Identifier: MIT
// Counts what a reader of a model leaves out or doubts, and gives one warning for each kind.
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
    void add(const std::string& kind, size_t count = 1) { kinds_[kind].count += count; }
    // The warning names the line of the first one, and which that is where `which` says so.
    void add_at(uint32_t line, const std::string& kind, const std::string& which = "")
    {
        Kind& k = kinds_[kind];
        if (k.count++ != 0) return;
        k.line = line;
        k.first = which.empty() ? "" : " (first: " + which + ")";
    }

    void report(const std::filesystem::path& file, std::vector<std::string>& warnings) const
    {
        for (const auto& [text, kind] : kinds_)
            if (kind.count != 0)
                warnings.push_back(
                    at({file.string(), kind.line}, std::to_string(kind.count) + " " + text + kind.first));
    }

private:
    struct Kind {
        size_t count = 0;
        uint32_t line = 0;
        std::string first;
    };
    std::map<std::string, Kind> kinds_;
};

}  // namespace lumi::baker
