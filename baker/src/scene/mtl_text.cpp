// SPDX-License-Identifier: MIT
#include "scene/mtl_text.h"

#include <algorithm>

#include "lumi/baker/scene.h"

namespace lumi::baker
{
namespace
{

struct NumberRule {
    const char* keyword;
    size_t count;
    double low, high;  // outside: a warning, the value is clamped later
};

constexpr double kAnyHigh = 1e9;
constexpr NumberRule kRules[] = {
    {"Kd", 3, 0, 1}, {"Ks", 3, 0, 1},  {"Ke", 3, 0, kAnyHigh}, {"Ns", 1, 0, kAnyHigh}, {"Ni", 1, 0, 4},
    {"d", 1, 0, 1},  {"Tr", 1, 0, 1},  {"Tf", 3, 0, 1},        {"Pr", 1, 0, 1},        {"Pm", 1, 0, 1},
    {"Pc", 1, 0, 1}, {"Pcr", 1, 0, 1}, {"Ps", 1, 0, 1},        {"aniso", 1, 0, 1},     {"anisor", 1, 0, 1},
};

// Keywords of pictures that are drawn, and keywords that change a surface but are not drawn.
constexpr const char* kPictures[] = {"map_Kd", "map_Ks", "map_Ke", "map_Pr",   "map_Pm",  "map_Ps",
                                     "map_d",  "norm",   "bump",   "map_Bump", "map_bump"};
constexpr const char* kIgnored[] = {"map_Ns", "disp", "decal", "refl", "map_Tr"};

template <size_t Size>
bool is_one_of(const char* const (&list)[Size], const std::string& word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

class MtlPreparation
{
public:
    MtlPreparation(const std::string& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {}

    void take(Line line)
    {
        const Place place = {file_, line.number};
        if (line.keyword == "newmtl") {
            begin(place, line);
        } else if (is_one_of(kPictures, line.keyword)) {
            std::replace(line.argument.begin(), line.argument.end(), '\\', '/');
            current().maps[line.keyword] = line.number;
        } else if (is_one_of(kIgnored, line.keyword) && line.argument != "0" && line.argument.rfind("0.0", 0) != 0) {
            warnings_.push_back(at(place, "'" + line.keyword + "' is not drawn; remove it if the picture looks right"));
            return;
        } else {
            check_numbers(place, line);
        }
        out_.text += line.keyword + " " + line.argument + "\n";
    }

    MtlText finish() { return std::move(out_); }

private:
    MtlText::Lines& current() { return skipped_ ? ignored_ : out_.lines[name_]; }

    void begin(const Place& place, const Line& line)
    {
        if (line.argument.empty()) throw SceneError(at(place, "'newmtl' without a name; give the material one"));
        name_ = line.argument;
        skipped_ = out_.lines.count(name_) != 0;
        if (skipped_) {
            warnings_.push_back(
                at(place, "material '" + name_ + "' is defined twice, the first one counts; rename one"));
        }
        current().newmtl = line.number;
        dissolve_ = transparency_ = false;
    }

    void check_numbers(const Place& place, Line& line)
    {
        const auto* rule = std::find_if(std::begin(kRules), std::end(kRules),
                                        [&](const NumberRule& r) { return line.keyword == r.keyword; });
        if (rule == std::end(kRules)) return;
        spread_grey(line, rule->count);
        require_numbers(place, line, rule->count, rule->count, 1e30);
        for (const std::string_view word : words(line.argument)) {
            double value = 0;
            if (parse_finite(word, value) && (value < rule->low || value > rule->high)) {
                warnings_.push_back(at(place, line.keyword + " " + std::string(word) +
                                                  " is out of range and is clamped; correct the value"));
            }
        }
        current().has_kd = current().has_kd || line.keyword == "Kd";
        current().has_ks = current().has_ks || line.keyword == "Ks";
        current().has_tf = current().has_tf || line.keyword == "Tf";
        current().has_pr = current().has_pr || line.keyword == "Pr";
        check_opacity(place, line);
    }

    // One number for a colour means grey.
    static void spread_grey(Line& line, size_t count)
    {
        if (count == 3 && words(line.argument).size() == 1) line.argument += " " + line.argument + " " + line.argument;
    }

    void check_opacity(const Place& place, const Line& line)
    {
        dissolve_ = dissolve_ || line.keyword == "d";
        transparency_ = transparency_ || line.keyword == "Tr";
        double value = 0;
        parse_finite(words(line.argument)[0], value);
        if (line.keyword == "Tr" && dissolve_) {
            warnings_.push_back(at(place, "both 'd' and 'Tr' are given, 'd' counts; remove one"));
        } else if (line.keyword == "Tr" && value >= 1) {
            warnings_.push_back(
                at(place, "'Tr 1' makes the material invisible; some programs mean opaque, then write 'd 1'"));
        } else if (line.keyword == "d" && value <= 0) {
            warnings_.push_back(at(place, "'d 0' makes the material invisible; write 'd 1' if that is not meant"));
        }
    }

    std::string file_;
    std::vector<std::string>& warnings_;
    MtlText out_;
    std::string name_;
    MtlText::Lines ignored_;
    bool skipped_ = true, dissolve_ = false, transparency_ = false;
};

}  // namespace

MtlText prepare_mtl(const std::string& file, std::string_view text, std::vector<std::string>& warnings)
{
    MtlPreparation preparation(file, warnings);
    for (Line& line : split_lines(text)) preparation.take(std::move(line));
    return preparation.finish();
}

}  // namespace lumi::baker
