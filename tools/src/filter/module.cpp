// SPDX-License-Identifier: MIT
#include "filter/module.h"

#include "lumi/baker/plug_in.h"
#include "terminal/failure.h"

namespace lumi::filter
{

namespace
{

Module& open_module()
{
    using Entry = Module* (*)();
    try {
        return *reinterpret_cast<Entry>(
            baker::symbol_of_plug_in("lumi_filter.so", kModuleSymbol, "its learned filter"))();
    } catch (const baker::NoPlugIn& none) {
        throw tools::Failure(none.path, none.problem,
                             "install libtorch (Debian: libtorch-dev), then configure and build lumi again");
    }
}

}  // namespace

Module& load_module()
{
    static Module& module = open_module();
    return module;
}

}  // namespace lumi::filter
