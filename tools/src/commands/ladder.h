// SPDX-License-Identifier: MIT
// The fields that `lumi report --for` weighs where the caller names none.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lumi/baker/scene.h"

namespace lumi::tools
{

struct LadderSettings {
    std::string folder;     // holds the fields; what is there already is not baked again
    bool is_quick = false;  // fewer sizes, and few light paths: pictures are noisier than those of a bake by default
    unsigned threads = 0;
    std::string scene_words;  // by which `lumi bake` reads the scene so (scene_words.h)
};

struct Ladder {
    std::vector<std::string> fields;           // files, surface fields first
    std::map<std::string, std::string> bakes;  // by file: the options by which `lumi bake` makes one of its size
};

// Surface fields of 60, 120, 250 and 500 kB, without those that the scene cannot have, and chord fields of 0.25, 1 and
// 4 MB, unless parts of the scene move or its light has states, which these do not show. Progress goes to stderr.
// Throws Interrupted; the next call goes on from there.
Ladder baked_ladder(const baker::Scene& scene, const LadderSettings& settings);

}  // namespace lumi::tools
