// SPDX-License-Identifier: MIT
#include "mesh/cut_outs.h"

#include "material/texture_slot.h"
#include "mesh/sheets.h"

namespace lumi::baker
{
namespace
{

constexpr float kCell = 1.0f / 120;       // radii: a pixel
constexpr uint32_t kMaxCells = 64;        // along a side of a triangle
constexpr double kMaxAllCells = 1 << 20;  // in all triangles together
constexpr float kHalf = 0.5f;
constexpr uint32_t kCellSteps = 16;  // steps along a cell's side: pieces of neighbouring triangles meet exactly

// A place on a triangle: shares of its corners, in steps of a cell; they sum to cells × kCellSteps.
using CellPlace = std::array<uint32_t, 3>;

// The opacity that one triangle's picture shows at the corners of cells.
class OpacityGrid
{
public:
    OpacityGrid(const SceneData& scene, uint32_t triangle, uint32_t cells)
    {
        const TextureSlot& slot = scene.materials[scene.mesh.materials[triangle]].maps.opacity;
        const auto share = [&](uint32_t k) { return static_cast<float>(k) / static_cast<float>(cells); };
        for (uint32_t j = 0; j <= cells; ++j) {
            rows_.push_back(values_.size());
            for (uint32_t i = 0; i + j <= cells; ++i)
                values_.push_back(slot_colour(scene.mesh, scene.textures, slot, triangle, {share(i), share(j)}).g);
        }
    }

    float at(uint32_t i, uint32_t j) const { return values_[rows_[j] + i]; }
    bool is_whole() const { return *std::min_element(values_.begin(), values_.end()) >= kHalf; }
    // Counts every second cell: neighbours are cut together.
    uint32_t cut_cells() const
    {
        uint32_t count = 0;
        for (uint32_t j = 0; j + 1 < rows_.size(); ++j) {
            for (uint32_t i = 0; i + j + 1 < rows_.size(); ++i) {
                const bool in = at(i, j) >= kHalf;
                count += in != (at(i + 1, j) >= kHalf) || in != (at(i, j + 1) >= kHalf) ? 1u : 0u;
            }
        }
        return count;
    }

private:
    std::vector<size_t> rows_;  // where they begin
    std::vector<float> values_;
};

class Cutter
{
public:
    Cutter(const SceneData& scene, uint32_t triangle, uint32_t cells, Mesh& result)
        : scene_(scene), triangle_(triangle), cells_(cells), grid_(scene, triangle, cells), result_(result)
    {
    }

    void cut()
    {
        for (uint32_t j = 0; j < cells_; ++j) {
            for (uint32_t i = 0; i + j < cells_; ++i) {
                cut_cell({{{i, j}, {i + 1, j}, {i, j + 1}}});
                if (i + j + 1 < cells_) cut_cell({{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}});
            }
        }
    }

private:
    using Node = std::array<uint32_t, 2>;

    // Sutherland and Hodgman's clipping, at the one line.
    void cut_cell(const std::array<Node, 3>& cell)
    {
        std::array<CellPlace, 4> kept;
        size_t count = 0;
        for (size_t k = 0; k < 3; ++k) {
            const Node &a = cell[k], &b = cell[(k + 1) % 3];
            const bool a_in = value(a) >= kHalf, b_in = value(b) >= kHalf;
            if (a_in) kept[count++] = between(a, b, 0);
            if (a_in != b_in) kept[count++] = a_in ? crossing(a, b) : crossing(b, a);
        }
        for (size_t k = 2; k < count; ++k) add(kept[0], kept[k - 1], kept[k]);
    }

    float value(const Node& n) const { return grid_.at(n[0], n[1]); }
    CellPlace between(const Node& a, const Node& b, uint32_t steps) const
    {
        const uint32_t second = a[0] * (kCellSteps - steps) + b[0] * steps,
                       third = a[1] * (kCellSteps - steps) + b[1] * steps;
        return {cells_ * kCellSteps - second - third, second, third};
    }
    CellPlace crossing(const Node& inside, const Node& outside) const
    {
        const float share = (value(inside) - kHalf) / (value(inside) - value(outside));
        const auto steps = static_cast<uint32_t>(share * kCellSteps + 0.5f);
        return between(inside, outside, std::clamp(steps, 1u, kCellSteps - 1));
    }

    // Both triangles beside an edge give the same bits.
    Vec3 position(const CellPlace& place) const
    {
        std::array<std::pair<uint32_t, uint32_t>, 3> terms;  // vertex, share
        for (size_t k = 0; k < 3; ++k) terms[k] = {scene_.mesh.corners[triangle_][k], place[k]};
        std::sort(terms.begin(), terms.end());
        Vec3 sum;
        for (const auto& [vertex, share] : terms) {
            sum = sum +
                  scene_.mesh.positions[vertex] * (static_cast<float>(share) / static_cast<float>(cells_ * kCellSteps));
        }
        return sum;
    }

    void add(const CellPlace& a, const CellPlace& b, const CellPlace& c)
    {
        const auto first = static_cast<uint32_t>(result_.positions.size());
        for (const CellPlace& place : {a, b, c}) result_.positions.push_back(position(place));
        result_.corners.push_back({first, first + 1, first + 2});
    }

    const SceneData& scene_;
    const uint32_t triangle_, cells_;
    const OpacityGrid grid_;
    Mesh& result_;
};

bool has_picture(const SceneData& scene, uint32_t triangle)
{
    const TextureSlot& slot = scene.materials[scene.mesh.materials[triangle]].maps.opacity;
    return slot.used() && corner_uvs(scene.mesh, slot, triangle).has_value();
}

float longest_side(const Mesh& mesh, uint32_t k)
{
    return std::max({length(mesh.position(k, 1) - mesh.position(k, 0)),
                     length(mesh.position(k, 2) - mesh.position(k, 1)),
                     length(mesh.position(k, 0) - mesh.position(k, 2))});
}

// Cells along each side, 0 for triangles without a picture. Triangles beside each other get the same number, so that
// their pieces meet.
std::vector<uint32_t> cells_of(const SceneData& scene, const Sheets& sheets)
{
    const auto triangles = static_cast<uint32_t>(scene.mesh.triangle_count());
    std::vector<float> longest(triangles, 0);  // by sheet
    for (uint32_t k = 0; k < triangles; ++k) {
        float& side = longest[sheets.of(k).sheet];
        side = has_picture(scene, k) ? std::max(side, longest_side(scene.mesh, k)) : side;
    }
    std::vector<uint32_t> cells(triangles, 0);
    double all = 0;
    for (uint32_t k = 0; k < triangles; ++k) {
        if (has_picture(scene, k)) {
            const float wanted = std::ceil(longest[sheets.of(k).sheet] / kCell);
            cells[k] = static_cast<uint32_t>(std::clamp(wanted, 1.0f, static_cast<float>(kMaxCells)));
            all += cells[k] * static_cast<double>(cells[k]);
        }
    }
    const double scale = std::min(1.0, std::sqrt(kMaxAllCells / std::max(all, 1.0)));
    for (uint32_t& c : cells) c = c == 0 ? 0 : std::max(1u, static_cast<uint32_t>(c * scale));
    return cells;
}

bool has_pictures(const SceneData& scene)
{
    return std::any_of(
        scene.materials.begin(), scene.materials.end(), [](const Material& m) { return m.maps.opacity.used(); });
}

}  // namespace

std::vector<float> cut_lengths(const SceneData& scene)
{
    std::vector<float> lengths(scene.materials.size(), 0);
    if (!has_pictures(scene)) return lengths;
    const std::vector<uint32_t> cells = cells_of(scene, Sheets(scene.mesh));
    for (uint32_t k = 0; k < cells.size(); ++k) {
        if (cells[k] == 0) continue;
        const float cell = std::sqrt(2 * scene.mesh.area(k)) / static_cast<float>(cells[k]);  // about its side
        lengths[scene.mesh.materials[k]] += cell * static_cast<float>(OpacityGrid(scene, k, cells[k]).cut_cells());
    }
    return lengths;
}

std::optional<Mesh> cut_out(const SceneData& scene)
{
    if (!has_pictures(scene)) return std::nullopt;
    const Sheets sheets(scene.mesh);
    const std::vector<uint32_t> cells = cells_of(scene, sheets);
    std::vector<uint8_t> is_cut(cells.size(), 0);  // by sheet
    Mesh result;
    result.positions = scene.mesh.positions;
    for (uint32_t k = 0; k < cells.size(); ++k)
        if (cells[k] != 0 && !OpacityGrid(scene, k, cells[k]).is_whole()) is_cut[sheets.of(k).sheet] = 1;
    for (uint32_t k = 0; k < cells.size(); ++k)
        if (cells[k] != 0 && is_cut[sheets.of(k).sheet] != 0)
            Cutter(scene, k, cells[k], result).cut();
        else
            result.corners.push_back(scene.mesh.corners[k]);
    return result;
}

}  // namespace lumi::baker
