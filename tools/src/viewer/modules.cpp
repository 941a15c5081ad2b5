// SPDX-License-Identifier: MIT
#include "viewer/modules.h"

#include <cstddef>

// From modules.S.
extern "C" const char lumi_surface_module[], lumi_surface_module_end[], lumi_chord_module[], lumi_chord_module_end[];

namespace lumi::tools
{

std::string_view surface_module()
{
    return {lumi_surface_module, static_cast<size_t>(lumi_surface_module_end - lumi_surface_module)};
}

std::string_view chord_module()
{
    return {lumi_chord_module, static_cast<size_t>(lumi_chord_module_end - lumi_chord_module)};
}

}  // namespace lumi::tools
