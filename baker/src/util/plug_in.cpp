// SPDX-License-Identifier: MIT
#include "lumi/baker/plug_in.h"

#include <dlfcn.h>

#include <filesystem>

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;

fs::path folder_of_program()
{
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    // A name without its folder would be sought in the working directory, and by LD_LIBRARY_PATH.
    if (!program.is_absolute())
        throw NoPlugIn("/proc/self/exe", "cannot be read, so nobody knows where the modules of lumi lie");
    return program.parent_path();
}

fs::path path_of(const std::string& file, const std::string& part)
{
    const fs::path beside = folder_of_program() / file, installed = folder_of_program() / LUMI_MODULE_FOLDER / file;
    std::error_code unknown;
    for (const fs::path& path : {beside, installed})
        if (fs::exists(path, unknown)) return path;
    throw NoPlugIn(beside.string(), "lumi was built without " + part);
}

}  // namespace

void* symbol_of_plug_in(const std::string& file, const char* symbol, const std::string& part)
{
    const fs::path path = path_of(file, part);
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw NoPlugIn(path.string(), std::string("does not load: ") + dlerror());
    void* const address = dlsym(library, symbol);
    if (address == nullptr) throw NoPlugIn(path.string(), "is no module of this version of lumi");
    return address;
}

}  // namespace lumi::baker
