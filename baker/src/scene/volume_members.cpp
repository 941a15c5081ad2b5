// SPDX-License-Identifier: MIT
#include "scene/scene_members.h"

#include "model/materials.h"
#include "scene/placement.h"
#include "volume/volume_file.h"

namespace lumi::baker
{
namespace
{

constexpr NumberRange kDensity = {0, 1e9};
constexpr NumberRange kMeanCosine = {-0.95, 0.95};

TransferPoint read_point(const std::string& file, const JsonValue& value)
{
    JsonMembers members(file, value, "a point of 'transfer'");
    TransferPoint point = {0, grey(1), 0};
    point.value = static_cast<float>(members.number_of(members.require("value"), "value", kScalar));
    point.density = static_cast<float>(members.number_of(members.require("density"), "density", kDensity));
    members.colour("colour", kShare, point.colour);
    members.finish();
    return point;
}

TransferFunction read_transfer(const std::string& file, JsonMembers& volume)
{
    const JsonValue& list = volume.require("transfer");
    if (list.kind != JsonValue::Kind::list || list.items.empty())
        volume.fail(list, "'transfer' must be a list of points; write [ { \"value\": 1, \"density\": 2 } ]");
    std::vector<TransferPoint> points;
    for (const JsonValue& item : list.items) {
        points.push_back(read_point(file, item));
        if (points.size() > 1 && !(points.back().value > points[points.size() - 2].value)) {
            volume.fail(item,
                        "'value' must grow from point to point of 'transfer'; sort the points, and move apart "
                        "those with the same value");
        }
    }
    return TransferFunction(std::move(points));
}

}  // namespace

Volume read_volume(const std::filesystem::path& scene_file, const JsonValue& value)
{
    const std::string name = scene_file.string();
    JsonMembers members(name, value, "the volume");
    const JsonValue& grid = members.require("file");
    const std::filesystem::path path = find_beside(scene_file, members.text_of(grid, "file"));
    if (path.empty())
        members.fail(grid,
                     "the volume '" + grid.text + "' is missing; put it beside " + scene_file.filename().string());
    const TransferFunction transfer = read_transfer(name, members);
    float anisotropy = 0;
    members.number("anisotropy", kMeanCosine, anisotropy);
    const Placement placement = read_placement(members);
    members.finish();
    Volume volume = {read_grid(path), transfer, anisotropy};
    volume.grid.voxel_to_world = combined(affine_of(placement), volume.grid.voxel_to_world);
    if (corners_of(volume).empty()) {
        members.fail(members.require("transfer"), "'transfer' gives density 0 to all values of '" + grid.text + "', " +
                                                      range_of(volume.grid) + "; give some of them more");
    }
    return volume;
}

}  // namespace lumi::baker
