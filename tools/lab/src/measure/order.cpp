// SPDX-License-Identifier: MIT
// lumi-lab order: how many layers of a surface field's see-through patches are drawn the wrong way round.
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "files/field_file.h"
#include "geometry/drawing_order.h"
#include "measure/commands.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

// See-through triangles, and their patches from 0 on.
struct Layers {
    baker::Mesh mesh;
    std::vector<uint32_t> patch_of;
};

Layers layers_of(const SeeThroughField& field)
{
    constexpr float kOne = 16384;  // Q14
    Layers layers;
    for (uint32_t k = 0; k < field.vertex_count; ++k) {
        const detail::VertexQ14 v = detail::surface_vertex(field, k);
        layers.mesh.positions.push_back(
            {static_cast<float>(v.x) / kOne, static_cast<float>(v.y) / kOne, static_cast<float>(v.z) / kOne});
    }
    for (uint32_t k = 0; k < field.see_through_count; ++k) {
        const detail::SurfacePatch patch = detail::surface_patch(field, field.patch_count + k);
        const uint32_t* const corner = patch.corner;
        layers.mesh.corners.push_back({corner[0], corner[1], corner[2]});
        layers.patch_of.push_back(k);
        if (corner[3] == detail::format::kNoVertex) continue;
        layers.mesh.corners.push_back({corner[3], corner[2], corner[1]});
        layers.patch_of.push_back(k);
    }
    return layers;
}

Json percent(double share)
{
    return hundredths(100 * share);
}

Json order_of(const std::string& path)
{
    const tools::FieldFile file(path);
    file.require_intact();
    if (!file.is_surface() || file.surface().see_through_count == 0)
        throw std::runtime_error(path + ": has no see-through patches; bake a scene that has such parts");
    const Layers layers = layers_of(file.surface());
    std::vector<uint32_t> order(file.surface().see_through_count);
    std::iota(order.begin(), order.end(), 0u);
    baker::Job job(1, 0, {});
    const baker::OrderFaults faults = order_faults({layers.mesh, layers.patch_of}, order, job);
    return {{"field", path},
            {"triangles", layers.mesh.triangle_count()},
            {"drawn", file.surface().is_in_order ? "in order" : "by depth"},
            {"pairs", faults.pairs},
            {"wrong_in_order_percent", percent(faults.in_order)},
            {"wrong_by_depth_percent", percent(faults.by_depth)}};
}

}  // namespace

void add_order(CLI::App& lab)
{
    auto fields = std::make_shared<std::vector<std::string>>();
    CLI::App* command =
        lab.add_subcommand("order", "Tell how many layers of see-through patches are drawn the wrong way round");
    command->add_option("FIELD", *fields, "Surface fields with see-through patches")->required();
    command->callback([fields] {
        Json rows = Json::array();
        for (const std::string& path : *fields) rows.push_back(order_of(path));
        print(rows);
    });
}

}  // namespace lumi::lab
