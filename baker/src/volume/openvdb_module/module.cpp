// SPDX-License-Identifier: MIT
// The one file that sees OpenVDB. It is a module of its own: OpenVDB brings libraries that start threads and take
// time whenever a program that links them starts.
#include "volume/volume_file.h"

// Its headers are not written for our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/VolumeToMesh.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"
#include "volume/grid.h"

namespace lumi::baker
{
namespace
{

using openvdb::FloatGrid;
using openvdb::io::GridDescriptor;

// Outside the grid lies this: so far below any value that the cut at its border is flat.
constexpr float kOutside = -1e30f;

constexpr char kPreferred[] = "density";

constexpr char kEndsEarly[] = "the file ends too early; copy it again";

// Reads a file by the parts of OpenVDB's reader that take a stream. Its own class for files goes on where a file ends
// too early, with whatever memory holds; our stream throws there.
class VdbReader : private openvdb::io::Archive
{
public:
    // `stream` throws std::ios_base::failure.
    VdbReader(std::string name, std::istream& stream) : name_(std::move(name)), stream_(stream)
    {
        stream_.seekg(0, std::ios::end);
        size_ = stream_.tellg();
        read_head();
        read_descriptors();
    }

    Grid read()
    {
        const GridDescriptor& chosen = choose();
        check_head(chosen);
        return dense(*sparse(chosen));
    }

private:
    [[noreturn]] void fail(const std::string& text) const { throw SceneError(at({name_}, text)); }

    // The grid's name in a message.
    static std::string quoted(const GridDescriptor& grid) { return "'" + grid.gridName() + "'"; }

    // Looks before OpenVDB does, which warns on stderr of what is newer, and takes what is older for something else.
    void check_format()
    {
        constexpr uint32_t kOldest = openvdb::OPENVDB_FILE_VERSION_SELECTIVE_COMPRESSION;
        constexpr uint32_t kNewest = openvdb::OPENVDB_FILE_VERSION;
        int64_t magic = 0;
        uint32_t format = 0;
        stream_.seekg(0);
        stream_.read(reinterpret_cast<char*>(&magic), sizeof magic);
        if (magic != openvdb::OPENVDB_MAGIC)
            fail("this is no OpenVDB file; name a .vdb file, or a NIfTI file, .nii or .nii.gz");
        stream_.read(reinterpret_cast<char*>(&format), sizeof format);
        if (format < kOldest || format > kNewest) {
            fail("the file's format is " + std::to_string(format) + ", and " + std::to_string(kOldest) + " to " +
                 std::to_string(kNewest) + " are read; write it anew as one of them");
        }
        stream_.seekg(0);
    }

    void read_head()
    {
        check_format();
        openvdb::initialize();
        metadata_->setSeekable(true);
        openvdb::io::setStreamMetadataPtr(stream_, metadata_, false);
        readHeader(stream_);
        setFormatVersion(stream_);
        setLibraryVersion(stream_);
        setDataCompression(stream_);
        if (!inputHasGridOffsets())
            fail("the file is a stream that does not say where its grids begin; write it with openvdb::io::File");
        openvdb::MetaMap().readMeta(stream_);
    }

    void read_descriptors()
    {
        for (int32_t left = readGridCount(stream_); left > 0; --left) {
            GridDescriptor grid;
            grid.read(stream_);
            if (grid.getEndPos() > size_) fail(kEndsEarly);
            if (grid.getEndPos() < stream_.tellg()) fail("the file's list of grids is damaged; copy it again");
            grids_.push_back(grid);
            grid.seekToEnd(stream_);
        }
    }

    const GridDescriptor& choose() const
    {
        const GridDescriptor* last = nullptr;
        std::vector<std::string> all, names;  // names: of grids of floats
        for (const GridDescriptor& grid : grids_) {
            all.push_back(quoted(grid) + " (" + grid.gridType() + ")");
            if (grid.gridType() != FloatGrid::gridType()) continue;
            if (grid.gridName() == kPreferred) return grid;
            last = &grid;
            names.push_back(quoted(grid));
        }
        if (last == nullptr) {
            fail("no grid of floats is in the file" + (all.empty() ? "" : ", only " + joined(all, ", ")) +
                 "; write one of the name 'density'");
        }
        if (names.size() > 1) {
            fail(std::to_string(names.size()) + " grids of floats are in the file, " + joined(names, ", ") +
                 "; give the name 'density' to the one that is meant");
        }
        return *last;
    }

    // These checks come before the grid's tree takes memory.
    void check_head(const GridDescriptor& grid)
    {
        const FloatGrid::Ptr head = FloatGrid::create();
        grid.seekToGrid(stream_);
        readGridCompression(stream_);
        head->readMeta(stream_);
        head->readTransform(stream_);
        if (!head->transform().isLinear()) {
            fail("the grid " + quoted(grid) + " lies in space by a frustum or another map that bends it (" +
                 head->transform().mapType() + "); resample it onto an affine one");
        }
        using Corner = openvdb::Vec3IMetadata;
        const auto low = head->getMetadata<Corner>(openvdb::GridBase::META_FILE_BBOX_MIN);
        const auto high = head->getMetadata<Corner>(openvdb::GridBase::META_FILE_BBOX_MAX);
        if (low && high) checked_size(openvdb::CoordBBox(openvdb::Coord(low->value()), openvdb::Coord(high->value())));
    }

    // The sides of the active voxels' box with a border of one voxel. Refuses boxes beyond the limits.
    std::array<int64_t, 3> checked_size(const openvdb::CoordBBox& active) const
    {
        constexpr int kFarthest = 1 << 30;  // so that a border does not overflow
        std::array<int64_t, 3> sides = {};
        for (size_t k = 0; k < 3; ++k) {
            const int64_t first = active.min()[k], last = active.max()[k];
            if (last < first) fail("the grid is empty: none of its voxels is active; write one that holds something");
            if (first < -kFarthest || last > kFarthest) {
                fail("voxels lie more than " + std::to_string(kFarthest) +
                     " from the grid's origin; move them by its transform");
            }
            sides[k] = last - first + 3;
        }
        require_size(name_, sides);
        return sides;
    }

    FloatGrid::Ptr sparse(const GridDescriptor& grid)
    {
        const FloatGrid::Ptr result = FloatGrid::create();
        result->setSaveFloatAsHalf(grid.saveFloatAsHalf());
        grid.seekToGrid(stream_);
        readGrid(result, grid, stream_);
        if (grid.isInstance()) result->setTree(sparse(owner_of(grid))->treePtr());
        return result;
    }

    // Grids may share a tree, which one of them holds.
    const GridDescriptor& owner_of(const GridDescriptor& instance) const
    {
        for (const GridDescriptor& grid : grids_)
            if (grid.uniqueName() == instance.instanceParentName() && grid.gridType() == FloatGrid::gridType() &&
                !grid.isInstance())
                return grid;
        fail("the grid " + quoted(instance) +
             " shares the voxels of one that is not in the file; write it without instances");
    }

    Grid dense(const FloatGrid& sparse) const
    {
        openvdb::CoordBBox box = sparse.evalActiveVoxelBoundingBox();
        const std::array<int64_t, 3> sides = checked_size(box);
        box.expand(1);
        const Affine place = voxel_to_world(sparse.transform(), box.min());
        require_place(name_, place, "transform");
        std::vector<float> values(static_cast<size_t>(sides[0] * sides[1] * sides[2]));
        openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> view(box, values.data());
        openvdb::tools::copyToDense(sparse, view);
        check_values(values, box);
        if (sparse.getGridClass() == openvdb::GRID_LEVEL_SET)
            std::transform(values.begin(), values.end(), values.begin(), std::negate<>());
        return {static_cast<uint32_t>(sides[0]), static_cast<uint32_t>(sides[1]), static_cast<uint32_t>(sides[2]),
                std::move(values), place};
    }

    // The map for a grid whose first voxel is `first`.
    static Affine voxel_to_world(const openvdb::math::Transform& transform, const openvdb::Coord& first)
    {
        const auto map = transform.baseMap();
        const openvdb::Vec3d columns[] = {map->applyJacobian({1, 0, 0}), map->applyJacobian({0, 1, 0}),
                                          map->applyJacobian({0, 0, 1}), map->applyMap(first.asVec3d())};
        Affine result;
        for (size_t c = 0; c < 4; ++c)
            for (size_t r = 0; r < 3; ++r) result[r][c] = columns[c][static_cast<int>(r)];
        return result;
    }

    void check_values(const std::vector<float>& values, const openvdb::CoordBBox& box) const
    {
        const auto odd = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
        if (odd != values.end()) {
            const auto place = static_cast<int>(odd - values.begin());
            const openvdb::Coord n = box.dim();
            const openvdb::Coord voxel =
                box.min().offsetBy(place % n.x(), place / n.x() % n.y(), place / n.x() / n.y());
            fail("the voxel at " + std::to_string(voxel.x()) + ", " + std::to_string(voxel.y()) + ", " +
                 std::to_string(voxel.z()) + " holds " + std::to_string(*odd) + "; write finite numbers");
        }
    }

    const std::string name_;
    std::istream& stream_;
    int64_t size_ = 0;  // bytes
    // The stream keeps its address.
    openvdb::SharedPtr<openvdb::io::StreamMetadata> metadata_{new openvdb::io::StreamMetadata};
    std::vector<GridDescriptor> grids_;
};

Polygons contour(const Grid& grid, float value)
{
    FloatGrid volume(kOutside);
    FloatGrid::Accessor voxels = volume.getAccessor();
    const float* at = grid.values.data();
    for (int z = 0; z < static_cast<int>(grid.nz); ++z) {
        for (int y = 0; y < static_cast<int>(grid.ny); ++y)
            for (int x = 0; x < static_cast<int>(grid.nx); ++x) voxels.setValue({x, y, z}, *at++);
    }
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(volume, points, triangles, quads, static_cast<double>(value));
    Polygons result;
    for (const openvdb::Vec3s& p : points) result.points.push_back({p[0], p[1], p[2]});
    for (const openvdb::Vec3I& t : triangles) result.triangles.push_back({t[0], t[1], t[2]});
    for (const openvdb::Vec4I& q : quads) result.quads.push_back({q[0], q[1], q[2], q[3]});
    return result;
}

Grid read_stream(std::istream& stream, const std::string& name)
{
    try {
        stream.exceptions(std::ios::failbit | std::ios::badbit);
        return VdbReader(name, stream).read();
    } catch (const SceneError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw SceneError(
            at({name}, "reading takes more memory than there is; free some, or copy a damaged file again"));
    } catch (const std::ios_base::failure&) {
        throw SceneError(at({name}, kEndsEarly));
    } catch (const std::exception& error) {  // openvdb::Exception, and what its parts of Boost throw
        throw SceneError(at({name}, std::string("OpenVDB cannot read the file: ") + error.what() +
                                        "; write it anew, or copy it again"));
    }
}

}  // namespace
}  // namespace lumi::baker

extern "C" __attribute__((visibility("default"))) const lumi::baker::OpenvdbModule* lumi_openvdb_module()
{
    static const lumi::baker::OpenvdbModule module = {lumi::baker::read_stream, lumi::baker::contour};
    return &module;
}
