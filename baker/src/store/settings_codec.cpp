// SPDX-License-Identifier: MIT
#include "store/settings_codec.h"

#include <algorithm>
#include <sstream>

#include "lumi/chord/texel.h"
#include "lumi/surface/format.h"
namespace lumi::baker
{
namespace
{

// All members by the names that a user reads, the most telling first, but for threads, which decide no byte. A member
// that is added to the settings and not here does not compile.
template <class See>
void each(See& see, BakeSettings& s)
{
    auto& [origins, directions, used_origins, texel, samples, max_error_levels, seed, threads, footprint, beam] = s;
    static_cast<void>(threads);
    see("origins", origins);
    see("directions", directions);
    see("cap", used_origins);
    see("texels", texel);
    see("footprint", footprint);
    see("beam", beam);
    see("samples", samples);
    see("greatest error", max_error_levels);
    see("seed", seed);
}

template <class See>
void each(See& see, SurfaceSettings& s)
{
    auto& [triangles, longest_edge, texels_per_radius, paths_per_texel, cap, view_tables, seed, threads] = s;
    static_cast<void>(threads);
    see("triangles", triangles);
    see("longest edge", longest_edge);
    see("texel density", texels_per_radius);
    see("paths", paths_per_texel);
    see("cap", cap);
    see("view tables", view_tables);
    see("seed", seed);
}

std::string text_of(TexelFormat texel)
{
    return detail::texel_name(texel);
}
std::string text_of(Footprint footprint)
{
    constexpr const char* kNames[] = {"point", "origin", "both", "unknown"};
    static_assert(static_cast<int>(Footprint::point) == 0 && static_cast<int>(Footprint::both) == 2);
    return kNames[std::min<size_t>(static_cast<size_t>(footprint), 3)];
}
std::string text_of(Beam beam)
{
    return beam == Beam::converging ? "converging" : beam == Beam::parallel ? "parallel" : "unknown";
}
std::string text_of(bool has)
{
    return has ? "with" : "without";
}
// "0.5", not "0.500000".
template <class Number>
std::string text_of(Number value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

struct Texts {
    std::vector<std::pair<const char*, std::string>> list;

    template <class T>
    void operator()(const char* name, const T& value)
    {
        list.emplace_back(name, text_of(value));
    }
};

template <class Io>
struct Through {
    Io& io;

    template <class T>
    void operator()(const char*, T& value)
    {
        io(value);
    }
};

Texts texts_of(AnySettings settings)
{
    Texts texts;
    std::visit([&](auto& s) { each(texts, s); }, settings);
    return texts;
}

std::string layout_name(const AnySettings& settings)
{
    return std::holds_alternative<SurfaceSettings>(settings) ? "surface" : "chord";
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

void put_settings(ByteWriter& out, AnySettings settings)
{
    const size_t end = out.bytes().size() + kSettingsBytes;
    out.put32(static_cast<uint32_t>(settings.index()));
    Through<ByteWriter> through{out};
    std::visit([&](auto& s) { each(through, s); }, settings);
    while (out.bytes().size() < end) out.put8(0);
}

AnySettings get_settings(ByteReader& in)
{
    AnySettings settings = BakeSettings{};
    if (in.get32() != 0) settings = SurfaceSettings{};
    Through<ByteReader> through{in};
    std::visit([&](auto& s) { each(through, s); }, settings);
    return settings;
}

std::string settings_difference(const AnySettings& there, const AnySettings& here)
{
    if (there.index() != here.index()) return other("layout", layout_name(there), layout_name(here));
    const Texts theirs = texts_of(there), ours = texts_of(here);
    for (size_t k = 0; k < ours.list.size(); ++k)
        if (theirs.list[k] != ours.list[k])
            return other(ours.list[k].first, theirs.list[k].second, ours.list[k].second);
    return {};
}

void require_possible_surface(const SurfaceSettings& s)
{
    constexpr float kShortest = 0.02f, kLongest = 2, kDensest = 4096;
    require(s.triangles >= 1 && s.triangles <= 2 * detail::format::kMaxPatches,
            "the number of triangles must lie in 1 to " + std::to_string(2 * detail::format::kMaxPatches));
    require(s.longest_edge >= kShortest && s.longest_edge <= kLongest, "the longest edge must lie in 0.02 to 2 radii");
    require(s.texels_per_radius >= 1 && s.texels_per_radius <= kDensest,
            "the density of texels must lie in 1 to 4096 a radius");
    require(s.cap > 0 && s.cap <= 1, "the cap must be more than 0 and at most 1");
    require(s.paths_per_texel >= 1, "the number of light paths a texel must be at least 1");
}

}  // namespace lumi::baker
