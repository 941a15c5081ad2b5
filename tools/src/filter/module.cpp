// SPDX-License-Identifier: MIT
#include "filter/module.h"

#include <dlfcn.h>

#include <filesystem>

#include "terminal/failure.h"

namespace lumi::filter
{

namespace
{

namespace fs = std::filesystem;

constexpr char kFileName[] = "lumi_filter.so";
constexpr char kTorchMend[] = "install libtorch (Debian: libtorch-dev), then configure and build lumi again";

fs::path folder_of_program()
{
    std::error_code unknown;
    return fs::read_symlink("/proc/self/exe", unknown).parent_path();
}

fs::path module_path()
{
    const fs::path beside = folder_of_program() / kFileName;
    const fs::path installed = folder_of_program() / LUMI_MODULE_FOLDER / kFileName;
    std::error_code unknown;
    for (const fs::path& path : {beside, installed})
        if (fs::exists(path, unknown)) return path;
    throw tools::Failure(beside.string(), "lumi was built without its learned filter", kTorchMend);
}

Module& open_module()
{
    const fs::path path = module_path();
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw tools::Failure(path.string(), std::string("does not load: ") + dlerror(), kTorchMend);
    using Entry = Module* (*)();
    const auto entry = reinterpret_cast<Entry>(dlsym(library, kModuleSymbol));
    if (entry == nullptr) throw tools::Failure(path.string(), "is no filter of this version of lumi", kTorchMend);
    return *entry();
}

}  // namespace

Module& load_module()
{
    static Module& module = open_module();
    return module;
}

}  // namespace lumi::filter
