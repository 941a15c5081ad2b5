// SPDX-License-Identifier: MIT
#include "volume/openvdb.h"

#include "lumi/baker/plug_in.h"
#include "lumi/baker/scene.h"
#include "util/text_lines.h"
#include "volume/openvdb_module.h"

namespace lumi::baker
{
namespace
{

const OpenvdbModule& open_module()
{
    try {
        using Entry = const OpenvdbModule* (*)();
        return *reinterpret_cast<Entry>(symbol_of_plug_in(kOpenvdbModuleFile, kOpenvdbModuleSymbol, "OpenVDB"))();
    } catch (const NoPlugIn& none) {
        throw SceneError(
            std::string(none.what()) +
            "; .vdb files and iso-surfaces take it: install OpenVDB (Debian: libopenvdb-dev libboost-dev), then "
            "configure and build lumi again");
    }
}

const OpenvdbModule& module()
{
    static const OpenvdbModule& loaded = open_module();
    return loaded;
}

}  // namespace

Polygons dual_contour(const Grid& grid, float value)
{
    return module().dual_contour(grid, value);
}

Grid read_vdb(const std::filesystem::path& file)
{
    auto stream = open_file(file);
    return module().read(stream, file.string());
}

}  // namespace lumi::baker
