// SPDX-License-Identifier: MIT
// Triangles of one material, as STL and PLY have them.
#pragma once

#include <filesystem>

#include "model/losses.h"
#include "model/scene_parts.h"
#include "model/vertices.h"

namespace lumi::baker
{

struct Facets {
    std::vector<Point> positions;          // none exceeds kMaxCoordinate
    std::vector<Vec3> normals;             // they have any length; empty, or one a position, as the next one
    std::vector<Rgb> colours;              // linear, 0 to 1
    std::vector<Mesh::Corners> triangles;  // in range
};

// The material is grey unless there are colours, and is named as the file without its end. Without normals, facets that
// turn less than 30 degrees at an edge are smooth there; facets at one place share it, however often it is given.
// Throws SceneError where no triangle has an area.
SceneParts parts_of_facets(const std::filesystem::path& file, Facets facets, Losses& losses);

}  // namespace lumi::baker
