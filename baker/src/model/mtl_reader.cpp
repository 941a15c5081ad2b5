// SPDX-License-Identifier: MIT
#include "model/mtl_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include "lumi/baker/scene.h"
#include "material/material.h"
#include "model/losses.h"
#include "model/mtl_colours.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

struct NumberRule {
    const char* keyword;
    size_t count;
    double low, high;  // outside: a warning, the value is clamped later
};

// Besides those of kMaterialParameters.
constexpr NumberRule kOtherRules[] = {{"Ks", 3, 0, 1}, {"Ns", 1, 0, 1e9}, {"Tr", 1, 0, 1}};

// Keywords of pictures that are drawn, and keywords that change a surface but are not drawn.
constexpr const char* kPictures[] = {"map_Kd", "map_Ks", "map_Ke", "map_Pr",   "map_Pm",  "map_Ps",
                                     "map_d",  "norm",   "bump",   "map_Bump", "map_bump"};
constexpr const char* kIgnored[] = {"map_Ns", "disp", "decal", "refl", "map_Tr"};
// Keywords that take something else, and those that change nothing in a traced picture.
constexpr const char* kOtherWords[] = {"newmtl", "illum", "Ka", "map_Ka", "Km", "sharpness", "map_aat", "Tf"};

// Before a picture's name, with so many words at most.
struct MapOption {
    const char* name;
    size_t most;
};
constexpr MapOption kMapOptions[] = {
    {"-s", 3},      {"-o", 3},      {"-t", 3},     {"-mm", 2},      {"-bm", 1},   {"-boost", 1},      {"-texres", 1},
    {"-blendu", 1}, {"-blendv", 1}, {"-clamp", 1}, {"-imfchan", 1}, {"-type", 1}, {"-colorspace", 1}, {"-cc", 1},
};

template <size_t Size>
bool is_one_of(const char* const (&list)[Size], const std::string& word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

NumberRule rule_of(const std::string& keyword)
{
    for (const MaterialParameter& p : kMaterialParameters) {
        // An index of at most 1 stands for the default.
        const double low = p.member == decltype(p.member)(&MaterialNumbers::index) ? 0 : p.low;
        if (p.mtl && keyword == p.mtl) return {p.mtl, p.member.index() == 0 ? 3u : 1u, low, p.high};
    }
    const auto* rule = std::find_if(std::begin(kOtherRules), std::end(kOtherRules),
                                    [&](const NumberRule& r) { return keyword == r.keyword; });
    return rule == std::end(kOtherRules) ? NumberRule{nullptr, 0, 0, 0} : *rule;
}

std::vector<std::string> all_keywords()
{
    std::vector<std::string> all(std::begin(kPictures), std::end(kPictures));
    all.insert(all.end(), std::begin(kIgnored), std::end(kIgnored));
    all.insert(all.end(), std::begin(kOtherWords), std::end(kOtherWords));
    for (const NumberRule& rule : kOtherRules) all.emplace_back(rule.keyword);
    for (const MaterialParameter& p : kMaterialParameters)
        if (p.mtl) all.emplace_back(p.mtl);
    return all;
}

// Every word of MTL as it is written, and in small letters where no other word is written so.
std::map<std::string, std::string> keywords_by_spelling()
{
    std::map<std::string, std::string> result;
    for (const std::string& keyword : all_keywords()) result[keyword] = keyword;
    for (const std::string& keyword : all_keywords()) result.try_emplace(in_small_letters(keyword), keyword);
    return result;
}

// As it is, or else with the capitals that it should have; empty if MTL has no such word.
std::string known_keyword(const std::string& word)
{
    static const std::map<std::string, std::string> keywords = keywords_by_spelling();
    if (const auto as_is = keywords.find(word); as_is != keywords.end()) return as_is->second;
    const auto found = keywords.find(in_small_letters(word));
    return found == keywords.end() ? "" : found->second;
}

// Beyond kMost no pixel would be found again.
float sound(double number, float fallback)
{
    constexpr double kMost = 1e6;
    return std::abs(number) <= kMost ? static_cast<float>(number) : fallback;
}

// What stands behind an option: numbers as far as there are any, or a word.
std::vector<double> take_numbers(const MapOption& option, std::string_view& text)
{
    std::vector<double> numbers;
    double number = 0;
    for (std::string_view rest = text; numbers.size() < option.most && parse_finite(take_word(rest), number);
         text = rest)
        numbers.push_back(number);
    return numbers;
}

void apply(const std::string_view& option, const std::vector<double>& numbers, MtlMap& map)
{
    const auto number = [&](size_t k, float fallback) {
        return k < numbers.size() ? sound(numbers[k], fallback) : fallback;
    };
    if (option == "-s") map.scale = {number(0, 1), number(1, 1)};
    if (option == "-o") map.offset = {number(0, 0), number(1, 0)};
    if (option == "-bm") map.strength = number(0, 1);
}

MtlMap map_of(const Line& line)
{
    std::string argument = line.argument;
    std::replace(argument.begin(), argument.end(), '\\', '/');
    std::string_view rest = argument;
    MtlMap map;
    map.line = line.number;
    for (;;) {
        std::string_view after = rest;
        const std::string_view word = take_word(after);
        const auto* option = std::find_if(std::begin(kMapOptions), std::end(kMapOptions),
                                          [&](const MapOption& o) { return word == o.name; });
        if (option == std::end(kMapOptions)) break;
        rest = after;
        const std::vector<double> numbers = take_numbers(*option, rest);
        if (numbers.empty()) take_word(rest);
        apply(word, numbers, map);
    }
    map.name = std::string(rest);
    return map;
}

class MtlReader
{
public:
    explicit MtlReader(const std::filesystem::path& file) : file_(file) {}

    void take(Line& line)
    {
        const std::string keyword = known_keyword(line.keyword);
        if (keyword.empty()) {
            losses_.add_at(line.number, "line(s) begin with '" + line.keyword +
                                            "', which is no word of MTL, and are left out; check the material");
            return;
        }
        if (keyword != line.keyword) {
            losses_.add_at(line.number, "line(s) write '" + line.keyword + "' for '" + keyword +
                                            "', and are read so; write capitals as MTL has them");
            line.keyword = keyword;
        }
        take_known(line);
    }

    // Appends to `warnings`.
    std::vector<MtlMaterial> finish(std::vector<std::string>& warnings)
    {
        losses_.report(file_, warnings);
        return std::move(materials_);
    }

private:
    void take_known(Line& line)
    {
        if (line.keyword == "newmtl") {
            begin(line);
        } else if (is_one_of(kPictures, line.keyword)) {
            if (MtlMap map = map_of(line); !map.name.empty()) current().maps[line.keyword] = std::move(map);
        } else if (line.keyword == "illum") {
            double model = 0;
            take_first(line, model);
            current().illum = static_cast<int>(std::clamp(model, 0.0, 10.0));
        } else if (!is_one_of(kIgnored, line.keyword)) {
            take_numbers_of(line);
        } else if (line.argument != "0" && line.argument.rfind("0.0", 0) != 0) {
            losses_.add_at(line.number,
                           "line(s) '" + line.keyword + "' are not drawn; remove them if the picture looks right");
        }
    }

    MtlMaterial& current() { return skipped_ ? ignored_ : materials_.back(); }
    Place place(const Line& line) const { return {file_.string(), line.number}; }

    void begin(const Line& line)
    {
        if (line.argument.empty()) losses_.add_at(line.number, "material(s) have no name; give them one");
        skipped_ = !names_.insert(line.argument).second;
        if (skipped_) {
            ignored_ = {};
            losses_.add_at(line.number, "material(s) have the name of an earlier one, which counts; rename them");
            return;
        }
        materials_.emplace_back();
        materials_.back().name = line.argument;
        materials_.back().file = file_;
        materials_.back().line = line.number;
    }

    static void take_first(const Line& line, double& value)
    {
        const std::vector<std::string_view> list = words(line.argument);
        if (!list.empty()) parse_finite(list[0], value);
    }

    void take_numbers_of(Line& line)
    {
        const NumberRule rule = rule_of(line.keyword);
        if (rule.count == 0 || !has_plain_numbers(line)) return;
        if (rule.count == 3 && words(line.argument).size() == 1)
            line.argument += " " + line.argument + " " + line.argument;
        constexpr double kMost = 1e30;  // binary32 holds it
        const std::vector<std::string_view> list = words(line.argument);
        std::vector<float> numbers;
        for (const double value : numbers_of(place(line), line, rule.count, rule.count, kMost)) {
            if (value < rule.low || value > rule.high) {
                losses_.add_at(line.number,
                               "number(s) '" + line.keyword + "' are out of range and are clamped; correct them",
                               std::string(list[numbers.size()]));
            }
            numbers.push_back(static_cast<float>(value));
        }
        current().numbers[line.keyword] = rule.count == 3 ? Rgb{numbers[0], numbers[1], numbers[2]} : grey(numbers[0]);
        take_opacity(line, numbers[0]);
    }

    // "d -halo 0.5" is drawn as "d 0.5".
    bool has_plain_numbers(Line& line)
    {
        const std::vector<std::string_view> list = words(line.argument);
        const std::string first(list.empty() ? "" : list[0]);
        if (first == "xyz" || first == "spectral") {
            losses_.add_at(line.number,
                           "colour(s) are given as '" + first + "', and are left out; give red, green and blue");
            return false;
        }
        if (first == "-halo") {
            losses_.add_at(line.number, "opacities '-halo' are drawn alike from all sides; remove the word");
            line.argument = line.argument.substr(first.size());
        }
        return true;
    }

    void take_opacity(const Line& line, float value)
    {
        MtlMaterial& material = current();
        if (line.keyword == "d") material.opacity = value;
        if (line.keyword == "Tr" && !material.has("d")) material.opacity = 1 - value;
        if (line.keyword == "Tr" && material.has("d"))
            losses_.add_at(line.number, "material(s) have both 'd' and 'Tr', of which 'd' counts; remove one");
        else if (line.keyword == "Tr" && value >= 1)
            losses_.add_at(line.number,
                           "material(s) are invisible by 'Tr 1'; some programs mean opaque, then write 'd 1'");
        else if (line.keyword == "d" && value <= 0)
            losses_.add_at(line.number, "material(s) are invisible by 'd 0'; write 'd 1' if that is not meant");
    }

    const std::filesystem::path& file_;
    std::vector<MtlMaterial> materials_;
    std::set<std::string> names_;
    Losses losses_;
    MtlMaterial ignored_;  // takes what stands before the first material or in a double one
    bool skipped_ = true;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file, std::vector<std::string>& warnings,
                                  ColourScale colours)
{
    MtlReader reader(file);
    const std::string text = read_text(file);
    for_each_line(text, [&](Line& line) { reader.take(line); });
    std::vector<MtlMaterial> materials = reader.finish(warnings);
    if (colours == ColourScale::display) std::for_each(materials.begin(), materials.end(), linearise);
    if (colours == ColourScale::unstated && look_displayed(text, materials)) {
        warnings.push_back(at({file.string()},
                              "its colours look as if they were stated for a display, and are taken for linear light; "
                              "say --colours display, or --colours linear if they are right"));
    }
    return materials;
}

}  // namespace lumi::baker
