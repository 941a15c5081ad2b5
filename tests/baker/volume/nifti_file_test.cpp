// SPDX-License-Identifier: MIT
// NIfTI files: every type, scale and placement; and what broken ones get.
#include "volume/nifti_file.h"

#include <zlib.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "lumi/baker/scene.h"
#include "support/nifti_bytes.h"
#include "support/scratch_folder.h"
#include "volume/affine.h"

namespace lumi::baker
{
namespace
{

using testing::append_value;
using testing::put;
namespace nifti1 = testing::nifti1;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// 2 x 2 x 2 voxels with the values 1 to 8.
template <class T>
std::string cube_of(int16_t datatype)
{
    std::string bytes = testing::nifti1_header({2, 2, 2}, datatype, static_cast<int16_t>(8 * sizeof(T)));
    for (int k = 1; k <= 8; ++k) append_value(bytes, static_cast<T>(k));
    return bytes;
}

std::string cube()
{
    return cube_of<int16_t>(testing::kNiftiInt16);
}

const std::vector<float> kOneToEight = {1, 2, 3, 4, 5, 6, 7, 8};

std::string gzipped(const std::string& bytes)
{
    std::string out(bytes.size() + 100, '\0');
    z_stream stream = {};
    deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
    std::string in = bytes;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    out.resize(out.size() - stream.avail_out);
    deflateEnd(&stream);
    return out;
}

void turn(std::string& bytes, size_t at, size_t size)
{
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
}

// That file as a machine of the other byte order writes it.
std::string turned_cube()
{
    std::string bytes = cube();
    turn(bytes, 0, 4);
    for (size_t at = nifti1::kDim; at < nifti1::kDim + 16; at += 2) turn(bytes, at, 2);
    turn(bytes, nifti1::kDatatype, 2);
    turn(bytes, nifti1::kBitpix, 2);
    for (size_t at = nifti1::kPixdim; at < nifti1::kInter + 4; at += 4) turn(bytes, at, 4);
    for (size_t at = 352; at < bytes.size(); at += 2) turn(bytes, at, 2);
    return bytes;
}

// A header of NIfTI-2.
std::string cube2()
{
    std::string bytes(544, '\0');
    put(bytes, 0, int32_t{540});
    put(bytes, 4, std::array<char, 8>{'n', '+', '2', '\0', '\r', '\n', '\x1A', '\n'});
    put(bytes, 12, testing::kNiftiInt16);
    put(bytes, 14, int16_t{16});
    for (size_t k = 0; k < 8; ++k) {
        put(bytes, 16 + 8 * k, int64_t{k == 0 ? 3 : k < 4 ? 2 : 1});
        put(bytes, 104 + 8 * k, 2.0);
    }
    put(bytes, 168, int64_t{544});
    for (int k = 1; k <= 8; ++k) append_value(bytes, static_cast<int16_t>(k));
    return bytes;
}

void check_refused(const std::string& bytes, const std::string& what)
{
    CHECK_THROWS_WITH(parse_nifti("head.nii", bytes),
                      Catch::StartsWith("head.nii: ") && Catch::Contains(what) && Catch::Contains("; "));
}

// The cube with one number of its header changed.
template <class T>
std::string with(size_t at, T value)
{
    std::string bytes = cube();
    put(bytes, at, value);
    return bytes;
}

TEST_CASE("voxels of every integer and float type are read", "[volume]")
{
    const std::string files[] = {cube_of<uint8_t>(2),    cube_of<int16_t>(4),    cube_of<int32_t>(8),
                                 cube_of<float>(16),     cube_of<double>(64),    cube_of<int8_t>(256),
                                 cube_of<uint16_t>(512), cube_of<uint32_t>(768), cube_of<int64_t>(1024),
                                 cube_of<uint64_t>(1280)};
    for (const std::string& bytes : files) {
        const Grid grid = parse_nifti("head.nii", bytes);
        CHECK((grid.nx == 2 && grid.ny == 2 && grid.nz == 2));
        CHECK(grid.values == kOneToEight);
    }
}

TEST_CASE("both byte orders, both versions and packed files hold the same volume", "[volume]")
{
    for (const std::string& bytes : {cube(), turned_cube(), cube2(), gzipped(cube()), gzipped(cube2())}) {
        const Grid grid = parse_nifti("head.nii", bytes);
        CHECK(grid.values == kOneToEight);
        for (size_t k = 0; k < 3; ++k) CHECK(grid.voxel_to_world[k][k] == 2);
    }
    const testing::ScratchFolder folder;
    CHECK(read_nifti(folder.write("head.nii.gz", gzipped(cube()))).values == kOneToEight);
    CHECK_THROWS_WITH(read_nifti(folder.at("none.nii")), Catch::Contains("none.nii: ") && Catch::Contains("; "));
}

TEST_CASE("values are scaled, unless the scale is none", "[volume]")
{
    std::string bytes = with(nifti1::kSlope, 2.0f);
    put(bytes, nifti1::kInter, -1024.0f);
    CHECK(parse_nifti("head.nii", bytes).values[7] == 2 * 8 - 1024);
    put(bytes, nifti1::kSlope, 0.0f);
    CHECK(parse_nifti("head.nii", bytes).values[7] == 8);
    put(bytes, nifti1::kSlope, kNan);
    CHECK(parse_nifti("head.nii", bytes).values[7] == 8);
}

TEST_CASE("what is no number becomes the smallest value", "[volume]")
{
    std::string bytes = cube_of<float>(16);
    put(bytes, 352, kNan);
    put(bytes, 352 + 4 * 7, std::numeric_limits<float>::infinity());
    put(bytes, nifti1::kSlope, 3e38f);  // 2 of these are more than a float holds
    put(bytes, 352 + 4, 1.0f);
    const Grid grid = parse_nifti("head.nii", bytes);
    for (const float value : grid.values) CHECK(value == 3e38f);
    for (size_t k = 0; k < 8; ++k) put(bytes, 352 + 4 * k, kNan);
    check_refused(bytes, "no voxel holds a number");
}

TEST_CASE("sform counts more than qform, and that more than the spacing", "[volume]")
{
    std::string bytes = cube();
    CHECK(point_of(parse_nifti("head.nii", bytes).voxel_to_world, 1, 1, 1) == std::array<double, 3>{2, 2, 2});

    put(bytes, nifti1::kQformCode, int16_t{1});  // half a turn about z, and z mirrored
    put(bytes, nifti1::kQuatern + 8, 1.0f);
    put(bytes, nifti1::kPixdim, -1.0f);
    put(bytes, nifti1::kQoffset, 5.0f);
    const std::array<double, 3> turned = point_of(parse_nifti("head.nii", bytes).voxel_to_world, 1, 1, 1);
    CHECK(turned[0] == Approx(5 - 2));
    CHECK(turned[1] == Approx(-2));
    CHECK(turned[2] == Approx(-2));

    put(bytes, nifti1::kSformCode, int16_t{1});
    const float rows[] = {0, 0, 3, 1, 0, 3, 0, 2, 3, 0, 0, 4};
    for (size_t k = 0; k < 12; ++k) put(bytes, nifti1::kSrow + 4 * k, rows[k]);
    CHECK(point_of(parse_nifti("head.nii", bytes).voxel_to_world, 1, 0, 0) == std::array<double, 3>{1, 2, 7});

    put(bytes, nifti1::kUnits, char{1});  // metres
    CHECK(point_of(parse_nifti("head.nii", bytes).voxel_to_world, 1, 0, 0) == std::array<double, 3>{1000, 2000, 7000});
}

TEST_CASE("broken headers are refused by what is wrong in them", "[volume]")
{
    check_refused(with(nifti1::kDim, int16_t{0}), "0 dimensions");
    check_refused(with(nifti1::kDim, int16_t{2}), "2 dimensions");
    check_refused(with(nifti1::kDim, int16_t{8}), "8 dimensions");
    check_refused(with(nifti1::kDim + 2, int16_t{-2}), "-2 voxels along axis 1");
    check_refused(with(nifti1::kDim + 6, int16_t{0}), "0 voxels along axis 3");
    check_refused(with(nifti1::kDim + 4, int16_t{1}), "1 voxels along axis 2");
    check_refused(with(nifti1::kDatatype, int16_t{0}), "type 0");
    check_refused(with(nifti1::kDatatype, int16_t{128}), "RGB24");
    check_refused(with(nifti1::kDatatype, int16_t{32}), "COMPLEX64");
    check_refused(with(nifti1::kBitpix, int16_t{8}), "8 bits");
    check_refused(with(nifti1::kVoxOffset, 0.0f), "begin at byte 0");
    check_refused(with(nifti1::kVoxOffset, -1e30f), "begin at byte");
    check_refused(with(nifti1::kVoxOffset, 1e30f), "begin at byte");
    check_refused(with(nifti1::kVoxOffset, kNan), "begin at byte");
    check_refused(with(nifti1::kPixdim + 4, kNan), "pixdim");
    check_refused(with(nifti1::kPixdim + 8, 0.0f), "no volume");
    check_refused(with(nifti1::kSformCode, int16_t{1}), "no volume by the header's sform");
    check_refused(with(nifti1::kMagic, std::array<char, 4>{'n', 'i', '1', '\0'}), "pair");
    check_refused(with(0, int32_t{0}), "no NIfTI");
    check_refused(std::string("# an OBJ\n") + std::string(400, ' '), "no NIfTI");

    std::string series = with(nifti1::kDim, int16_t{4});
    put(series, nifti1::kDim + 8, int16_t{30});
    check_refused(series, "30 volumes");
    std::string huge = cube();
    for (size_t k = 1; k < 4; ++k) put(huge, nifti1::kDim + 2 * k, int16_t{10000});
    check_refused(huge, "1000000000000 voxels; at most");
    check_refused(gzipped(huge), "1000000000000 voxels; at most");
    std::string large = cube2();
    put(large, 24, std::numeric_limits<int64_t>::max());
    check_refused(large, "voxels along axis 1");
    std::string place = with(nifti1::kSformCode, int16_t{1});
    for (size_t k = 0; k < 12; ++k) put(place, nifti1::kSrow + 4 * k, k == 5 ? kNan : static_cast<float>(k % 5 == 0));
    check_refused(place, "sform holds nan");
    std::string quatern = with(nifti1::kQformCode, int16_t{1});
    put(quatern, nifti1::kQuatern, kNan);
    check_refused(quatern, "qform");
}

TEST_CASE("every truncation is refused, packed or not", "[volume]")
{
    for (const std::string& whole : {cube(), cube2()})
        for (size_t size = 0; size < whole.size(); ++size)
            CHECK_THROWS_AS(parse_nifti("head.nii", whole.substr(0, size)), SceneError);
    const std::string packed = gzipped(cube());
    // The last 8 bytes are checksum and size, and a byte before them may hold no more than the end's mark.
    for (size_t size = 0; size + 9 < packed.size(); ++size)
        CHECK_THROWS_AS(parse_nifti("head.nii.gz", packed.substr(0, size)), SceneError);
}

TEST_CASE("a small file that claims a large volume is refused without its memory", "[volume]")
{
    std::string bytes = cube();
    for (size_t k = 1; k < 4; ++k) put(bytes, nifti1::kDim + 2 * k, int16_t{600});
    check_refused(bytes, "ends too early");
    check_refused(gzipped(bytes), "ends too early");
}

}  // namespace
}  // namespace lumi::baker
