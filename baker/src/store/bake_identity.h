// SPDX-License-Identifier: MIT
// What makes rows of two bakes belong together.
#pragma once

#include <array>

#include "store/settings_codec.h"

namespace lumi::baker
{

struct BakeIdentity {
    std::string program;  // its version
    AnySettings settings;
    Shard shard;
    std::array<float, 3> centre = {};
    float radius = 0;
    std::array<uint64_t, 2> scene = {};  // its fingerprint
    uint64_t tracing = 0;  // fingerprint of some light paths, traced by the program on the machine that bakes

    bool is_surface() const { return std::holds_alternative<SurfaceSettings>(settings); }
};

inline constexpr size_t kIdentityBytes = 160;

// The identity of a bake by this program. Settings must be sound, and nothing in them left open. Throws BakeError for a
// shard that cannot be.
BakeIdentity identity_of(const Scene& scene, const AnySettings& settings, const Shard& shard, uint64_t tracing);

std::vector<uint8_t> encode(const BakeIdentity& identity);  // kIdentityBytes
BakeIdentity decode_identity(const uint8_t* bytes);         // reads kIdentityBytes

// Whether `there` was made by the program that made `here`.
bool same_program(const BakeIdentity& there, const BakeIdentity& here);

// Empty if rows of both belong to one field, whatever their shards. Else how `there` differs from `here`, most telling
// first: "other samples: 16 there, 4 here".
std::string difference(const BakeIdentity& there, const BakeIdentity& here);

}  // namespace lumi::baker
