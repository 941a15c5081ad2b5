// SPDX-License-Identifier: MIT
// Finds the module that computes filters, where this program was built with one.
#pragma once

#include <string>

#include "filter/network.h"

namespace lumi::filter
{

// The module's one symbol: a function of no arguments that returns a Module, which lives as long as the program.
inline constexpr char kModuleSymbol[] = "lumi_filter_module";

// Loads the module from beside the program, or from where `cmake --install` puts it. Throws Failure where it is not
// there or does not load: it names libtorch's package. Cost: a second, the first time.
Module& load_module();

}  // namespace lumi::filter
