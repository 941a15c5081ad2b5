// SPDX-License-Identifier: MIT
#include "model/mtl_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include "lumi/baker/scene.h"
#include "material/material.h"
#include "model/losses.h"
#include "model/mtl_colours.h"
#include "model/tiny_obj.h"
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
                                     "map_d",  "norm",   "bump",   "map_bump", "map_Bump"};
constexpr const char* kIgnored[] = {"map_Ns", "disp", "decal", "refl", "map_Tr"};
// Keywords that take something else, and those that change nothing in a traced picture.
constexpr const char* kOtherWords[] = {"newmtl", "illum", "Ka", "map_Ka", "Km", "sharpness", "map_aat", "Tf"};

// An option stands before a picture's name, and has so many words at most.
struct MapOption {
    const char* name;
    size_t most;
    const char* fallback = nullptr;  // for a number that is missing or unsound; null: the option is not drawn
};
constexpr MapOption kMapOptions[] = {
    {"-s", 3, " 1"}, {"-o", 3, " 0"}, {"-bm", 1, " 0"},   {"-t", 3},      {"-mm", 2},
    {"-boost", 1},   {"-texres", 1},  {"-blendu", 1},     {"-blendv", 1}, {"-clamp", 1},
    {"-imfchan", 1}, {"-type", 1},    {"-colorspace", 1}, {"-cc", 1},
};

// A material has one bump map: that of the word which stands later here, whatever the order of their lines.
constexpr const char* kBumps[] = {"bump", "map_bump", "map_Bump"};

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
bool is_sound(double number)
{
    constexpr double kMost = 1e6;
    return std::abs(number) <= kMost;
}

// Takes what stands behind an option off the front of `text`: numbers as far as there are any, or else a word. Appends
// the option to `out` if it is drawn, with as many numbers as tinyobjloader takes, which would else read on into the
// name.
void take_option(const MapOption& option, std::string_view& text, std::string& out)
{
    std::string numbers;
    size_t count = 0;
    double number = 0;
    for (std::string_view rest = text; count < option.most; text = rest, ++count) {
        const std::string_view word = take_word(rest);
        if (!parse_finite(word, number)) break;
        if (is_sound(number))
            append_number(numbers, word, number);
        else
            numbers += option.fallback;
    }
    if (count == 0) take_word(text);
    if (!option.fallback) return;
    for (; count < option.most; ++count) numbers += option.fallback;
    out += option.name + numbers + ' ';
}

// The options that are drawn and the picture's name, as tinyobjloader reads them; empty where there is no name.
std::string map_text(std::string argument)
{
    std::replace(argument.begin(), argument.end(), '\\', '/');
    std::string_view rest = argument;
    std::string text = "-s 1 1 1 -o 0 0 0 -bm 1 ";  // else those of an earlier line with the same word would count
    for (;;) {
        std::string_view after = rest;
        const std::string_view word = take_word(after);
        const auto* option = std::find_if(std::begin(kMapOptions), std::end(kMapOptions),
                                          [&](const MapOption& o) { return word == o.name; });
        if (option == std::end(kMapOptions)) break;
        rest = after;
        take_option(*option, rest, text);
    }
    return rest.empty() ? "" : text.append(rest);
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
        end_material();
        mend_transparency();
        losses_.report(file_, warnings);
        return std::move(materials_);
    }

private:
    // MeshLab writes 'Tr 1' for what is opaque. Nobody exports a file of which nothing is seen.
    void mend_transparency()
    {
        const bool all =
            doubts_.size() >= materials_.size() &&
            std::all_of(materials_.begin(), materials_.end(), [](const MtlMaterial& m) { return m.opacity <= 0; });
        if (!all) {
            for (const auto& [line, text] : doubts_) losses_.add_at(line, text);
            return;
        }
        for (MtlMaterial& m : materials_) m.opacity = 1;
        for (const auto& [line, text] : doubts_)
            losses_.add_at(line,
                           "material(s), all of the file, would be invisible by 'Tr 1' and are drawn opaque; "
                           "write 'd 1', or 'd 0' where that is not meant");
    }

    void take_known(Line& line)
    {
        if (line.keyword == "newmtl") {
            begin(line);
        } else if (is_one_of(kPictures, line.keyword)) {
            take_map(line);
        } else if (line.keyword == "illum") {
            double model = 0;
            take_first(line, model);
            text_ += "illum " + std::to_string(static_cast<int>(std::clamp(model, 0.0, 10.0))) + '\n';
        } else if (!is_one_of(kIgnored, line.keyword)) {
            take_numbers_of(line);
        } else if (line.argument != "0" && line.argument.rfind("0.0", 0) != 0) {
            losses_.add_at(line.number,
                           "line(s) '" + line.keyword + "' are not drawn; remove them if the picture looks right");
        }
    }

    // Takes what stands before the first material or in a double one, too.
    MtlMaterial& current() { return skipped_ ? ignored_ : materials_.back(); }
    Place place(const Line& line) const { return {file_.string(), line.number}; }

    // tinyobjloader reads one material at a time: it does not say which line made which.
    void end_material()
    {
        if (!skipped_) read_mtl_text(text_, materials_.back());
        text_.clear();
        bump_rank_ = 0;
    }

    void begin(const Line& line)
    {
        end_material();
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
        text_ = "newmtl " + line.argument + '\n';
    }

    void take_map(const Line& line)
    {
        const std::string text = map_text(line.argument);
        if (text.empty()) return;
        const char* const* bump = std::find(std::begin(kBumps), std::end(kBumps), line.keyword);
        const bool is_bump = bump != std::end(kBumps);
        if (is_bump && bump - kBumps < bump_rank_) return;
        if (is_bump) bump_rank_ = bump - kBumps;
        const std::string keyword = is_bump ? kBumps[0] : line.keyword;
        current().maps[keyword].line = line.number;
        text_ += keyword + ' ' + text + '\n';
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
        const std::vector<double> numbers = numbers_of(place(line), line, rule.count, rule.count, kMost);
        text_ += line.keyword;
        for (size_t k = 0; k < rule.count; ++k) {
            if (numbers[k] < rule.low || numbers[k] > rule.high) {
                losses_.add_at(line.number,
                               "number(s) '" + line.keyword + "' are out of range and are clamped; correct them",
                               std::string(list[k]));
            }
            append_number(text_, list[k], numbers[k]);
        }
        text_ += '\n';
        current().numbers[line.keyword] = {};
        doubt_opacity(line, numbers[0]);
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

    void doubt_opacity(const Line& line, double value)
    {
        if (line.keyword == "Tr" && current().has("d"))
            losses_.add_at(line.number, "material(s) have both 'd' and 'Tr', of which 'd' counts; remove one");
        else if (line.keyword == "Tr" && value >= 1)
            doubts_.emplace_back(line.number,
                                 "material(s) are invisible by 'Tr 1'; some programs mean opaque, then write 'd 1'");
        else if (line.keyword == "d" && value <= 0)
            losses_.add_at(line.number, "material(s) are invisible by 'd 0'; write 'd 1' if that is not meant");
    }

    const std::filesystem::path& file_;
    std::vector<MtlMaterial> materials_;
    std::set<std::string> names_;
    Losses losses_;
    std::vector<std::pair<uint32_t, std::string>> doubts_;  // lines of 'Tr 1', and what they cost
    std::string text_;                                      // the sound lines of the material
    MtlMaterial ignored_;
    bool skipped_ = true;
    ptrdiff_t bump_rank_ = 0;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file, std::vector<std::string>& warnings,
                                  ColourScale colours)
{
    MtlReader reader(file);
    const std::string text = read_text(file);
    Lines lines(text);
    for (Line line; lines.next(line);) reader.take(line);
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
