// SPDX-License-Identifier: MIT
#include "viewer/modules.h"

#include <cstdint>

// From modules.S.
extern "C" const char lumi_surface_module[], lumi_chord_module[];
extern "C" const uint32_t lumi_surface_module_bytes, lumi_chord_module_bytes;

namespace lumi::tools
{

std::string_view surface_module()
{
    return {lumi_surface_module, lumi_surface_module_bytes};
}

std::string_view chord_module()
{
    return {lumi_chord_module, lumi_chord_module_bytes};
}

}  // namespace lumi::tools
