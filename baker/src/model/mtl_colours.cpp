// SPDX-License-Identifier: MIT
#include "model/mtl_colours.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "image/tone.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

constexpr const char* kColours[] = {"Kd", "Ks", "Ke", "Tf"};
constexpr std::string_view kPrograms[] = {"3ds Max", "SketchUp", "Java3D", "Sweet Home 3D"};

bool is_whole(float value, float steps)
{
    constexpr float kRounding = 1e-4f;  // files with four digits round so
    return std::abs(value - std::round(value * steps) / steps) < kRounding;
}

bool names_a_program(std::string_view text)
{
    return std::any_of(
        std::begin(kPrograms), std::end(kPrograms),
        [&](std::string_view program) {
            const size_t found = text.find(program);
            if (found == std::string_view::npos) return false;
            const size_t line = text.rfind('\n', found) + 1;  // 0 in the first line
            const size_t start = text.find_first_not_of(" \t", line);
            return text[start] == '#';
        });
}

}  // namespace

void linearise(MtlMaterial& material)
{
    for (const char* keyword : kColours) {
        const auto found = material.numbers.find(keyword);
        if (found != material.numbers.end()) found->second = srgb_linear(found->second);
    }
}

bool look_displayed(std::string_view mtl_text, const std::vector<MtlMaterial>& materials)
{
    constexpr float kSteps = 255, kFifths = 5;
    constexpr size_t kFewest = 3, kOdd = 8;  // at least so many telling numbers; one in so many may be no whole step
    std::set<float> telling;
    for (const MtlMaterial& material : materials)
        for (const char* keyword : {"Kd", "Ks"})
            for (const float v : {material.colour(keyword).r, material.colour(keyword).g, material.colour(keyword).b})
                if (v > 0 && v < 1 && !is_whole(v, kFifths)) telling.insert(v);
    if (!telling.empty() && names_a_program(mtl_text)) return true;
    const auto odd = std::count_if(telling.begin(), telling.end(), [&](float v) { return !is_whole(v, kSteps); });
    return telling.size() >= kFewest && static_cast<size_t>(odd) * kOdd <= telling.size();
}

}  // namespace lumi::baker
