// SPDX-License-Identifier: MIT
// The one file that sees libnifti2. We take from it what it knows best: both versions of the header, their
// byte orders, and what a quaternion means. Its own reader of files allocates what a header claims and writes
// some errors to stderr.
#include "volume/nifti_header.h"

#include <nifti2_io.h>

#include <cmath>
#include <cstring>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"
#include "volume/grid.h"

namespace lumi::baker
{
namespace
{

struct KnownType {
    int code;
    VoxelType type;
    size_t bytes;
};

constexpr KnownType kTypes[] = {
    {DT_INT8, VoxelType::i8, 1},     {DT_UINT8, VoxelType::u8, 1},   {DT_INT16, VoxelType::i16, 2},
    {DT_UINT16, VoxelType::u16, 2},  {DT_INT32, VoxelType::i32, 4},  {DT_UINT32, VoxelType::u32, 4},
    {DT_INT64, VoxelType::i64, 8},   {DT_UINT64, VoxelType::u64, 8}, {DT_FLOAT32, VoxelType::f32, 4},
    {DT_FLOAT64, VoxelType::f64, 8},
};

template <class Header>
Header header_of(const std::string& bytes, bool swapped)
{
    Header header = {};
    std::memcpy(&header, bytes.data(), sizeof header);
    if (swapped) swap_nifti_header(&header, sizeof header == sizeof(nifti_1_header) ? 1 : 2);
    return header;
}

// Reads a header of either version: their members have the same names.
template <class Header>
class HeaderReader
{
public:
    HeaderReader(const std::string& name, const Header& header, bool swapped) : name_(name), h_(header)
    {
        result_.swapped = swapped;
    }

    NiftiHeader read()
    {
        read_size();
        read_type();
        read_offset();
        read_scale();
        read_place();
        return result_;
    }

private:
    [[noreturn]] void fail(const std::string& text) const { throw SceneError(at({name_}, text)); }

    // A slope of 0 or NaN says that values are not scaled.
    void read_scale()
    {
        if (!std::isfinite(h_.scl_slope) || h_.scl_slope == 0) return;
        if (!std::isfinite(h_.scl_inter))
            fail("the header scales values, but its scl_inter is no number; write the volume again");
        result_.slope = static_cast<double>(h_.scl_slope);
        result_.intercept = static_cast<double>(h_.scl_inter);
    }

    void read_size()
    {
        if (h_.dim[0] < 3 || h_.dim[0] > 7)
            fail("the header says " + std::to_string(h_.dim[0]) + " dimensions; a volume has 3");
        require_size(name_, {h_.dim[1], h_.dim[2], h_.dim[3]});
        for (size_t k = 0; k < 3; ++k) result_.size[k] = static_cast<uint32_t>(h_.dim[k + 1]);
        for (int k = 4; k <= h_.dim[0]; ++k) {
            if (h_.dim[k] != 1) {
                fail("the file holds " + std::to_string(h_.dim[k]) +
                     " volumes; write one of them to a file of its own");
            }
        }
    }

    void read_type()
    {
        for (const KnownType& known : kTypes) {
            if (h_.datatype == known.code) {
                if (h_.bitpix != static_cast<int>(8 * known.bytes)) {
                    fail("the header says " + std::to_string(h_.bitpix) + " bits a voxel where its type has " +
                         std::to_string(8 * known.bytes) + "; write the file anew");
                }
                result_.type = known.type;
                return;
            }
        }
        fail("voxels of type " + std::to_string(h_.datatype) + " (" + nifti_datatype_string(h_.datatype) +
             ") are not read; convert them to integers or floats of at most 64 bits");
    }

    void read_offset()
    {
        const auto offset = h_.vox_offset;
        // Written so that no number fails too.
        if (!(offset >= static_cast<decltype(offset)>(sizeof h_) &&
              offset <= static_cast<decltype(offset)>(kMaxNiftiDataOffset))) {
            fail("the header says that voxels begin at byte " + std::to_string(offset) + "; they begin at " +
                 std::to_string(sizeof h_) + " or later: write the file anew");
        }
        result_.data_offset = static_cast<size_t>(offset);
    }

    // By the three methods of the standard, the best first.
    void read_place()
    {
        if (h_.sform_code > 0) {
            for (size_t c = 0; c < 4; ++c) {
                result_.voxel_to_mm[0][c] = static_cast<double>(h_.srow_x[c]);
                result_.voxel_to_mm[1][c] = static_cast<double>(h_.srow_y[c]);
                result_.voxel_to_mm[2][c] = static_cast<double>(h_.srow_z[c]);
            }
        } else {
            place_by_spacing();
        }
        scale_to_mm();
        require_place(name_, result_.voxel_to_mm, method());
    }

    void place_by_spacing()
    {
        const std::array<double, 3> spacing = {std::abs(static_cast<double>(h_.pixdim[1])),
                                               std::abs(static_cast<double>(h_.pixdim[2])),
                                               std::abs(static_cast<double>(h_.pixdim[3]))};
        for (size_t r = 0; r < 3; ++r) result_.voxel_to_mm[r][r] = spacing[r];
        if (h_.qform_code > 0) {
            const nifti_dmat44 m = nifti_quatern_to_dmat44(
                static_cast<double>(h_.quatern_b), static_cast<double>(h_.quatern_c), static_cast<double>(h_.quatern_d),
                static_cast<double>(h_.qoffset_x), static_cast<double>(h_.qoffset_y), static_cast<double>(h_.qoffset_z),
                1, 1, 1, static_cast<double>(h_.pixdim[0]));
            for (size_t r = 0; r < 3; ++r)
                for (size_t c = 0; c < 4; ++c) result_.voxel_to_mm[r][c] = m.m[r][c] * (c < 3 ? spacing[c] : 1);
        }
    }

    void scale_to_mm()
    {
        const int units = XYZT_TO_SPACE(h_.xyzt_units);
        const double mm = units == NIFTI_UNITS_METER ? 1000 : units == NIFTI_UNITS_MICRON ? 0.001 : 1;
        for (auto& row : result_.voxel_to_mm)
            for (double& entry : row) entry *= mm;
    }

    std::string method() const
    {
        return h_.sform_code > 0 ? "sform" : h_.qform_code > 0 ? "qform or pixdim" : "pixdim";
    }

    const std::string& name_;
    const Header& h_;
    NiftiHeader result_;
};

}  // namespace

size_t bytes_of(VoxelType type)
{
    for (const KnownType& known : kTypes)
        if (known.type == type) return known.bytes;
    return 1;
}

NiftiHeader read_nifti_header(const std::string& name, const std::string& bytes)
{
    static_assert(sizeof(nifti_1_header) == 348 && sizeof(nifti_2_header) == kNiftiHeaderBytes, "as the standard says");
    if (bytes.size() < sizeof(nifti_1_header))
        throw SceneError(at({name}, "the file ends within its header; copy it again"));
    int32_t first = 0;  // the header's size, which tells version and byte order
    std::memcpy(&first, bytes.data(), sizeof first);
    int32_t other = first;
    nifti_swap_4bytes(1, &other);
    constexpr int32_t kOne = sizeof(nifti_1_header), kTwo = sizeof(nifti_2_header);
    const bool swapped = other == kOne || other == kTwo;
    const int32_t size = swapped ? other : first;
    if (size == kOne && std::memcmp(&bytes[offsetof(nifti_1_header, magic)], "n+1", 4) == 0)
        return HeaderReader(name, header_of<nifti_1_header>(bytes, swapped), swapped).read();
    if (size == kTwo && bytes.size() >= sizeof(nifti_2_header) &&
        std::memcmp(&bytes[offsetof(nifti_2_header, magic)], "n+2", 4) == 0)
        return HeaderReader(name, header_of<nifti_2_header>(bytes, swapped), swapped).read();
    throw SceneError(at({name}, size == kOne
                                    ? "this is a pair of .hdr and .img, or the old format ANALYZE; convert it to "
                                      "one NIfTI file, .nii or .nii.gz"
                                    : "this is no NIfTI file; convert the volume to .nii or .nii.gz"));
}

}  // namespace lumi::baker
