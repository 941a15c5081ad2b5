// SPDX-License-Identifier: MIT
#include "store/bake_identity.h"

#include <algorithm>
#include <sstream>

#include "lumi/chord/texel.h"
#include "lumi/surface/format.h"
#include "store/shard_set.h"

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
    auto& [triangles, longest_edge, texels_per_radius, paths_per_texel, cap, view_tables, gloss_maps, fills,
           finest_texels, ground, draft, seed, threads] = s;
    static_cast<void>(threads);
    see("triangles", triangles);
    see("longest edge", longest_edge);
    see("texel density", texels_per_radius);
    see("paths", paths_per_texel);
    see("cap", cap);
    see("view tables", view_tables);
    see("gloss maps", gloss_maps);
    see("fill", fills);
    see("finest texels", finest_texels);
    see("ground", ground);
    see("draft", draft);
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

namespace
{

constexpr size_t kProgramBytes = 32;
static_assert(kIdentityBytes == kProgramBytes + kSettingsBytes + 2 * 4 + 4 * 4 + 3 * 8 + 4);

}  // namespace

BakeIdentity identity_of(const Scene& scene, const AnySettings& settings, const Shard& shard, uint64_t tracing)
{
    check_shard(shard);
    BakeIdentity id;
    id.program = LUMI_VERSION;
    id.settings = settings;
    std::visit([](auto& s) { s.threads = 0; }, id.settings);
    id.shard = shard;
    id.centre = scene.centre();
    id.radius = scene.radius();
    id.scene = scene.fingerprint();
    id.tracing = tracing;
    return id;
}

std::vector<uint8_t> encode(const BakeIdentity& id)
{
    ByteWriter out;
    for (size_t k = 0; k < kProgramBytes; ++k)
        out.put8(k < id.program.size() ? static_cast<uint8_t>(id.program[k]) : uint8_t{0});
    put_settings(out, id.settings);
    out.put32(id.shard.index);
    out.put32(id.shard.count);
    for (const float v : {id.centre[0], id.centre[1], id.centre[2], id.radius}) out.put_float(v);
    for (const uint64_t v : {id.scene[0], id.scene[1], id.tracing}) out.put64(v);
    out.put32(0);  // for a multiple of 8
    return out.bytes();
}

BakeIdentity decode_identity(const uint8_t* bytes)
{
    ByteReader in(bytes, kIdentityBytes);
    BakeIdentity id;
    for (size_t k = 0; k < kProgramBytes; ++k) id.program += static_cast<char>(in.get8());
    id.program.erase(std::min(id.program.find('\0'), id.program.size()));
    ByteReader settings(bytes + kProgramBytes, kSettingsBytes);
    id.settings = get_settings(settings);
    in = ByteReader(bytes + kProgramBytes + kSettingsBytes, kIdentityBytes - kProgramBytes - kSettingsBytes);
    id.shard.index = in.get32();
    id.shard.count = in.get32();
    for (float* v : {&id.centre[0], &id.centre[1], &id.centre[2], &id.radius}) *v = in.get_float();
    for (uint64_t* v : {&id.scene[0], &id.scene[1], &id.tracing}) *v = in.get64();
    return id;
}

bool same_program(const BakeIdentity& there, const BakeIdentity& here)
{
    return there.program == here.program;
}

std::string difference(const BakeIdentity& there, const BakeIdentity& here)
{
    if (!same_program(there, here)) return other("version of lumi", there.program, here.program);
    const std::string settings = settings_difference(there.settings, here.settings);
    if (!settings.empty()) return settings;
    if (there.scene != here.scene || there.centre != here.centre || there.radius != here.radius)
        return "another scene: its triangles, materials, pictures or lights have changed";
    if (there.tracing != here.tracing) {
        return "the same scene, but traced by another build of lumi or on another kind of processor, which rounds "
               "differently";
    }
    return other("number of shards", there.shard.count, here.shard.count);
}

}  // namespace lumi::baker
