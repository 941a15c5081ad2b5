// SPDX-License-Identifier: MIT
#include "store/settings_codec.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>

#include "lumi/chord/texel.h"
namespace lumi::baker
{
namespace
{

constexpr uint32_t kFootprints = 3, kBeams = 2;

// "0.5", not "0.500000".
std::string number(float value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string footprint_name(Footprint footprint)
{
    constexpr const char* kNames[] = {"point", "origin", "both", "unknown"};
    static_assert(static_cast<int>(Footprint::point) == 0 && static_cast<int>(Footprint::both) == 2);
    return kNames[static_cast<size_t>(footprint)];
}

std::string beam_name(Beam beam)
{
    return beam == Beam::converging ? "converging" : beam == Beam::parallel ? "parallel" : "unknown";
}

std::string first_of(std::initializer_list<std::string> texts)
{
    const auto found = std::find_if(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); });
    return found == texts.end() ? std::string() : *found;
}

std::string difference(const BakeSettings& there, const BakeSettings& here)
{
    // All members, so that a new one is not forgotten here and in put().
    const auto& [origins, directions, used_origins, texel, samples, max_error_levels, seed, threads, footprint, beam] =
        here;
    static_cast<void>(threads);
    return first_of({other("origins", there.origins, origins), other("directions", there.directions, directions),
                     other("cap", there.used_origins, used_origins),
                     other("texels", texel_name(there.texel), texel_name(texel)),
                     other("footprint", footprint_name(there.footprint), footprint_name(footprint)),
                     other("beam", beam_name(there.beam), beam_name(beam)), other("samples", there.samples, samples),
                     other("greatest error", number(there.max_error_levels), number(max_error_levels)),
                     other("seed", there.seed, seed)});
}

std::string difference(const SurfaceSettings& there, const SurfaceSettings& here)
{
    const auto& [triangles, longest_edge, texels_per_radius, paths_per_texel, cap, view_tables, seed, threads] = here;
    static_cast<void>(threads);
    const auto with = [](bool has) { return std::string(has ? "with" : "without"); };
    return first_of(
        {other("triangles", there.triangles, triangles),
         other("longest edge", number(there.longest_edge), number(longest_edge)),
         other("texel density", number(there.texels_per_radius), number(texels_per_radius)),
         other("paths", there.paths_per_texel, paths_per_texel), other("cap", number(there.cap), number(cap)),
         other("view tables", with(there.view_tables), with(view_tables)), other("seed", there.seed, seed)});
}

std::string layout_name(const AnySettings& settings)
{
    return std::holds_alternative<SurfaceSettings>(settings) ? "surface" : "chord";
}

void put(ByteWriter& out, const BakeSettings& s)
{
    for (const uint32_t v : {s.origins, s.directions, s.used_origins, static_cast<uint32_t>(s.texel), s.samples,
                             static_cast<uint32_t>(s.footprint)})
        out.put32(v);
    out.put_float(s.max_error_levels);
    out.put64(s.seed);
    out.put32(static_cast<uint32_t>(s.beam));  // last: zero in the padding of earlier checkpoints
}

void put(ByteWriter& out, const SurfaceSettings& s)
{
    out.put32(s.triangles);
    out.put_float(s.longest_edge);
    out.put_float(s.texels_per_radius);
    out.put32(s.paths_per_texel);
    out.put_float(s.cap);
    out.put32(s.view_tables ? 1 : 0);
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
    for (uint32_t* v : {&s.origins, &s.directions, &s.used_origins}) *v = in.get32();
    s.texel = get_enum<format::TexelFormat>(in, format::kTexelFormats);
    s.samples = in.get32();
    s.footprint = get_enum<Footprint>(in, kFootprints);
    s.max_error_levels = in.get_float();
    s.seed = in.get64();
    s.beam = get_enum<Beam>(in, kBeams);
    s.threads = 0;
    return s;
}

SurfaceSettings get_surface(ByteReader& in)
{
    SurfaceSettings s;
    s.triangles = in.get32();
    s.longest_edge = in.get_float();
    s.texels_per_radius = in.get_float();
    s.paths_per_texel = in.get32();
    s.cap = in.get_float();
    s.view_tables = in.get32() != 0;
    s.seed = in.get64();
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
    while (out.bytes().size() < end) out.put8(0);
}

AnySettings get_settings(ByteReader& in)
{
    return in.get32() == 0 ? AnySettings(get_chord(in)) : AnySettings(get_surface(in));
}

std::string settings_difference(const AnySettings& there, const AnySettings& here)
{
    const std::string layout = other("layout", layout_name(there), layout_name(here));
    if (!layout.empty()) return layout;
    const SurfaceSettings* surface = std::get_if<SurfaceSettings>(&here);
    return surface != nullptr ? difference(std::get<SurfaceSettings>(there), *surface)
                              : difference(std::get<BakeSettings>(there), std::get<BakeSettings>(here));
}

}  // namespace lumi::baker
