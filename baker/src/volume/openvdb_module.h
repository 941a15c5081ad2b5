// SPDX-License-Identifier: MIT
// The module that links OpenVDB, as the program sees it.
#pragma once

#include <istream>
#include <string>

#include "volume/openvdb.h"

namespace lumi::baker
{

struct OpenvdbModule {
    // As read_vdb(), of a file that is open; `name` is the file's.
    Grid (*read)(std::istream& stream, const std::string& name);
    Polygons (*dual_contour)(const Grid& grid, float value);
};

inline constexpr char kOpenvdbModuleFile[] = "lumi_openvdb.so";
// The module's one symbol: a function of no arguments that returns a pointer to an OpenvdbModule, which lives as long
// as the program.
inline constexpr char kOpenvdbModuleSymbol[] = "lumi_openvdb_module";

}  // namespace lumi::baker
