// SPDX-License-Identifier: MIT
// OpenVDB files: which grid is read, its values and its place; and what broken ones get.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#pragma GCC diagnostic pop

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

#include "lumi/baker/file_guard.h"
#include "scene/model_reader.h"
#include "scene/scene_file.h"
#include "support/nifti_bytes.h"
#include "support/scratch_folder.h"
#include "volume/affine.h"
#include "volume/volume_file.h"

// OpenVDB's reader loses the node that it is making where a file ends too early.
extern "C" const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions()
{
    return "leak:openvdb::";
}

namespace lumi::baker
{
namespace
{

using openvdb::FloatGrid;
using openvdb::math::Transform;

constexpr int kSides[3] = {3, 4, 5};

int number_at(int x, int y, int z)
{
    return 1 + x + 3 * (y + 4 * z);
}

// 3 x 4 x 5 active voxels from `first` on, with the values 1 to 60.
FloatGrid::Ptr box_of_numbers(const std::string& name, const openvdb::Coord& first = {0, 0, 0}, float background = 0)
{
    const FloatGrid::Ptr grid = FloatGrid::create(background);
    grid->setName(name);
    for (int z = 0; z < kSides[2]; ++z) {
        for (int y = 0; y < kSides[1]; ++y)
            for (int x = 0; x < kSides[0]; ++x)
                grid->tree().setValue(first.offsetBy(x, y, z), static_cast<float>(number_at(x, y, z)));
    }
    return grid;
}

class VdbFolder
{
public:
    std::filesystem::path write(const openvdb::GridPtrVec& grids, bool with_statistics = true) const
    {
        openvdb::initialize();
        openvdb::io::File file(folder_.at("g.vdb").string());
        file.setGridStatsMetadataEnabled(with_statistics);
        file.write(grids);
        return folder_.at("g.vdb");
    }
    Grid read(const openvdb::GridPtrVec& grids) const { return read_vdb(write(grids)); }

    std::string bytes_of(const openvdb::GridPtrVec& grids) const { return testing::read_bytes(write(grids)); }

    void check_refused(const openvdb::GridPtrVec& grids, const std::string& what, bool with_statistics = true) const
    {
        check_file_refused(write(grids, with_statistics), what);
    }
    void check_bytes_refused(const std::string& bytes, const std::string& what) const
    {
        check_file_refused(folder_.write("g.vdb", bytes), what);
    }
    std::filesystem::path at(const std::string& name) const { return folder_.at(name); }
    std::filesystem::path write_file(const std::string& name, const std::string& bytes) const
    {
        return folder_.write(name, bytes);
    }

private:
    static void check_file_refused(const std::filesystem::path& file, const std::string& what)
    {
        CHECK_THROWS_WITH(read_vdb(file), Catch::Contains("g.vdb: ") && Catch::Contains(what) && Catch::Contains("; "));
    }

    testing::ScratchFolder folder_;
};

float value_at(const Grid& grid, uint32_t x, uint32_t y, uint32_t z)
{
    return grid.values[(size_t{z} * grid.ny + y) * grid.nx + x];
}

void check_point(const Grid& grid, const openvdb::Vec3d& voxel, const openvdb::Vec3d& expected)
{
    const std::array<double, 3> place = point_of(grid.voxel_to_world, voxel.x(), voxel.y(), voxel.z());
    for (size_t k = 0; k < 3; ++k) CHECK(place[k] == Approx(expected[static_cast<int>(k)]).margin(1e-12));
}

TEST_CASE("a VDB grid is the box of its active voxels, with one of background around", "[vdb]")
{
    const VdbFolder folder;
    for (const bool half : {false, true}) {
        const FloatGrid::Ptr written = box_of_numbers("density", {-2, 7, 100}, 0.25f);
        written->setSaveFloatAsHalf(half);
        written->tree().setValueOff({50, 50, 50}, 9);  // inactive: not of the box
        const Grid grid = folder.read({written});
        REQUIRE((grid.nx == 5 && grid.ny == 6 && grid.nz == 7));
        for (uint32_t z = 0; z < 7; ++z) {
            for (uint32_t y = 0; y < 6; ++y) {
                for (uint32_t x = 0; x < 5; ++x) {
                    const bool inside = x % 4 != 0 && y % 5 != 0 && z % 6 != 0;
                    const float expected =
                        inside ? static_cast<float>(number_at(static_cast<int>(x) - 1, static_cast<int>(y) - 1,
                                                              static_cast<int>(z) - 1))
                               : 0.25f;
                    CHECK(value_at(grid, x, y, z) == expected);
                }
            }
        }
        check_point(grid, {1, 1, 1}, {-2, 7, 100});
    }
}

TEST_CASE("inactive voxels and tiles inside the box keep their values", "[vdb]")
{
    const FloatGrid::Ptr written = FloatGrid::create(0);
    written->fill(openvdb::CoordBBox({0, 0, 0}, {31, 31, 31}), 3);  // the box is made of tiles: 8 voxels a side
    written->tree().setValueOff({5, 5, 5}, 7);
    written->pruneGrid();
    REQUIRE(written->tree().activeTileCount() > 0);
    const Grid grid = VdbFolder().read({written});
    REQUIRE(grid.nx == 34);
    CHECK(value_at(grid, 20, 20, 20) == 3);
    CHECK(value_at(grid, 6, 6, 6) == 7);
    CHECK(value_at(grid, 0, 20, 20) == 0);
}

TEST_CASE("a VDB grid lies where its transform says: scaled, sheared, turned and moved", "[vdb]")
{
    const VdbFolder folder;
    const FloatGrid::Ptr written = box_of_numbers("density", {10, 20, 30});
    const auto check_place = [&](const Transform::Ptr& transform) {
        written->setTransform(transform);
        const Grid grid = folder.read({written});
        check_point(grid, {1, 1, 1}, transform->indexToWorld(openvdb::Vec3d(10, 20, 30)));
        check_point(grid, {3, 2, 5}, transform->indexToWorld(openvdb::Vec3d(12, 21, 34)));
    };
    Transform::Ptr transform = Transform::createLinearTransform(0.5);
    check_place(transform);
    transform->postScale({1, -2, 3});
    check_place(transform);
    transform->postTranslate({-4, 5, 6.5});
    check_place(transform);
    transform->postRotate(0.7, openvdb::math::Z_AXIS);
    transform->postRotate(-0.3, openvdb::math::X_AXIS);
    check_place(transform);
    transform->postShear(0.5, openvdb::math::X_AXIS, openvdb::math::Y_AXIS);
    check_place(transform);

    // By hand: a quarter turn about z takes the voxels' x to the world's y.
    transform = Transform::createLinearTransform(2);
    transform->postRotate(std::acos(0.0), openvdb::math::Z_AXIS);
    transform->postTranslate({100, 0, 0});
    written->setTransform(transform);
    const Grid grid = folder.read({written});
    check_point(grid, {1, 1, 1}, {100 - 2 * 20, 2 * 10, 2 * 30});
    check_point(grid, {2, 1, 1}, {100 - 2 * 20, 2 * 11, 2 * 30});
}

TEST_CASE("transforms that bend space or flatten it are refused", "[vdb]")
{
    const VdbFolder folder;
    const FloatGrid::Ptr grid = box_of_numbers("density");
    grid->setTransform(
        Transform::createFrustumTransform(openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(10)), 0.5, 8, 1));
    folder.check_refused({grid}, "'density' lies in space by a frustum");
    grid->setTransform(Transform::createLinearTransform(1e10));
    folder.check_refused({grid}, "its transform holds 10000000000.0");
    // OpenVDB writes no flat one, but reads it.
    constexpr double kSize = 0.3;
    grid->setTransform(Transform::createLinearTransform(kSize));
    std::string bytes = folder.bytes_of({grid});
    std::string size(sizeof kSize, '\0');
    std::memcpy(size.data(), &kSize, sizeof kSize);
    const size_t first = bytes.find(size + size + size);
    REQUIRE(first != std::string::npos);
    bytes.replace(first, 3 * size.size(), 3 * size.size(), '\0');
    folder.check_bytes_refused(bytes, "no volume by the header's transform");
}

TEST_CASE("of several grids that of the name density is read, else the only one of floats", "[vdb]")
{
    const VdbFolder folder;
    const FloatGrid::Ptr heat = box_of_numbers("heat"), density = box_of_numbers("density");
    density->tree().setValue({0, 0, 0}, 77);
    const openvdb::GridBase::Ptr wind = openvdb::Vec3SGrid::create(), ids = openvdb::Int32Grid::create();
    wind->setName("wind");
    ids->setName("density");
    CHECK(value_at(folder.read({heat, density, wind}), 1, 1, 1) == 77);
    CHECK(value_at(folder.read({density, heat}), 1, 1, 1) == 77);
    CHECK(value_at(folder.read({wind, heat, ids}), 1, 1, 1) == 1);
    const FloatGrid::Ptr nameless = box_of_numbers("");
    CHECK(value_at(folder.read({nameless}), 1, 1, 1) == 1);

    folder.check_refused({heat, box_of_numbers("steam")}, "2 grids of floats are in the file, 'heat', 'steam'; give");
    folder.check_refused({wind, ids}, "only 'wind' (Tree_vec3s_5_4_3), 'density' (Tree_int32_5_4_3); write one");
    folder.check_refused({}, "no grid of floats is in the file; write one");
}

TEST_CASE("grids that share their voxels are read from any of them", "[vdb]")
{
    const FloatGrid::Ptr first = box_of_numbers("first");
    const FloatGrid::Ptr density = openvdb::gridPtrCast<FloatGrid>(first->copyGrid());
    density->setName("density");
    density->setTransform(Transform::createLinearTransform(4));
    const Grid grid = VdbFolder().read({first, density});
    CHECK(value_at(grid, 2, 1, 1) == 2);
    CHECK(grid.voxel_to_world[1][1] == 4);
}

TEST_CASE("a level set's values become depths, so that its surface encloses what lies above 0", "[vdb]")
{
    const VdbFolder folder;
    const FloatGrid::Ptr ball = FloatGrid::create(3);
    ball->setGridClass(openvdb::GRID_LEVEL_SET);
    ball->denseFill(openvdb::CoordBBox(openvdb::Coord(-12), openvdb::Coord(12)), 3);
    for (auto voxel = ball->beginValueOn(); voxel; ++voxel)
        voxel.setValue(std::clamp(static_cast<float>(voxel.getCoord().asVec3d().length()) - 8, -3.0f, 3.0f));
    const std::filesystem::path file = folder.write({ball});
    CHECK(range_of_volume(file) == "-3 to 3");
    const SceneParts parts = read_iso_surface(file, {0, 0});
    CHECK(parts.mesh.triangle_count() > 500);
    for (const Vec3& p : parts.mesh.positions) CHECK(static_cast<double>(length(p)) == Approx(8).margin(0.1));
    CHECK(dot(parts.mesh.area_vector(0), parts.mesh.position(0, 0)) > 0);
}

TEST_CASE("what is no number in a VDB grid is refused with its voxel", "[vdb]")
{
    const VdbFolder folder;
    for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        const FloatGrid::Ptr grid = box_of_numbers("density", {-4, 5, 6});
        grid->tree().setValue({-3, 7, 10}, odd);
        folder.check_refused({grid}, "the voxel at -3, 7, 10 holds " + std::to_string(odd));
        folder.check_refused({box_of_numbers("density", {0, 0, 0}, odd)}, "the voxel at -1, -1, -1 holds ");
    }
}

TEST_CASE("an empty VDB grid, and one that is too large, is refused before its memory is taken", "[vdb]")
{
    const VdbFolder folder;
    for (const bool with_statistics : {true, false}) {
        folder.check_refused({FloatGrid::create()}, "the grid is empty", with_statistics);
        const FloatGrid::Ptr long_one = box_of_numbers("density");
        long_one->tree().setValue({100000, 0, 0}, 1);
        folder.check_refused({long_one}, "100003 voxels along axis 1; a volume has 2 to 32767", with_statistics);
        const FloatGrid::Ptr large = box_of_numbers("density");
        large->tree().setValue({9999, 9999, 9999}, 1);
        folder.check_refused({large}, "1000600120008 voxels; at most 268435456 are read", with_statistics);
        const FloatGrid::Ptr far = FloatGrid::create();
        far->tree().setValue(openvdb::Coord(std::numeric_limits<int>::max()), 1);
        folder.check_refused({far}, "from the grid's origin", with_statistics);
    }
}

TEST_CASE("a VDB file that is cut short is refused", "[vdb]")
{
    const VdbFolder folder;
    const openvdb::GridPtrVec grids = {box_of_numbers("density"), box_of_numbers("heat")};
    const std::string whole = folder.bytes_of(grids);
    constexpr size_t kHead = 500, kStep = 997;  // every length within the head; some behind it, to save time
    REQUIRE(whole.size() > 10 * kStep);
    const auto check = [&](size_t size) {
        folder.check_bytes_refused(whole.substr(0, size), "the file ends too early; copy it again");
    };
    for (size_t size = 0; size < kHead; ++size) check(size);
    for (size_t size = kHead; size < whole.size(); size += kStep) check(size);
    check(whole.size() - 1);
    CHECK_NOTHROW(read_vdb(folder.write_file("whole.vdb", whole)));
}

TEST_CASE("a VDB file whose list of grids is damaged is refused, also where voxels end too early", "[vdb]")
{
    const VdbFolder folder;
    std::string bytes = folder.bytes_of({box_of_numbers("density")});
    const std::string type = "Tree_float_5_4_3";
    const size_t end_at = bytes.find(type) + type.size() + 4 + 2 * 8;  // no parent's name, two other offsets
    const auto bytes_with_end = [&](int64_t end) {
        std::memcpy(&bytes[end_at], &end, sizeof end);
        return bytes;
    };
    folder.check_bytes_refused(bytes_with_end(0), "list of grids is damaged");
    folder.check_bytes_refused(bytes_with_end(-1), "list of grids is damaged");
    const auto head = static_cast<int64_t>(end_at + 8);
    const std::string claims_less = bytes_with_end(head);
    for (size_t size = end_at + 8; size < bytes.size(); size += 499)
        folder.check_bytes_refused(claims_less.substr(0, size), "the file ends too early");
}

TEST_CASE("what is no VDB file, or none that says where its grids are, is refused", "[vdb]")
{
    const VdbFolder folder;
    folder.check_bytes_refused("", "ends too early");
    folder.check_bytes_refused("# an OBJ file\n", "no OpenVDB file");
    folder.check_bytes_refused(testing::nifti_int16({4, 4, 4}, [](int, int, int) { return 1; }), "no OpenVDB file");
    CHECK_THROWS_WITH(read_vdb(folder.at("none.vdb")), Catch::Contains("none.vdb: ") && Catch::Contains("; "));
    CHECK_THROWS_WITH(read_vdb(folder.at("")), Catch::Contains("folder"));

    const std::string whole = folder.bytes_of({box_of_numbers("density")});
    std::string newer = whole;
    newer[9] = 1;  // a byte of the format's number, which follows the 8 bytes that tell the kind of file
    folder.check_bytes_refused(newer, "the file's format is 480, and 220 to 224 are read; write it anew");
    std::string older = whole;
    older[8] = 100;
    folder.check_bytes_refused(older, "the file's format is 100,");
    std::string unknown = whole;
    unknown.replace(unknown.find("Tree_float"), 10, "Tree_fruit");
    folder.check_bytes_refused(unknown, "OpenVDB cannot read the file: LookupError: ");

    std::ostringstream stream;
    openvdb::io::Stream(stream).write({box_of_numbers("density")});
    folder.check_bytes_refused(stream.str(), "a stream that does not say");
}

TEST_CASE("a VDB file is an input that no output may replace", "[vdb]")
{
    const VdbFolder folder;
    const std::filesystem::path file = folder.write({box_of_numbers("density")});
    const FileGuard guard;
    read_vdb(file);
    CHECK_THROWS_AS(require_no_input(file), FileClash);
}

// Smoke that ends one voxel before the border of 13 x 11 x 15.
constexpr std::array<int16_t, 3> kSmokeSides = {13, 11, 15};

int smoke(int x, int y, int z)
{
    const auto inside = [](int at, int16_t side) { return at > 0 && at < side - 1; };
    return inside(x, kSmokeSides[0]) && inside(y, kSmokeSides[1]) && inside(z, kSmokeSides[2]) ? 9 + x + 7 * y + z * z
                                                                                               : 0;
}

TEST_CASE("the same smoke as NIfTI and as VDB is the same volume of a scene", "[vdb]")
{
    const VdbFolder folder;
    folder.write_file("smoke.nii", testing::nifti_int16(kSmokeSides, smoke));
    const FloatGrid::Ptr written = FloatGrid::create();
    written->setTransform(Transform::createLinearTransform(2));  // mm a voxel, as nifti_int16() has it
    for (int z = 1; z < kSmokeSides[2] - 1; ++z) {
        for (int y = 1; y < kSmokeSides[1] - 1; ++y)
            for (int x = 1; x < kSmokeSides[0] - 1; ++x)
                written->tree().setValue({x, y, z}, static_cast<float>(smoke(x, y, z)));
    }
    folder.write({written});
    const auto grid_of = [&](const std::string& file) {
        const std::string json = R"({"volume": {"file": ")" + file + R"(", "rotate": [0, 0, 20],
            "transfer": [{"value": 0, "density": 0}, {"value": 200, "density": 1}]}})";
        std::vector<std::string> warnings;
        return read_scene_file(folder.write_file("s.json", json), std::nullopt, warnings).volume->grid;
    };
    const Grid nifti = grid_of("smoke.nii"), vdb = grid_of("g.vdb");
    CHECK((vdb.nx == nifti.nx && vdb.ny == nifti.ny && vdb.nz == nifti.nz));
    CHECK(vdb.values == nifti.values);
    CHECK(vdb.voxel_to_world == nifti.voxel_to_world);
}

TEST_CASE("a VDB file is a scene by its iso-surface, as an argument and as an object", "[vdb]")
{
    const VdbFolder folder;
    const std::filesystem::path file = folder.write({box_of_numbers("density")});
    CHECK(is_volume_file(file));
    CHECK_FALSE(is_volume_file("g.vdb.gz"));
    std::vector<std::string> warnings;
    LoadOptions options;
    CHECK_THROWS_WITH(load_scene(file, options, warnings), Catch::Contains("--iso, from 0 to 60"));
    options.iso = {30, 0};
    CHECK(load_scene(file, options, warnings).up() == UpAxis::z);
    const std::string json = R"({"objects": [{"volume": "g.vdb", "iso": 30}]})";
    CHECK_NOTHROW(load_scene(folder.write_file("s.json", json), {}, warnings));
    CHECK(warnings.empty());
}

}  // namespace
}  // namespace lumi::baker
