// SPDX-License-Identifier: MIT
#include "model/mtl_reader.h"

#include <algorithm>
#include <set>

#include "lumi/baker/scene.h"
#include "material/material.h"
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

std::string_view take_word(std::string_view& text)
{
    const std::string_view word = words(text).empty() ? std::string_view() : words(text)[0];
    const size_t begin = word.empty() ? text.size() : static_cast<size_t>(word.data() - text.data());
    text.remove_prefix(begin + word.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return word;
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
    MtlReader(const std::filesystem::path& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings)
    {
    }

    void take(Line line)
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
            warn(line, "'" + line.keyword + "' is not drawn; remove it if the picture looks right");
        }
    }

    std::vector<MtlMaterial> finish() { return std::move(materials_); }

private:
    MtlMaterial& current() { return skipped_ ? ignored_ : materials_.back(); }
    Place place(const Line& line) const { return {file_.string(), line.number}; }
    void warn(const Line& line, const std::string& text) { warnings_.push_back(at(place(line), text)); }

    void begin(const Line& line)
    {
        if (line.argument.empty()) throw SceneError(at(place(line), "'newmtl' without a name; give the material one"));
        skipped_ = !names_.insert(line.argument).second;
        if (skipped_) {
            ignored_ = {};
            warn(line, "material '" + line.argument + "' is defined twice, the first one counts; rename one");
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
        if (rule.count == 0) return;
        if (rule.count == 3 && words(line.argument).size() == 1)
            line.argument += " " + line.argument + " " + line.argument;
        require_numbers(place(line), line, rule.count, rule.count, 1e30);
        std::vector<float> numbers;
        for (const std::string_view word : words(line.argument)) {
            double value = 0;
            if (!parse_finite(word, value)) continue;
            if (value < rule.low || value > rule.high) {
                warn(line,
                     line.keyword + " " + std::string(word) + " is out of range and is clamped; correct the value");
            }
            numbers.push_back(static_cast<float>(value));
        }
        current().numbers[line.keyword] = rule.count == 3 ? Rgb{numbers[0], numbers[1], numbers[2]} : grey(numbers[0]);
        take_opacity(line, numbers[0]);
    }

    void take_opacity(const Line& line, float value)
    {
        MtlMaterial& material = current();
        if (line.keyword == "d") material.opacity = value;
        if (line.keyword == "Tr" && !material.has("d")) material.opacity = 1 - value;
        if (line.keyword == "Tr" && material.has("d"))
            warn(line, "both 'd' and 'Tr' are given, 'd' counts; remove one");
        else if (line.keyword == "Tr" && value >= 1)
            warn(line, "'Tr 1' makes the material invisible; some programs mean opaque, then write 'd 1'");
        else if (line.keyword == "d" && value <= 0)
            warn(line, "'d 0' makes the material invisible; write 'd 1' if that is not meant");
    }

    const std::filesystem::path& file_;
    std::vector<std::string>& warnings_;
    std::vector<MtlMaterial> materials_;
    std::set<std::string> names_;
    MtlMaterial ignored_;  // takes what stands before the first material or in a double one
    bool skipped_ = true;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    MtlReader reader(file, warnings);
    for (Line& line : split_lines(read_text(file))) reader.take(std::move(line));
    return reader.finish();
}

}  // namespace lumi::baker
