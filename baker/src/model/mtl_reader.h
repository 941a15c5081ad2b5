// SPDX-License-Identifier: MIT
// Reads MTL files. material.h says what their words mean.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lumi/baker/scene.h"
#include "math/vec3.h"

namespace lumi::baker
{

// A picture as MTL names it.
struct MtlMap {
    std::string name;  // with forward slashes
    uint32_t line = 0;
    Vec2 scale = {1, 1}, offset;
    float strength = 1;  // how high bumps are
};

// A material as MTL states it: the last line of each keyword counts.
struct MtlMaterial {
    std::string name;
    std::filesystem::path file;
    uint32_t line = 0;
    std::map<std::string, Rgb> numbers;  // one number is a grey
    std::map<std::string, MtlMap> maps;  // bump for all words of bump maps
    float opacity = 1;                   // by d, or else by Tr
    int illum = 0;

    bool has(const char* keyword) const { return numbers.count(keyword) != 0; }
    Rgb colour(const char* keyword) const { return has(keyword) ? numbers.at(keyword) : Rgb{}; }
    float number(const char* keyword, float fallback) const { return has(keyword) ? numbers.at(keyword).r : fallback; }
    // Null where it has none of that keyword.
    const MtlMap* map(const char* keyword) const { return maps.count(keyword) != 0 ? &maps.at(keyword) : nullptr; }
};

// In the order of the file, in linear light; of two with one name the first. Throws SceneError; appends to `warnings`.
std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file, std::vector<std::string>& warnings,
                                  ColourScale colours = ColourScale::unstated);

}  // namespace lumi::baker
