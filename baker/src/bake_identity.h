// SPDX-License-Identifier: MIT
// What makes rows of two bakes belong together.
#pragma once

#include <optional>
#include <string>

#include "byte_stream.h"
#include "digest.h"
#include "field_writer.h"
#include "lumi/baker/bake.h"

namespace lumi::baker
{

struct BakeIdentity {
    std::string program;    // its version
    BakeSettings settings;  // used_origins resolved, threads 0
    Shard shard;
    std::array<float, 3> centre = {};
    float radius = 0;
    Digest::Value scene = {};
    uint64_t tracing = 0;

    // Throws BakeError for settings or shards that cannot be.
    FieldLayout layout() const;
};

inline constexpr size_t kIdentityBytes = 120;

BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard);

std::vector<uint8_t> encode(const BakeIdentity& identity);  // kIdentityBytes
BakeIdentity decode_identity(const uint8_t* bytes);         // reads kIdentityBytes

// Whether `there` was made by the program that made `here`.
bool same_program(const BakeIdentity& there, const BakeIdentity& here);

// Empty if rows of both belong to one field, whatever their shards. Else how `there` differs from `here`, most telling
// first: "other samples: 16 there, 4 here".
std::string difference(const BakeIdentity& there, const BakeIdentity& here);

}  // namespace lumi::baker
