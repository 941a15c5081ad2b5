// SPDX-License-Identifier: MIT
// Checks an MTL text before it is parsed, and rewrites what the parser stumbles over (see obj_text.h for why).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "util/text_lines.h"

namespace lumi::baker
{

struct MtlText {
    struct Lines {
        uint32_t newmtl = 0;
        std::map<std::string, uint32_t> maps;  // lines of pictures, by keyword
        bool has_kd = false, has_ks = false, has_tf = false, has_pr = false;
    };
    std::string text;                    // backslashes in picture names turned into slashes
    std::map<std::string, Lines> lines;  // by material name
};

// `file` only serves messages. Throws SceneError; appends to `warnings`.
MtlText prepare_mtl(const std::string& file, std::string_view text, std::vector<std::string>& warnings);

}  // namespace lumi::baker
