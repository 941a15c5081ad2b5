// SPDX-License-Identifier: MIT
#include "bake_identity.h"

#include <algorithm>
#include <sstream>

#include "bake_layout.h"
#include "scene_data.h"
#include "scene_fingerprint.h"

namespace lumi::baker
{
namespace
{

constexpr size_t kProgramBytes = 32;
constexpr uint32_t kFootprints = 3;

std::string other(const char* what, const std::string& there, const std::string& here)
{
    return there == here ? std::string() : std::string("other ") + what + ": " + there + " there, " + here + " here";
}

std::string other(const char* what, uint64_t there, uint64_t here)
{
    return other(what, std::to_string(there), std::to_string(here));
}

// "0.5", not "0.500000".
std::string number(float value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string texel_name(format::TexelFormat texel)
{
    constexpr const char* kNames[] = {"rgb888", "rgb565", "palette8", "luma8"};
    static_assert(static_cast<int>(format::TexelFormat::rgb888) == 0 &&
                      static_cast<int>(format::TexelFormat::luma8) == 3 && std::size(kNames) == format::kTexelFormats,
                  "names in the order of the format's numbers");
    return kNames[static_cast<size_t>(texel)];
}

std::string footprint_name(Footprint footprint)
{
    constexpr const char* kNames[] = {"point", "origin", "both", "unknown"};
    static_assert(static_cast<int>(Footprint::point) == 0 && static_cast<int>(Footprint::both) == 2);
    return kNames[static_cast<size_t>(footprint)];
}

std::string settings_difference(const BakeSettings& there, const BakeSettings& here)
{
    // All members, so that a new one is not forgotten here and in encode().
    const auto& [origins, directions, used_origins, texel, samples, max_error_levels, seed, threads, footprint] = here;
    static_cast<void>(threads);
    for (const std::string& text :
         {other("origins", there.origins, origins), other("directions", there.directions, directions),
          other("cap", there.used_origins, used_origins), other("texels", texel_name(there.texel), texel_name(texel)),
          other("footprint", footprint_name(there.footprint), footprint_name(footprint)),
          other("samples", there.samples, samples),
          other("greatest error", number(there.max_error_levels), number(max_error_levels)),
          other("seed", there.seed, seed)}) {
        if (!text.empty()) {
            return text;
        }
    }
    return {};
}

}  // namespace

FieldLayout BakeIdentity::layout() const
{
    check_shard(shard);
    FieldLayout result = checked_layout(settings);
    result.centre = centre;
    result.radius = radius;
    return result;
}

BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard)
{
    BakeIdentity id;
    id.program = LUMI_VERSION;
    id.settings = settings;
    id.settings.used_origins = checked_layout(settings).used_origins;
    id.settings.threads = 0;
    check_shard(shard);
    id.shard = shard;
    id.centre = scene.centre();
    id.radius = scene.radius();
    id.scene = scene_fingerprint(scene.data());
    id.tracing = tracing_fingerprint(scene.data());
    return id;
}

std::vector<uint8_t> encode(const BakeIdentity& id)
{
    ByteWriter out;
    for (size_t k = 0; k < kProgramBytes; ++k) {
        out.put8(k < id.program.size() ? static_cast<uint8_t>(id.program[k]) : uint8_t{0});
    }
    const BakeSettings& s = id.settings;
    for (const uint32_t v : {s.origins, s.directions, s.used_origins, static_cast<uint32_t>(s.texel), s.samples}) {
        out.put32(v);
    }
    out.put64(s.seed);
    out.put32(id.shard.index);
    out.put32(id.shard.count);
    for (const float v : {id.centre[0], id.centre[1], id.centre[2], id.radius}) {
        out.put_float(v);
    }
    for (const uint64_t v : {id.scene[0], id.scene[1], id.tracing}) {
        out.put64(v);
    }
    out.put_float(s.max_error_levels);
    out.put32(static_cast<uint32_t>(s.footprint));
    out.put32(0);  // for a multiple of 8
    return out.bytes();
}

BakeIdentity decode_identity(const uint8_t* bytes)
{
    ByteReader in(bytes, kIdentityBytes);
    BakeIdentity id;
    for (size_t k = 0; k < kProgramBytes; ++k) {
        id.program += static_cast<char>(in.get8());
    }
    id.program.erase(std::min(id.program.find('\0'), id.program.size()));
    BakeSettings& s = id.settings;
    s.origins = in.get32();
    s.directions = in.get32();
    s.used_origins = in.get32();
    // Out of range stays out of range.
    s.texel = static_cast<format::TexelFormat>(std::min(in.get32(), format::kTexelFormats));
    s.samples = in.get32();
    s.seed = in.get64();
    s.threads = 0;
    id.shard.index = in.get32();
    id.shard.count = in.get32();
    for (float* v : {&id.centre[0], &id.centre[1], &id.centre[2], &id.radius}) {
        *v = in.get_float();
    }
    for (uint64_t* v : {&id.scene[0], &id.scene[1], &id.tracing}) {
        *v = in.get64();
    }
    s.max_error_levels = in.get_float();
    s.footprint = static_cast<Footprint>(std::min(in.get32(), kFootprints));
    return id;
}

bool same_program(const BakeIdentity& there, const BakeIdentity& here)
{
    return there.program == here.program;
}

std::string difference(const BakeIdentity& there, const BakeIdentity& here)
{
    if (!same_program(there, here)) {
        return other("version of lumi", there.program, here.program);
    }
    const std::string settings = settings_difference(there.settings, here.settings);
    if (!settings.empty()) {
        return settings;
    }
    if (there.scene != here.scene || there.centre != here.centre || there.radius != here.radius) {
        return "another scene: its triangles, materials, pictures or lights have changed";
    }
    if (there.tracing != here.tracing) {
        return "the same scene, but traced by another build of lumi or on another kind of processor, which rounds "
               "differently";
    }
    return other("number of shards", there.shard.count, here.shard.count);
}

}  // namespace lumi::baker
