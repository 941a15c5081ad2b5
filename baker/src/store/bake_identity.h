// SPDX-License-Identifier: MIT
// Tells whether rows of two bakes belong together.
#pragma once

#include <array>
#include <string>
#include <variant>

#include "lumi/baker/chord.h"
#include "lumi/baker/surface.h"
#include "util/byte_stream.h"

namespace lumi::baker
{

// The settings of bakes as bytes, and how two of them differ.

// As they decide bytes: used_origins resolved, threads 0.
using AnySettings = std::variant<BakeSettings, SurfaceSettings>;

inline constexpr size_t kSettingsBytes = 76;

void put_settings(ByteWriter& out, AnySettings settings);  // kSettingsBytes
AnySettings get_settings(ByteReader& in);                  // out of range stays out of range

// Empty if they are the same, else the first difference: "other samples: 16 there, 4 here".
std::string settings_difference(const AnySettings& there, const AnySettings& here);

// "other WHAT: ..." unless both are the same.
std::string other(const char* what, const std::string& there, const std::string& here);
std::string other(const char* what, uint64_t there, uint64_t here);

// Throws BakeError for settings that no field can hold.
void require_possible_surface(const SurfaceSettings& settings);

// Throws BakeError with this message if it is not so.
inline void require(bool good, const std::string& message)
{
    if (!good) throw BakeError(message);
}

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
