// SPDX-License-Identifier: MIT
#include "volume/volume_file.h"

#include <algorithm>

#include "lumi/baker/plug_in.h"
#include "lumi/baker/scene.h"
#include "util/text_lines.h"
#include "volume/nifti_file.h"

namespace lumi::baker
{

namespace
{

bool is_vdb(const std::filesystem::path& file)
{
    return file.extension() == ".vdb";
}

}  // namespace

bool is_volume_file(const std::filesystem::path& file)
{
    const std::filesystem::path inner = file.extension() == ".gz" ? file.stem() : file;
    return is_vdb(file) || inner.extension() == ".nii";
}

void refuse_foreign_volume(const std::filesystem::path& file)
{
    const std::filesystem::path end = file.extension();
    const bool dicom = end == ".dcm";
    if (!dicom && end != ".nrrd" && end != ".nhdr" && end != ".mha" && end != ".mhd") return;
    const std::string whole = dicom ? "FOLDER" : file.string();
    throw SceneError(
        at({file.string()}, "volumes are read from .nii, .nii.gz and .vdb; Debian's plastimatch converts this " +
                                std::string(dicom ? "series" : "file") + ": plastimatch convert --input " + whole +
                                " --output-img volume.nii.gz"));
}

Grid read_grid(const std::filesystem::path& file)
{
    refuse_foreign_volume(file);
    return is_vdb(file) ? read_vdb(file) : read_nifti(file);
}

std::string range_of(const Grid& grid)
{
    const auto [least, most] = std::minmax_element(grid.values.begin(), grid.values.end());
    return number_text(*least) + " to " + number_text(*most);
}

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
