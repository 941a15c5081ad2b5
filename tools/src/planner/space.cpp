// SPDX-License-Identifier: MIT
#include "planner/space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "files/field_file.h"

namespace lumi::planner
{

namespace
{

constexpr std::array<uint32_t, 12> kOrigins = {64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048, 4096};
constexpr std::array<uint32_t, 8> kTriangles = {500, 1000, 1500, 2000, 3000, 4000, 6000, 8000};
constexpr std::array<uint32_t, 12> kMeans = {16, 24, 32, 48, 64, 80, 96, 112, 128, 160, 192, 240};
constexpr std::array<format::MeanFormat, 2> kMeanFormats = {format::MeanFormat::palette8, format::MeanFormat::rgb565};
constexpr std::array<format::GuidedTexel, 4> kTexels = {format::GuidedTexel::index4, format::GuidedTexel::index8,
                                                        format::GuidedTexel::none, format::GuidedTexel::vq8};
constexpr std::array<uint32_t, 6> kCapPercent = {50, 60, 70, 80, 90, 100};
constexpr std::array<float, 5> kFocusRadii = {0, 0.25f, 0.5f, 0.75f, 0.9f};  // radii of the sphere
constexpr std::array<double, 5> kShapes = {0.25, 0.5, 1, 2, 4};              // N/M

// The coordinates of the families by their names, which are also what people read.
constexpr const char kOriginsName[] = "origins", kTrianglesName[] = "triangles", kMeanName[] = "mean",
                     kResolutionName[] = "mean resolution", kFormatName[] = "mean format", kTexelName[] = "texels",
                     kOcclusionName[] = "occlusion", kCapName[] = "cap", kFocusName[] = "focus radius",
                     kShapeName[] = "directions per origin", kChordTexelName[] = "texel";

constexpr double kMegabyte = 1e6;

template <class Values>
size_t nearest_index(const Values& values, double wanted)
{
    size_t best = 0;
    for (size_t k = 1; k < values.size(); ++k)
        if (std::abs(static_cast<double>(values[k]) - wanted) < std::abs(static_cast<double>(values[best]) - wanted))
            best = k;
    return best;
}

// A list of numbers, or the one that was set by hand.
template <class Values>
Coordinate numbers(const char* name, const Values& values, std::optional<uint32_t> by_hand, double start)
{
    if (by_hand) return {name, {std::to_string(*by_hand)}, 0, true};
    Coordinate coordinate = {name, {}, nearest_index(values, start), true};
    for (const uint32_t value : values) coordinate.choices.push_back(std::to_string(value));
    return coordinate;
}

constexpr size_t kOpen = SIZE_MAX;

// A list of words, or the one that was set by hand; kOpen: none was.
Coordinate words(const char* name, std::vector<std::string> choices, size_t by_hand)
{
    if (by_hand != kOpen) choices = {choices[by_hand]};
    return {name, std::move(choices), 0, false};
}

template <class Values, class Value>
size_t place_of(const Values& values, const std::optional<Value>& value)
{
    return value ? static_cast<size_t>(std::find(values.begin(), values.end(), *value) - values.begin()) : kOpen;
}

Coordinate cap_coordinate(const Task& task)
{
    constexpr double kStartPercent =
        90;  // a level eye at 2.5 radii looks through the upper 85 % of the origins' heights
    Coordinate cap = {kCapName, {"100"}, 0, true};
    if (task.by_hand.cap || task.views == quality::ViewSet::all) return cap;
    cap = numbers(kCapName, kCapPercent, std::nullopt, kStartPercent);
    return cap;
}

// Where the walk starts: tables of measured plans, interpolated.
double start_origins(double megabytes)
{
    constexpr double kOfOneMegabyte = 128;
    return std::clamp<double>(kOfOneMegabyte * megabytes, kOrigins.front(), kOrigins.back());
}

// 51, 79, 94, 112, 133, 158 for 0.1, 0.25, 0.5, 1, 2, 4 MB.
double start_resolution(double megabytes)
{
    constexpr double kOfOneMegabyte = 112, kPower = 0.25;
    constexpr double kOfLittle = 160;  // its voxels then take a quarter of the flash; they grow with the square
    return std::min(kOfOneMegabyte * std::pow(megabytes, kPower), kOfLittle * std::sqrt(megabytes));
}

double start_triangles(double megabytes)
{
    return megabytes < 0.1 ? 1000 : megabytes < 0.2 ? 2000 : 4000;
}

Family guided_family(const Task& task)
{
    const ByHand& set = task.by_hand;
    const double megabytes = static_cast<double>(task.budget_bytes) / kMegabyte;
    const bool no_mean = set.mean_resolution == 0u;
    const auto resolution = no_mean ? std::optional<uint32_t>(kMeans.front()) : set.mean_resolution;
    const size_t with_mean = !set.mean_resolution ? kOpen : no_mean ? 1 : 0;
    const size_t occlusion = !set.occlusion ? kOpen : *set.occlusion ? 0 : 1;
    return {name_of(Layout::guided),
            {numbers(kOriginsName, kOrigins, set.origins, start_origins(megabytes)),
             numbers(kResolutionName, kMeans, resolution, start_resolution(megabytes)),
             numbers(kTrianglesName, kTriangles, set.triangles, start_triangles(megabytes)),
             words(kTexelName, {"4", "8", "none", "vq8"}, place_of(kTexels, set.texel)),
             words(kFormatName, {"palette8", "rgb565"}, place_of(kMeanFormats, set.mean_format)),
             words(kOcclusionName, {"with", "without"}, occlusion), words(kMeanName, {"with", "without"}, with_mean),
             cap_coordinate(task)}};
}

Family focus_family(const Task& task)
{
    constexpr double kOriginsOfOneMegabyte = 512;  // nothing tells depths, so origins must stand closer
    const ByHand& set = task.by_hand;
    const double megabytes = static_cast<double>(task.budget_bytes) / kMegabyte;
    Coordinate radius = {kFocusName, {}, 0, true};
    for (const float share : kFocusRadii)
        radius.choices.push_back(std::to_string(static_cast<int>(100 * share)) + " %");
    if (set.focus_radius || set.focus) radius = {kFocusName, {"as set"}, 0, true};
    return {name_of(Layout::focus),
            {numbers(kOriginsName, kOrigins, set.origins, kOriginsOfOneMegabyte * megabytes), radius,
             words(kTexelName, {"4", "8"}, place_of(kTexels, set.texel)), cap_coordinate(task)}};
}

Family chord_family(const Task& task)
{
    const ByHand& set = task.by_hand;
    Coordinate shape = {kShapeName, {}, 2, true};
    for (const double share : kShapes)
        shape.choices.push_back(share < 1 ? "1/" + std::to_string(std::lround(1 / share))
                                          : std::to_string(std::lround(share)));
    if (set.origins || set.directions) shape = {kShapeName, {"1"}, 0, true};
    Coordinate texel = words(kChordTexelName, {"palette8", "rgb565"}, kOpen);
    if (set.chord_texel) texel = {kChordTexelName, {tools::name_of(*set.chord_texel)}, 0, false};
    return {name_of(Layout::chord), {shape, texel, cap_coordinate(task)}};
}

// What the candidate chose for a coordinate.
class Chosen
{
public:
    Chosen(const Family& family, const Candidate& candidate) : family_(family), candidate_(candidate) {}

    const std::string& operator[](const char* name) const
    {
        for (size_t c = 0; c < family_.coordinates.size(); ++c)
            if (family_.coordinates[c].name == name) return family_.coordinates[c].choices[candidate_.choice[c]];
        throw std::logic_error(std::string("a family without ") + name);
    }
    uint32_t number(const char* name) const { return static_cast<uint32_t>(std::stoul((*this)[name])); }

private:
    const Family& family_;
    const Candidate& candidate_;
};

uint32_t used_of(const Task& task, const Chosen& chosen, uint32_t origins)
{
    constexpr uint32_t kHundred = 100;
    if (task.by_hand.cap) return task.by_hand.cap(origins);
    return (origins * chosen.number(kCapName) + kHundred - 1) / kHundred;
}

format::GuidedTexel texel_named(const std::string& bits)
{
    return bits == "4"     ? format::GuidedTexel::index4
           : bits == "8"   ? format::GuidedTexel::index8
           : bits == "vq8" ? format::GuidedTexel::vq8
                           : format::GuidedTexel::none;
}

Plan guided_plan(const Task& task, const Chosen& chosen, Layout layout)
{
    Plan plan;
    plan.layout = layout;
    baker::GuidedSettings& s = plan.guided;
    s.origins = chosen.number(kOriginsName);
    s.used_origins = used_of(task, chosen, s.origins);
    s.texel = texel_named(chosen[kTexelName]);
    s.chart_size = task.by_hand.chart_size.value_or(format::kMinChart);
    s.jitter = task.by_hand.jitter.value_or(s.jitter);
    s.samples = task.samples;
    s.seed = task.seed;
    s.threads = task.threads;
    return plan;
}

Plan surface_plan(const Task& task, const Chosen& chosen)
{
    Plan plan = guided_plan(task, chosen, Layout::guided);
    baker::GuidedSettings& s = plan.guided;
    s.surface = format::GuidedSurface::proxy;
    s.proxy_triangles = chosen.number(kTrianglesName);
    s.mean_resolution = chosen[kMeanName] == "with" ? chosen.number(kResolutionName) : 0;
    s.mean_format = chosen[kFormatName] == "rgb565" ? format::MeanFormat::rgb565 : format::MeanFormat::palette8;
    s.occlusion = chosen[kOcclusionName] == "with";
    return plan;
}

Plan focus_plan(const Task& task, const Chosen& chosen, size_t radius)
{
    Plan plan = guided_plan(task, chosen, Layout::focus);
    plan.guided.surface = format::GuidedSurface::focus;
    plan.guided.mean_resolution = 0;
    plan.guided.occlusion = false;
    plan.guided.focus = task.by_hand.focus;
    plan.guided.focus_radius =
        chosen[kFocusName] == "as set" ? task.by_hand.focus_radius.value_or(0) : kFocusRadii[radius] * task.radius;
    return plan;
}

Plan chord_plan(const Task& task, const Chosen& chosen, size_t shape)
{
    constexpr uint32_t kUnsized = 1000;  // origins; fit_plan() scales both
    Plan plan;
    plan.layout = Layout::chord;
    baker::BakeSettings& s = plan.chord;
    const double ratio = task.by_hand.origins || task.by_hand.directions ? 1 : kShapes[shape];
    s.origins = task.by_hand.origins.value_or(kUnsized);
    s.directions = task.by_hand.directions.value_or(static_cast<uint32_t>(std::lround(kUnsized * ratio)));
    const std::string& texel = chosen[kChordTexelName];
    for (const auto format : {format::TexelFormat::rgb888, format::TexelFormat::rgb565, format::TexelFormat::palette8,
                              format::TexelFormat::luma8})
        if (texel == tools::name_of(format)) s.texel = format;
    s.used_origins = used_of(task, chosen, s.origins);
    s.samples = task.samples;
    s.max_error_levels = task.max_error_levels;
    s.seed = task.seed;
    s.threads = task.threads;
    return plan;
}

size_t place_in(const Family& family, const Candidate& candidate, const char* name)
{
    for (size_t c = 0; c < family.coordinates.size(); ++c)
        if (family.coordinates[c].name == name) return candidate.choice[c];
    throw std::logic_error(std::string("a family without ") + name);
}

}  // namespace

std::vector<Layout> layouts_of(const ByHand& set)
{
    const bool surface = set.triangles || set.mean_resolution || set.mean_format || set.occlusion;
    const bool focus = set.focus_radius || set.focus;
    const bool chart = set.chart_size || set.texel || set.jitter;
    const bool chord = set.directions || set.chord_texel;
    std::vector<Layout> layouts;
    const auto add = [&](Layout layout, bool useless) {
        if (!useless && set.layout.value_or(layout) == layout) layouts.push_back(layout);
    };
    add(Layout::guided, focus || chord);
    const bool no_focus = set.texel == format::GuidedTexel::none || set.texel == format::GuidedTexel::vq8;
    add(Layout::focus, surface || chord || no_focus);
    add(Layout::chord, surface || focus || chart);
    return layouts;
}

std::vector<Family> families_of(const Task& task)
{
    std::vector<Family> families;
    for (const Layout layout : layouts_of(task.by_hand))
        families.push_back(layout == Layout::guided  ? guided_family(task)
                           : layout == Layout::focus ? focus_family(task)
                                                     : chord_family(task));
    return families;
}

Plan plan_of(const Task& task, const std::vector<Family>& families, const Candidate& candidate)
{
    const Family& family = families[candidate.family];
    const Chosen chosen(family, candidate);
    if (family.name == name_of(Layout::guided)) return surface_plan(task, chosen);
    if (family.name == name_of(Layout::focus)) return focus_plan(task, chosen, place_in(family, candidate, kFocusName));
    return chord_plan(task, chosen, place_in(family, candidate, kShapeName));
}

}  // namespace lumi::planner
