// SPDX-License-Identifier: MIT
// What makes rows of two bakes belong together.
#pragma once

#include "chord/field_writer.h"
#include "store/settings_codec.h"
#include "util/digest.h"

namespace lumi::baker
{

struct BakeIdentity {
    std::string program;  // its version
    AnySettings settings;
    Shard shard;
    std::array<float, 3> centre = {};
    float radius = 0;
    Digest::Value scene = {};
    uint64_t tracing = 0;

    bool is_guided() const { return std::holds_alternative<GuidedSettings>(settings); }
    // Of a chord bake. Throws BakeError for settings or shards that cannot be.
    FieldLayout layout() const;
};

inline constexpr size_t kIdentityBytes = 160;

// Throw BakeError for settings or shards that cannot be.
BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard);
BakeIdentity identity_of(const Scene& scene, const GuidedSettings& settings, const Shard& shard);

// Throws BakeError for settings or shards that cannot be.
void require_possible(const BakeIdentity& identity);

std::vector<uint8_t> encode(const BakeIdentity& identity);  // kIdentityBytes
BakeIdentity decode_identity(const uint8_t* bytes);         // reads kIdentityBytes

// Whether `there` was made by the program that made `here`.
bool same_program(const BakeIdentity& there, const BakeIdentity& here);

// Empty if rows of both belong to one field, whatever their shards. Else how `there` differs from `here`, most telling
// first: "other samples: 16 there, 4 here".
std::string difference(const BakeIdentity& there, const BakeIdentity& here);

}  // namespace lumi::baker
