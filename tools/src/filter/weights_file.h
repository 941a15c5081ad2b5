// SPDX-License-Identifier: MIT
// Keeps the weights of a learned filter in a file: the container of field files (lumi/field_format.h) with sections of
// its own.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/field_file.h"
#include "filter/network.h"
#include "lumi/baker/scene.h"

namespace lumi::filter
{

// Both sections are required. FILT, kSettingsBytes: u32 version of the network, u32 input planes, u32 whether it gains,
// u32 0, u64 × 2 the scene's fingerprint, u64 × 2 the field's digest, 4 × binary32 the sphere's bits.
// FNUM: the network's numbers, binary32; empty where it gains nothing.
inline constexpr uint32_t kSettingsSection = detail::format::four_cc('F', 'I', 'L', 'T');
inline constexpr uint32_t kNumbersSection = detail::format::four_cc('F', 'N', 'U', 'M');
inline constexpr uint32_t kSettingsBytes = 64;
inline constexpr uint32_t kNetworkVersion = 1;

// A filter was trained for this subject. It improves pictures of that alone.
struct Subject {
    std::array<uint64_t, 2> scene = {};   // its fingerprint
    std::array<uint64_t, 2> field = {};   // a digest of the file
    std::array<uint32_t, 4> sphere = {};  // bits of centre and radius

    bool operator==(const Subject& other) const;
};

// The scene's fingerprint is left out: a field does not tell it.
Subject subject_of(const tools::FieldFile& field);

struct Weights {
    Subject subject;
    uint32_t input_planes = kPicturePlanes;  // kPicturePlanes or kSurfacePlanes
    bool gains = false;                      // else pictures stay as they are drawn
    std::vector<float> numbers;
};

std::string encode(const Weights& weights);
// Throws Failure with the cause for bytes that encode() did not write. `name`: of the file, for that.
Weights decode(std::string_view bytes, const std::string& name);

Weights read_weights(const std::string& path);

// Throws Failure where the weights are for another field, unless forced; always where they need what it has not.
void require_fitting(const Weights& weights, const std::string& path, const tools::FieldFile& field, bool forced);

}  // namespace lumi::filter
