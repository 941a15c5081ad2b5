// SPDX-License-Identifier: MIT
#include "store/settings_codec.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>

namespace lumi::baker
{
namespace
{

constexpr uint32_t kFootprints = 3;

// "0.5", not "0.500000".
std::string number(float value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string texel_name(format::TexelFormat texel)
{
    constexpr const char* kNames[] = {"rgb888", "rgb565", "palette8", "luma8", "unknown"};
    static_assert(static_cast<int>(format::TexelFormat::rgb888) == 0 &&
                      static_cast<int>(format::TexelFormat::luma8) == 3 &&
                      std::size(kNames) == format::kTexelFormats + 1,
                  "names in the order of the format's numbers");
    return kNames[static_cast<size_t>(texel)];
}

std::string footprint_name(Footprint footprint)
{
    constexpr const char* kNames[] = {"point", "origin", "both", "unknown"};
    static_assert(static_cast<int>(Footprint::point) == 0 && static_cast<int>(Footprint::both) == 2);
    return kNames[static_cast<size_t>(footprint)];
}

std::string texel_name(format::GuidedTexel texel)
{
    switch (texel) {
        case format::GuidedTexel::none:
            return "none";
        case format::GuidedTexel::index4:
            return "4 bits";
        case format::GuidedTexel::index8:
            return "8 bits";
        case format::GuidedTexel::vq8:
            return "blocks";
    }
    return "unknown";
}

std::string format_name(format::MeanFormat format)
{
    return format == format::MeanFormat::rgb565 ? "rgb565" : "palette8";
}

std::string focus_name(const std::optional<std::array<float, 3>>& focus)
{
    return focus ? number((*focus)[0]) + "," + number((*focus)[1]) + "," + number((*focus)[2]) : "the centre";
}

std::string layout_name(const AnySettings& settings)
{
    const GuidedSettings* guided = std::get_if<GuidedSettings>(&settings);
    return guided == nullptr ? "chord" : guided->surface == format::GuidedSurface::focus ? "focus" : "guided";
}

std::string first_of(std::initializer_list<std::string> texts)
{
    const auto found = std::find_if(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); });
    return found == texts.end() ? std::string() : *found;
}

std::string difference(const BakeSettings& there, const BakeSettings& here)
{
    // All members, so that a new one is not forgotten here and in put().
    const auto& [origins, directions, used_origins, texel, samples, max_error_levels, seed, threads, footprint] = here;
    static_cast<void>(threads);
    return first_of({other("origins", there.origins, origins), other("directions", there.directions, directions),
                     other("cap", there.used_origins, used_origins),
                     other("texels", texel_name(there.texel), texel_name(texel)),
                     other("footprint", footprint_name(there.footprint), footprint_name(footprint)),
                     other("samples", there.samples, samples),
                     other("greatest error", number(there.max_error_levels), number(max_error_levels)),
                     other("seed", there.seed, seed)});
}

std::string difference(const GuidedSettings& there, const GuidedSettings& here)
{
    const auto& [origins, used_origins, chart_size, texel, surface, proxy_triangles, mean_resolution, mean_format,
                 occlusion, focus, focus_radius, samples, jitter, seed, threads] = here;
    static_cast<void>(threads);
    static_cast<void>(surface);  // names the layout
    const auto with = [](bool has) { return std::string(has ? "with" : "without"); };
    return first_of({other("origins", there.origins, origins), other("cap", there.used_origins, used_origins),
                     other("chart", there.chart_size, chart_size),
                     other("texels", texel_name(there.texel), texel_name(texel)),
                     other("proxy triangles", there.proxy_triangles, proxy_triangles),
                     other("mean resolution", there.mean_resolution, mean_resolution),
                     other("mean format", format_name(there.mean_format), format_name(mean_format)),
                     other("occlusion", with(there.occlusion), with(occlusion)),
                     other("focus", focus_name(there.focus), focus_name(focus)),
                     other("focus radius", number(there.focus_radius), number(focus_radius)),
                     other("samples", there.samples, samples), other("jitter", number(there.jitter), number(jitter)),
                     other("seed", there.seed, seed)});
}

void put(ByteWriter& out, const BakeSettings& s)
{
    for (const uint32_t v : {s.origins, s.directions, s.used_origins, static_cast<uint32_t>(s.texel), s.samples,
                             static_cast<uint32_t>(s.footprint)}) {
        out.put32(v);
    }
    out.put_float(s.max_error_levels);
    out.put64(s.seed);
}

void put(ByteWriter& out, const GuidedSettings& s)
{
    for (const uint32_t v :
         {s.origins, s.used_origins, s.chart_size, static_cast<uint32_t>(s.texel), static_cast<uint32_t>(s.surface),
          s.proxy_triangles, s.mean_resolution, static_cast<uint32_t>(s.mean_format), uint32_t{s.occlusion}, s.samples,
          uint32_t{s.focus.has_value()}}) {
        out.put32(v);
    }
    for (const float v : s.focus.value_or(std::array<float, 3>{})) {
        out.put_float(v);
    }
    out.put_float(s.focus_radius);
    out.put_float(s.jitter);
    out.put64(s.seed);
}

template <class Enum>
Enum get_enum(ByteReader& in, uint32_t count)
{
    return static_cast<Enum>(std::min(in.get32(), count));
}

BakeSettings get_chord(ByteReader& in)
{
    BakeSettings s;
    for (uint32_t* v : {&s.origins, &s.directions, &s.used_origins}) {
        *v = in.get32();
    }
    s.texel = get_enum<format::TexelFormat>(in, format::kTexelFormats);
    s.samples = in.get32();
    s.footprint = get_enum<Footprint>(in, kFootprints);
    s.max_error_levels = in.get_float();
    s.seed = in.get64();
    s.threads = 0;
    return s;
}

GuidedSettings get_guided(ByteReader& in)
{
    GuidedSettings s;
    for (uint32_t* v : {&s.origins, &s.used_origins, &s.chart_size}) {
        *v = in.get32();
    }
    s.texel = get_enum<format::GuidedTexel>(in, format::kGuidedTexels);
    s.surface = get_enum<format::GuidedSurface>(in, format::kGuidedSurfaces);
    s.proxy_triangles = in.get32();
    s.mean_resolution = in.get32();
    s.mean_format = get_enum<format::MeanFormat>(in, format::kMeanFormats);
    s.occlusion = in.get32() != 0;
    s.samples = in.get32();
    const bool has_focus = in.get32() != 0;
    std::array<float, 3> focus;
    for (float& v : focus) {
        v = in.get_float();
    }
    s.focus = has_focus ? std::optional(focus) : std::nullopt;
    s.focus_radius = in.get_float();
    s.jitter = in.get_float();
    s.seed = in.get64();
    s.threads = 0;
    return s;
}

}  // namespace

std::string other(const char* what, const std::string& there, const std::string& here)
{
    return there == here ? std::string() : std::string("other ") + what + ": " + there + " there, " + here + " here";
}

std::string other(const char* what, uint64_t there, uint64_t here)
{
    return other(what, std::to_string(there), std::to_string(here));
}

void put_settings(ByteWriter& out, const AnySettings& settings)
{
    const size_t end = out.bytes().size() + kSettingsBytes;
    out.put32(static_cast<uint32_t>(settings.index()));
    std::visit([&](const auto& s) { put(out, s); }, settings);
    while (out.bytes().size() < end) {
        out.put8(0);
    }
}

AnySettings get_settings(ByteReader& in)
{
    return in.get32() == 0 ? AnySettings(get_chord(in)) : AnySettings(get_guided(in));
}

std::string settings_difference(const AnySettings& there, const AnySettings& here)
{
    const std::string layout = other("layout", layout_name(there), layout_name(here));
    if (!layout.empty()) {
        return layout;
    }
    const BakeSettings* chord = std::get_if<BakeSettings>(&here);
    return chord != nullptr ? difference(std::get<BakeSettings>(there), *chord)
                            : difference(std::get<GuidedSettings>(there), std::get<GuidedSettings>(here));
}

}  // namespace lumi::baker
