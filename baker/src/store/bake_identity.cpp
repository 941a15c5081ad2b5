// SPDX-License-Identifier: MIT
#include "store/bake_identity.h"

#include <algorithm>

#include "store/shard_rows.h"

namespace lumi::baker
{
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
