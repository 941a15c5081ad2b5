// SPDX-License-Identifier: MIT
// Checks an OBJ text before it is parsed, and rewrites what parsers stumble over.
//
// Why before: the parser takes "nan" for 0 and an index of a missing vertex for granted, forgets line numbers, and cuts
// names at blanks. Here every fault is found with its line.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "util/text_lines.h"

namespace lumi::baker
{

struct ObjText {
    struct Library {
        std::string name;  // as written, all of the line
        uint32_t line;
    };
    struct Use {
        std::string name;
        uint32_t line;  // where it is used first
    };

    // The same scene with each material name replaced by "m" and its place in `materials`, and without mtllib lines but
    // for one at the top.
    std::string text;
    std::vector<Library> libraries;
    std::vector<Use> materials;
    std::vector<uint32_t> face_lines;  // one a face, in file order
    bool smoothing = false;            // some face lies in a smoothing group
};

// `file` only serves messages. Throws SceneError.
ObjText prepare_obj(const std::string& file, std::string_view text);

// The name that `text` uses for material k.
std::string stand_in_name(size_t k);

}  // namespace lumi::baker
