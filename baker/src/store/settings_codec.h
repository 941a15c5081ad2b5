// SPDX-License-Identifier: MIT
// The settings of bakes as bytes, and how two of them differ.
#pragma once

#include <string>
#include <variant>

#include "lumi/baker/chord.h"
#include "lumi/baker/surface.h"
#include "util/byte_stream.h"

namespace lumi::baker
{

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

}  // namespace lumi::baker
