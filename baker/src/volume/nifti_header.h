// SPDX-License-Identifier: MIT
// Reads and checks the header of a NIfTI file. This is the one door to the NIfTI library.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace lumi::baker
{

inline constexpr size_t kNiftiHeaderBytes = 540;  // the header of NIfTI-2; that of NIfTI-1 has 348
inline constexpr int64_t kMaxNiftiDataOffset = int64_t{1} << 24;

enum class VoxelType : uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

size_t bytes_of(VoxelType type);

struct NiftiHeader {
    std::array<uint32_t, 3> size = {};  // within the limits of grid.h
    VoxelType type = VoxelType::u8;
    bool swapped = false;                                   // the other byte order
    size_t data_offset = 0;                                 // bytes; at most kMaxNiftiDataOffset
    double slope = 1, intercept = 0;                        // value = slope * stored + intercept; finite, slope not 0
    std::array<std::array<double, 4>, 3> voxel_to_mm = {};  // invertible; x to the right, y to the front, z up

    size_t voxels() const { return size_t{size[0]} * size[1] * size[2]; }
};

// `bytes` are the first ones of the unpacked file: kNiftiHeaderBytes, or all if there are fewer. `name` stands in
// messages. Throws SceneError.
NiftiHeader read_nifti_header(const std::string& name, const std::string& bytes);

}  // namespace lumi::baker
