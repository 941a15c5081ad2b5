// SPDX-License-Identifier: MIT
// NIfTI files made in memory, by the layout that the standard prints: without the library that the reader uses.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace lumi::baker::testing
{

// Offsets in a header of NIfTI-1.
namespace nifti1
{
inline constexpr size_t kDim = 40, kDatatype = 70, kBitpix = 72, kPixdim = 76, kVoxOffset = 108, kSlope = 112,
                        kInter = 116, kUnits = 123, kQformCode = 252, kSformCode = 254, kQuatern = 256, kQoffset = 268,
                        kSrow = 280, kMagic = 344;
}

template <class T>
void put(std::string& bytes, size_t at, T value)
{
    std::memcpy(&bytes[at], &value, sizeof value);
}

template <class T>
void append_value(std::string& bytes, T value)
{
    bytes.resize(bytes.size() + sizeof value);
    put(bytes, bytes.size() - sizeof value, value);
}

// The header for `size` upright voxels of 2 mm a side, without the voxels; byte order of this machine.
inline std::string nifti1_header(std::array<int16_t, 3> size, int16_t datatype, int16_t bits)
{
    std::string bytes(352, '\0');
    put(bytes, 0, int32_t{348});
    const int16_t dim[] = {3, size[0], size[1], size[2], 1, 1, 1, 1};
    for (size_t k = 0; k < 8; ++k) {
        put(bytes, nifti1::kDim + 2 * k, dim[k]);
        put(bytes, nifti1::kPixdim + 4 * k, k == 0 ? 1.0f : 2.0f);
    }
    put(bytes, nifti1::kDatatype, datatype);
    put(bytes, nifti1::kBitpix, bits);
    put(bytes, nifti1::kVoxOffset, 352.0f);
    put(bytes, nifti1::kUnits, char{2});
    put(bytes, nifti1::kMagic, std::array<char, 4>{'n', '+', '1', '\0'});
    return bytes;
}

inline constexpr int16_t kNiftiInt16 = 4, kNiftiFloat32 = 16;

// Values at voxels: f(x, y, z), as 16-bit integers.
template <class Function>
std::string nifti_int16(std::array<int16_t, 3> size, const Function& f)
{
    std::string bytes = nifti1_header(size, kNiftiInt16, 16);
    for (int z = 0; z < size[2]; ++z) {
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x) append_value(bytes, static_cast<int16_t>(f(x, y, z)));
    }
    return bytes;
}

}  // namespace lumi::baker::testing
