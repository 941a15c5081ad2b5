// SPDX-License-Identifier: MIT
#include "volume/nifti_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "lumi/baker/scene.h"
#include "util/gzip.h"
#include "util/text_lines.h"
#include "volume/nifti_header.h"

namespace lumi::baker
{
namespace
{

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

float scaled(double stored, const NiftiHeader& header)
{
    const double value = header.slope * stored + header.intercept;
    constexpr double kMost = static_cast<double>(std::numeric_limits<float>::max());
    return std::abs(value) <= kMost ? static_cast<float>(value) : kNoNumber;
}

template <class Stored>
void convert(const char* at, const NiftiHeader& header, std::vector<float>& values)
{
    for (float& value : values) {
        char bytes[sizeof(Stored)];
        std::memcpy(bytes, at, sizeof bytes);
        if (header.swapped) std::reverse(std::begin(bytes), std::end(bytes));
        Stored stored = {};
        std::memcpy(&stored, bytes, sizeof stored);
        value = scaled(static_cast<double>(stored), header);
        at += sizeof stored;
    }
}

std::vector<float> values_of(const char* at, const NiftiHeader& header)
{
    std::vector<float> values(header.voxels());
    switch (header.type) {
        case VoxelType::i8:
            convert<int8_t>(at, header, values);
            break;
        case VoxelType::u8:
            convert<uint8_t>(at, header, values);
            break;
        case VoxelType::i16:
            convert<int16_t>(at, header, values);
            break;
        case VoxelType::u16:
            convert<uint16_t>(at, header, values);
            break;
        case VoxelType::i32:
            convert<int32_t>(at, header, values);
            break;
        case VoxelType::u32:
            convert<uint32_t>(at, header, values);
            break;
        case VoxelType::i64:
            convert<int64_t>(at, header, values);
            break;
        case VoxelType::u64:
            convert<uint64_t>(at, header, values);
            break;
        case VoxelType::f32:
            convert<float>(at, header, values);
            break;
        case VoxelType::f64:
            convert<double>(at, header, values);
            break;
    }
    return values;
}

// False if no value is a number.
bool fill_holes(std::vector<float>& values)
{
    float least = std::numeric_limits<float>::infinity();
    for (const float value : values) least = value < least ? value : least;
    if (!std::isfinite(least)) return false;
    std::replace_if(
        values.begin(), values.end(), [](float value) { return std::isnan(value); }, least);
    return true;
}

// `bytes` are unpacked.
Grid grid_of(const std::string& name, const NiftiHeader& header, const std::string& bytes)
{
    const size_t needed = header.data_offset + header.voxels() * bytes_of(header.type);
    if (bytes.size() < needed) {
        throw SceneError(
            at({name}, "the file ends too early, or its packing is damaged: " + std::to_string(bytes.size()) + " of " +
                           std::to_string(needed) + " bytes are there; copy it again"));
    }
    Grid grid = {header.size[0], header.size[1], header.size[2], values_of(&bytes[header.data_offset], header),
                 header.voxel_to_mm};
    if (!fill_holes(grid.values)) throw SceneError(at({name}, "no voxel holds a number; write the file anew"));
    return grid;
}

}  // namespace

Grid parse_nifti(const std::string& name, const std::string& bytes)
{
    if (!is_gzip(bytes)) return grid_of(name, read_nifti_header(name, bytes.substr(0, kNiftiHeaderBytes)), bytes);
    const NiftiHeader header = read_nifti_header(name, unpack_gzip(bytes, kNiftiHeaderBytes));
    const size_t needed = header.data_offset + header.voxels() * bytes_of(header.type);
    return grid_of(name, header, unpack_gzip(bytes, needed));
}

Grid read_nifti(const std::filesystem::path& file)
{
    return parse_nifti(file.string(), read_file(file));
}

}  // namespace lumi::baker
